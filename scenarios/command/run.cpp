// ballpark run: simulate a scene, print what happened, write what was asked for.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "ballpark/scenes.h"
#include "scenarios/command/commands.h"
#include "scenarios/command/deliver.h"
#include "scenarios/command/expectation_text.h"
#include "scenarios/command/ledger_text.h"
#include "scenarios/command/run_files.h"
#include "scenarios/command/scene_options.h"
#include "scenarios/command/series_text.h"
#include "scenarios/command/terminal.h"
#include "scenarios/command/text.h"
#include "scenarios/files/report_json.h"

namespace ballpark::command {
namespace {

using scenes::Expectation;
using scenes::RunReport;
using scenes::Verdict;

bool reached(const Verdict& verdict) {
  return !std::isnan(verdict.time);
}

std::string off_by(const Verdict& verdict) {
  const bool off = !verdict.met && verdict.expectation.value && std::isfinite(verdict.measured);
  return off ? number(std::abs(verdict.measured - *verdict.expectation.value), 3) : "";
}

std::string measured(const Verdict& verdict) {
  constexpr int enough = 9;  // to see how far off it is
  const int digits = digits_of(verdict.expectation);
  if (!reached(verdict)) return "not reached";
  return number(verdict.measured, verdict.met ? digits : std::min(digits, enough));
}

Cell expectation_summary(const std::vector<Verdict>& verdicts) {
  std::size_t met = 0, missed = 0;
  for (const Verdict& verdict : verdicts) {
    met += verdict.met;
    missed += !verdict.met && reached(verdict);
  }
  if (verdicts.empty()) return "none given";
  const std::size_t open = verdicts.size() - met - missed;
  const std::string rest = open > 0 ? fmt::format(", {} not reached", open) : "";
  return Cell(fmt::format("{} met, {} missed{}", met, missed, rest), missed ? Style::bad : Style::good);
}

Cell verdict_cell(const Verdict& verdict) {
  if (!reached(verdict)) return "-";
  return verdict.met ? Cell("met", Style::good) : Cell("MISSED", Style::bad);
}

std::string speed(const RunReport& report) {
  if (report.body_steps_per_second <= 0) return "-";
  return fmt::format("{} body-steps/s, {} per body-step", rate(report.body_steps_per_second),
                     seconds(1 / report.body_steps_per_second));
}

/// What went wrong, if anything did.
std::vector<std::pair<std::string, Cell>> status_fields(const RunReport& report, const Scene& scene) {
  std::vector<std::pair<std::string, Cell>> fields;
  const Status& status = report.status;
  if (report.interrupted) {
    const std::string where = fmt::format("at {} s of {} s", number(report.time), number(scene.run.duration));
    fields.push_back({"interrupted", Cell(where, Style::bad)});
  }
  if (status.code == Status::Code::ok) return fields;
  const std::string when =
      status.step > 0 ? fmt::format(" (step {}, {} s)", grouped(status.step), number(status.time)) : "";
  const std::string taken = accepted(scene, status) ? "; accepted by the scene" : "";
  fields.push_back({name(status.code), Cell(status.sentence + when + taken, Style::bad)});
  return fields;
}

std::string solver_fact(const RunReport& report) {
  const Counters& c = report.counters;
  if (report.contact == "penalty") return "neighbours listed " + counted(c.neighbour_lists, "time", "times");
  return counted(static_cast<std::uint64_t>(c.colours), "colour", "colours");
}

void add_contact_facts(std::vector<std::pair<std::string, Cell>>& facts, const RunReport& report) {
  if (report.contact.empty()) return;
  const Counters& c = report.counters;
  const double steps = static_cast<double>(std::max<std::uint64_t>(c.steps, 1));
  std::vector<std::pair<std::string, Cell>> fields{
      {"pairs",
       fmt::format("{} a step, at most {}", number(static_cast<double>(c.pairs) / steps, 4), grouped(c.peak_pairs))},
      {"contacts", fmt::format("{} loaded a step, at most {}; {}", number(static_cast<double>(c.contacts) / steps, 4),
                               grouped(c.peak_contacts), solver_fact(report))},
      {"deepest overlap", number(c.max_penetration, 3) + " m"}};
  if (report.contact == "penalty") {
    const bool any = std::isfinite(report.largest_step);
    fields.push_back({"largest step", any ? number(report.largest_step, 3) + " s would be stable for the contacts met"
                                          : "any: no two bodies can touch"});
  } else {
    fields.insert(fields.end() - 1, {"impacts", fmt::format("{}, in at most {} of reflections", grouped(c.impacts),
                                                            counted(c.impact_rounds, "round", "rounds"))});
  }
  facts.insert(facts.end() - 2, fields.begin(), fields.end());  // before the hash
}

/// How an implicit method solved its stages.
void add_stage_facts(std::vector<std::pair<std::string, Cell>>& facts, const RunReport& report) {
  if (report.counters.newton_iterations == 0) return;
  const std::string text =
      fmt::format("{} iterations, the last change at most {} of a body's state",
                  grouped(report.counters.newton_iterations), number(report.counters.newton_residual, 3));
  const char* method = report.path == "implicit" ? "Newton's method" : "fixed-point iteration";
  facts.insert(facts.begin() + 4, {method, text});  // behind the force evaluations
}

/// "once, at 1.5 s", "40 times, from 0.1 s to 7.9 s"
std::string times_text(const scenes::EventTimes& event) {
  constexpr int digits = 12;
  const auto told = [](double time) { return number(time, digits) + " s"; };
  if (event.count == 0) return "never";
  const std::string first = told(event.times.front());
  if (event.count == 1) return "once, at " + first;
  if (event.count == 2) return fmt::format("twice, at {} and {}", first, told(event.last));
  return fmt::format("{} times, from {} to {}", grouped(event.count), first, told(event.last));
}

void add_events(std::vector<std::pair<std::string, Cell>>& facts, const RunReport& report) {
  for (const scenes::EventTimes& event : report.events) {
    facts.insert(facts.end() - 2, {"event " + event.name, times_text(event)});  // before the hash
  }
}

std::string steps_text(const RunReport& report) {
  const std::string steps = grouped(report.counters.steps);
  if (report.tolerance == 0) return fmt::format("{} of {} s ({})", steps, number(report.step), report.integrator);
  return fmt::format("{} at a tolerance of {} ({}), {} more rejected", steps, number(report.tolerance),
                     report.integrator, grouped(report.counters.rejected_steps));
}

std::string bodies_text(const RunReport& report) {
  const std::size_t absent = report.final.absent_bodies;
  const std::uint64_t entered = report.counters.entered, left = report.counters.left;
  if (absent == 0 && entered == 0 && left == 0) return grouped(report.bodies);
  return fmt::format("{}, {} of them there at the end: {} entered, {} left", grouped(report.bodies),
                     grouped(report.bodies - absent), grouped(entered), grouped(left));
}

void add_facts(Page& text, const RunReport& report, const Scene& scene, const RunFiles& files) {
  const std::string threads = counted(static_cast<std::uint64_t>(report.threads), "thread", "threads");
  std::vector<std::pair<std::string, Cell>> facts{
      {"bodies", bodies_text(report)},
      {"simulated time", number(report.time) + " s"},
      {"steps", steps_text(report)},
      {"force evaluations", grouped(report.counters.force_evaluations)},
      {"wall time", fmt::format("{} ({}, {}, {}, {} path)", seconds(report.wall_seconds), threads, report.precision,
                                report.target, report.path)},
      {"speed", speed(report)},
      {"energy", fmt::format("{} J at the start, {} J at the end", number(report.initial.energy(), 9),
                             number(report.final.energy(), 9))},
      {"energy drift", number(report.energy_drift_relative, 3) + " (relative)"},
      {"momentum drift", number(report.momentum_drift, 3) + " (relative)"},
      {"angular momentum drift", number(report.angular_momentum_drift, 3) + " (relative)"},
      {"state hash", report.state_hash},
      {"expectations", expectation_summary(report.verdicts)}};
  add_stage_facts(facts, report);
  add_contact_facts(facts, report);
  add_events(facts, report);
  if (const auto costs = files.costs(); !costs.empty()) facts.push_back({"output", series_text(costs)});
  for (auto& field : status_fields(report, scene)) facts.push_back(std::move(field));
  text.fields(std::move(facts));
}

void add_verdicts(Page& text, const RunReport& report) {
  constexpr Column::Align right = Column::Align::right, wrap = Column::Align::wrap;
  if (report.verdicts.empty()) return;
  const bool any_off = std::any_of(report.verdicts.begin(), report.verdicts.end(),
                                   [](const Verdict& verdict) { return !off_by(verdict).empty(); });
  Table table{{{""}, {"quantity", wrap}, {"at [s]", right}, {"measured", right}, {"wanted", wrap}, {"", right}}, {}};
  if (any_off) table.columns.back().heading = "off by";
  for (const Verdict& verdict : report.verdicts) {
    table.rows.push_back({verdict_cell(verdict), verdict.expectation.quantity,
                          reached(verdict) ? number(verdict.time) : "-", measured(verdict), wanted(verdict.expectation),
                          off_by(verdict)});
  }
  text.blank();
  text.table(table);
}

std::string text_of(const RunReport& report, const Scene& scene, const RunFiles& files) {
  Page text = page();
  text.heading(report.scenario);
  if (!scene.doc.empty()) text.paragraph(scene.doc);
  text.blank();
  add_facts(text, report, scene, files);
  add_verdicts(text, report);
  if (report.ledger) add_ledger(text, *report.ledger);
  if (!files.written().empty()) text.blank();
  for (const std::string& path : files.written()) text.line("  wrote " + path);
  return text.text();
}

// JSON has no NaN or infinity: they become null.
std::string json_of(const RunReport& report, const RunFiles& files) {
  Json json = scenes::json_of(report);
  json["outputs"] = series_json(files.costs());
  return json.dump(2, ' ', false, Json::error_handler_t::replace);
}

/// The status is among the warnings: the text has told it already.
std::vector<std::string> untold_warnings(const RunReport& report, bool text_shown) {
  std::vector<std::string> warnings = report.warnings;
  if (text_shown) std::erase(warnings, report.status.sentence);
  return warnings;
}

Exit exit_code(const RunReport& report, bool status_accepted, bool write_failed) {
  const auto missed = [](const Verdict& verdict) { return !verdict.met; };
  if (report.interrupted) return interrupted_exit;
  if (report.status.code != Status::Code::ok && !status_accepted) return contract_left;
  if (write_failed || std::any_of(report.verdicts.begin(), report.verdicts.end(), missed)) return check_failed;
  return done;
}

}  // namespace

Exit run(const Arguments& arguments) {
  const Options options = run_options(arguments);
  scenes::SceneFile file = load_scene(arguments);
  check_memory(file.scene, options);
  watch_for_interrupt();  // from here on there are files to tidy up
  RunFiles files(file, arguments);
  Delivery delivery(arguments);
  scenes::RunHooks hooks;
  hooks.writers = files.writers();
  hooks.ledger = arguments.ledger;
  RunReport report;
  {
    Progress progress(file.scene.name, !arguments.quiet);
    hooks.progress = [&](double fraction) {
      progress.show(fraction);
      return !interrupted();
    };
    report = scenes::run(file, options, hooks);
  }
  const bool all_written = files.finish();
  delivery.text(text_of(report, file.scene, files));
  delivery.json(json_of(report, files));
  if (!arguments.quiet) warn(untold_warnings(report, delivery.wants_text()));
  if (arguments.quiet && report.status.code != Status::Code::ok) warn({report.status.sentence});
  for (const std::string& failure : files.failures()) complain(failure);
  return exit_code(report, accepted(file.scene, report.status), !all_written);
}

}  // namespace ballpark::command
