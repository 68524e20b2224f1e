// ballpark profile: where the time goes, and what more threads give.
#include <fmt/format.h>

#include <algorithm>

#include "ballpark/scenes.h"
#include "perf/machine.h"
#include "scenarios/command/commands.h"
#include "scenarios/command/deliver.h"
#include "scenarios/command/measure.h"
#include "scenarios/command/scene_options.h"
#include "scenarios/command/terminal.h"
#include "scenarios/command/text.h"

namespace ballpark::command {
namespace {

constexpr Column::Align right = Column::Align::right, wrap = Column::Align::wrap;

std::string percent(double share) {
  return fmt::format("{:.1f} %", 100 * share);
}
std::string gigabytes(double per_second) {
  return fmt::format("{:.2f}", per_second / 1e9);
}

void add_summary(Page& text, const ProfileFigures& figures) {
  const Explanation& explanation = figures.explanation;
  const perf::Machine machine = perf::machine();
  text.fields(
      {{"bodies", grouped(figures.bodies)},
       {"step", fmt::format("{}, {}, target {}, {} path", explanation.integrator, explanation.precision,
                            explanation.target, explanation.path)},
       {"columns", bytes(static_cast<double>(explanation.column_bytes))},
       {"machine", fmt::format("{}, {}", machine.processor,
                               counted(static_cast<std::uint64_t>(machine.threads), "thread", "threads"))},
       {"streaming", fmt::format("{} GB/s on {} (STREAM triad)", gigabytes(figures.streaming),
                                 counted(static_cast<std::uint64_t>(explanation.threads), "thread", "threads"))}});
  if (explanation.column_bytes > 0 && explanation.column_bytes < machine.level3_bytes) {
    text.paragraph("The columns fit in the processor's cache: passes can be faster than memory streams.");
  }
}

void add_passes(Page& text, const ProfileFigures& figures) {
  const auto threads = static_cast<std::uint64_t>(figures.explanation.threads);
  text.heading(fmt::format("Passes on {}, {}", counted(threads, "thread", "threads"), seconds(figures.wall_seconds)));
  Table table{{{"pass", wrap},
               {"calls", right},
               {"time", right},
               {"share", right},
               {"ns", right},
               {"B", right},
               {"GB/s", right},
               {"of streaming", right}},
              {}};
  for (const PassFigure& pass : figures.passes) {
    table.rows.push_back({Cell(pass.time.name, Style::strong), grouped(pass.time.calls), seconds(pass.time.seconds),
                          percent(pass.share), number(pass.ns_per_body_step, 4), number(pass.bytes_per_body_step, 4),
                          gigabytes(pass.bytes_per_second), percent(pass.streaming_share)});
  }
  table.rows.push_back({"between passes", "", seconds(std::max(0.0, figures.outside_passes)),
                        percent(std::max(0.0, figures.outside_passes) / figures.wall_seconds), "", "", "", ""});
  text.table(table);
  text.paragraph("ns and B: per body-step (one body, one step).");
}

void add_contacts(Page& text, const ProfileFigures& figures) {
  const ContactReport& contact = figures.explanation.contact;
  if (contact.kind.empty()) return;
  const Counters& c = figures.counters;
  const double steps = static_cast<double>(std::max<std::uint64_t>(c.steps, 1));
  text.heading(fmt::format("Contacts over {}", counted(c.steps, "step", "steps")));
  const auto a_step = [&](std::uint64_t count) { return number(static_cast<double>(count) / steps, 5); };
  std::vector<std::pair<std::string, Cell>> fields{{"pairs", a_step(c.pairs) + " a step"}};
  if (contact.kind == "penalty") {
    fields.push_back({"contacts", fmt::format("{} a step, {} at most", a_step(c.contacts), grouped(c.peak_contacts))});
    fields.push_back({"neighbours", "searched anew " + counted(c.neighbour_lists, "time", "times")});
  } else {
    fields.push_back(
        {"contacts", fmt::format("{} loaded a step, {} at most, {}", a_step(c.contacts), grouped(c.peak_contacts),
                                 counted(static_cast<std::uint64_t>(c.colours), "colour", "colours"))});
    fields.push_back(
        {"impacts", fmt::format("{}, in at most {}", grouped(c.impacts),
                                counted(c.impact_rounds, "round of reflections", "rounds of reflections"))});
    fields.push_back(
        {"solver", fmt::format("{}, {} iterations and {} to relax",
                               counted(static_cast<std::uint64_t>(contact.substeps), "substep", "substeps"),
                               contact.iterations, contact.relax_iterations)});
    fields.push_back({"residual", number(c.residual, 3) + " m/s, the last sweep's largest error in a normal speed"});
  }
  fields.push_back({"deepest overlap", number(c.max_penetration, 3) + " m"});
  text.fields(std::move(fields));
}

void add_threads(Page& text, const ProfileFigures& figures) {
  const std::string repeat = counted(figures.steps * figures.repetitions, "step", "steps");
  text.heading(fmt::format("Throughput in body-steps/s, {} interleaved repeats of {}", figures.rounds, repeat));
  Table table{{{"threads", right},
               {"best", right},
               {"median", right},
               {"ns", right},
               {"speed-up", right},
               {"triad", right},
               {"its gain", right}},
              {}};
  for (const ThreadFigure& figure : figures.threads) {
    table.rows.push_back({std::to_string(figure.threads), Cell(rate(figure.best_rate), Style::strong),
                          rate(figure.median_rate), figure.best_rate > 0 ? number(1e9 / figure.best_rate, 4) : "-",
                          fmt::format("{:.2f}", figure.speed_up), gigabytes(figure.streaming),
                          fmt::format("{:.2f}", figure.streaming_speed_up)});
  }
  text.table(table);
  text.paragraph("triad: GB/s that the STREAM triad gets, the machine's bound for passes over memory.");
}

Json passes_json(const ProfileFigures& figures) {
  Json list = Json::array();
  for (const PassFigure& pass : figures.passes) {
    list.push_back({{"name", pass.time.name},
                    {"calls", pass.time.calls},
                    {"seconds", pass.time.seconds},
                    {"share", pass.share},
                    {"ns_per_body_step", pass.ns_per_body_step},
                    {"bytes_per_body_step", pass.bytes_per_body_step},
                    {"bytes_per_second", pass.bytes_per_second},
                    {"streaming_share", pass.streaming_share}});
  }
  return list;
}

Json contacts_json(const ProfileFigures& figures) {
  if (figures.explanation.contact.kind.empty()) return nullptr;
  const Counters& c = figures.counters;
  return {{"steps", c.steps},
          {"pairs", c.pairs},
          {"contacts", c.contacts},
          {"peak_contacts", c.peak_contacts},
          {"colours", c.colours},
          {"impacts", c.impacts},
          {"impact_rounds", c.impact_rounds},
          {"iterations", figures.explanation.contact.iterations},
          {"residual", c.residual},
          {"neighbour_lists", c.neighbour_lists},
          {"max_penetration", c.max_penetration}};
}

Json threads_json(const ProfileFigures& figures) {
  Json list = Json::array();
  for (const ThreadFigure& figure : figures.threads) {
    list.push_back({{"threads", figure.threads},
                    {"seconds", {{"min", figure.best_seconds}, {"median", figure.median_seconds}}},
                    {"body_steps_per_second", {{"best", figure.best_rate}, {"median", figure.median_rate}}},
                    {"speed_up", figure.speed_up},
                    {"streaming_bytes_per_second", figure.streaming},
                    {"streaming_speed_up", figure.streaming_speed_up}});
  }
  return list;
}

Json to_json(const std::string& scenario, const ProfileFigures& figures) {
  const perf::Machine machine = perf::machine();
  return {{"scenario", scenario},
          {"bodies", figures.bodies},
          {"integrator", figures.explanation.integrator},
          {"precision", figures.explanation.precision},
          {"target", figures.explanation.target},
          {"path", figures.explanation.path},
          {"column_bytes", figures.explanation.column_bytes},
          {"machine", {{"processor", machine.processor}, {"threads", machine.threads}, {"compiler", machine.compiler}}},
          {"steps", figures.steps},
          {"repetitions", figures.repetitions},
          {"rounds", figures.rounds},
          {"streaming_bytes_per_second", figures.streaming},
          {"wall_seconds", figures.wall_seconds},
          {"outside_passes_seconds", figures.outside_passes},
          {"passes", passes_json(figures)},
          {"contacts", contacts_json(figures)},
          {"threads", threads_json(figures)},
          {"status", {{"code", name(figures.status.code)}, {"sentence", figures.status.sentence}}}};
}

ProfileEffort effort_of(const Arguments& arguments) {
  constexpr std::uint64_t most_steps = 1'000'000'000'000;
  ProfileEffort effort;
  if (arguments.steps) effort.steps = whole_number("--steps", *arguments.steps, 1, most_steps);
  if (arguments.seconds) effort.seconds = real_number("--seconds", *arguments.seconds, false);
  return effort;
}

}  // namespace

Exit profile(const Arguments& arguments) {
  const Options options = run_options(arguments);
  const ProfileEffort effort = effort_of(arguments);
  const scenes::SceneFile file = load_scene(arguments);
  check_memory(file.scene, options);
  Delivery delivery(arguments);
  watch_for_interrupt();
  const ProfileFigures figures = measure(file.scene, options, effort, !arguments.quiet);
  Page text = page();
  text.heading(file.scene.name);
  add_summary(text, figures);
  add_passes(text, figures);
  add_contacts(text, figures);
  if (!figures.threads.empty()) add_threads(text, figures);
  delivery.text(text.text());
  delivery.json(to_json(file.scene.name, figures).dump(2));
  if (figures.interrupted) return interrupted_exit;
  if (figures.status.code == Status::Code::ok || accepted(file.scene, figures.status)) return done;
  complain(figures.status.sentence);
  return contract_left;
}

}  // namespace ballpark::command
