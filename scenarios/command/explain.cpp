// ballpark explain: what exists for a scene, and why.
#include <fmt/format.h>

#include <cmath>

#include "ballpark/scenes.h"
#include "ballpark/world.h"
#include "scenarios/command/commands.h"
#include "scenarios/command/deliver.h"
#include "scenarios/command/scene_options.h"
#include "scenarios/command/terminal.h"
#include "scenarios/command/text.h"

namespace ballpark::command {
namespace {

constexpr Column::Align right = Column::Align::right, wrap = Column::Align::wrap;

std::string or_none(const std::vector<std::string>& words) {
  return words.empty() ? "none" : joined(words);
}

void add_summary(Page& text, const Explanation& explanation) {
  std::vector<std::pair<std::string, Cell>> fields{
      {"path", Cell(explanation.path, Style::strong)},
      {"because", explanation.path_reason},
      {"integrator",
       fmt::format("{}, {} precision, target {}", explanation.integrator, explanation.precision, explanation.target)},
      {"tasks", fmt::format("{}, blocks of {} bodies",
                            counted(static_cast<std::uint64_t>(explanation.threads), "thread", "threads"),
                            grouped(explanation.block_length))},
      {"a body-step", fmt::format("moves {} B, computes {} flops", number(explanation.bytes_per_body_step, 5),
                                  number(explanation.flops_per_body_step, 4))},
      {"columns", bytes(static_cast<double>(explanation.column_bytes)) + " allocated"}};
  if (!explanation.stages.empty()) fields.push_back({"stages", explanation.stages});
  if (!explanation.rotation.empty()) fields.push_back({"rotation", explanation.rotation});
  for (const StepLimitReport& limit : explanation.step_limits) {
    const bool any = limit.largest > 0;
    fields.push_back({any ? "stable to" : "stable", any ? number(limit.largest, 4) + " s (" + limit.of + ")"
                                                        : "at no step: " + limit.of + " swings ever farther"});
  }
  text.fields(std::move(fields));
}

void add_groups(Page& text, const Explanation& explanation) {
  text.heading("Groups");
  if (explanation.groups.empty()) text.paragraph("none");
  for (const GroupReport& group : explanation.groups) {
    text.line("  " + group.name, Style::strong);
    text.fields({{"  bodies", grouped(group.bodies)},
                 {"  motion", group.motion + (group.why.empty() ? "" : " (" + group.why + ")")},
                 {"  effects", or_none(group.effects)},
                 {"  constants", or_none(group.constants)}});
  }
}

void add_columns(Page& text, const Explanation& explanation) {
  text.heading("Columns");
  Table table{{{"column"}, {"group"}, {"role"}, {"unit"}, {"n", right}, {"B/body", right}, {"asked for by", wrap}}, {}};
  for (const ColumnReport& column : explanation.columns) {
    table.rows.push_back({column.name, column.group, column.role, column.unit, std::to_string(column.components),
                          number(column.bytes_per_body), column.why});
  }
  if (table.rows.empty()) return text.paragraph("none");
  text.table(table);
}

void add_passes(Page& text, const Explanation& explanation) {
  text.heading("Passes, in the order of a step");
  if (explanation.passes.empty()) text.paragraph("none");
  for (const PassReport& pass : explanation.passes) {
    text.line(fmt::format("  {} of {}", pass.name, pass.group), Style::strong);
    const std::string calls = counted(static_cast<std::uint64_t>(pass.calls_per_step), "call", "calls") + " a step";
    const std::string each = fmt::format("; each moves {} B and computes {} flops per body",
                                         number(pass.bytes_per_body, 5), number(pass.flops_per_body, 5));
    text.fields({{"  cost", calls + (pass.bytes_per_body > 0 ? each : "")},
                 {"  reads", or_none(pass.reads)},
                 {"  writes", or_none(pass.writes)}});
    if (pass.why != explanation.path_reason) text.fields({{"  why   ", pass.why}});
  }
}

std::string largest_step(const ContactReport& contact) {
  if (!(contact.largest_step > 0)) return "none is stable with this integrator: each impact gains energy";
  if (!std::isfinite(contact.largest_step)) return "any: no two bodies can touch";
  return number(contact.largest_step, 4) +
         " s is stable for two bodies in contact; more contacts need less, which the run watches";
}

void add_contacts(Page& text, const ContactReport& contact) {
  if (contact.kind.empty()) return;
  text.heading("Contacts");
  using Fields = std::vector<std::pair<std::string, Cell>>;
  Fields fields{{"formulation", Cell(contact.kind, Style::strong)},
                {"of", fmt::format("{}, {}", counted(contact.bodies, "body", "bodies"),
                                   counted(contact.walls, "boundary face", "boundary faces"))}};
  const std::string none = "none in this scene: no spin, no tangential part";
  const Fields rest =
      contact.kind == "penalty"
          ? Fields{{"springs", fmt::format("{} N/m along the normal, dashpots {}", number(contact.stiffness),
                                           contact.pull ? "may pull" : "do not pull")},
                   {"friction", contact.friction ? fmt::format("springs of {} N/m across it, up to Coulomb's limit",
                                                               number(contact.sliding_stiffness))
                                                 : none},
                   {"largest step", largest_step(contact)},
                   {"skin", number(contact.margin) + " of the radii"}}
          : Fields{{"a step", fmt::format("{}, each with {} iterations and {} to relax",
                                          counted(static_cast<std::uint64_t>(contact.substeps), "substep", "substeps"),
                                          contact.iterations, contact.relax_iterations)},
                   {"margin", number(contact.margin) + " of the radii"},
                   {"friction", contact.friction ? "a cone, with spin" : none}};
  fields.insert(fields.end(), rest.begin(), rest.end());
  text.fields(std::move(fields));
  text.list(contact.laws);
}

void add_rest(Page& text, const Explanation& explanation) {
  text.heading("Narrowed: what the scene could have had and does not need");
  text.list(explanation.narrowed);
  if (explanation.narrowed.empty()) text.paragraph("nothing");
  text.heading("Off: what does not exist here");
  text.paragraph(or_none(explanation.off));
}

Json groups_json(const Explanation& explanation) {
  Json list = Json::array();
  for (const GroupReport& group : explanation.groups) {
    list.push_back({{"name", group.name},
                    {"bodies", group.bodies},
                    {"motion", group.motion},
                    {"why", group.why},
                    {"effects", group.effects},
                    {"constants", group.constants}});
  }
  return list;
}

Json columns_json(const Explanation& explanation) {
  Json list = Json::array();
  for (const ColumnReport& column : explanation.columns) {
    list.push_back({{"name", column.name},
                    {"group", column.group},
                    {"role", column.role},
                    {"unit", column.unit},
                    {"components", column.components},
                    {"bytes_per_body", column.bytes_per_body},
                    {"why", column.why}});
  }
  return list;
}

Json passes_json(const Explanation& explanation) {
  Json list = Json::array();
  for (const PassReport& pass : explanation.passes) {
    list.push_back({{"name", pass.name},
                    {"group", pass.group},
                    {"calls_per_step", pass.calls_per_step},
                    {"reads", pass.reads},
                    {"writes", pass.writes},
                    {"bytes_per_body", pass.bytes_per_body},
                    {"flops_per_body", pass.flops_per_body},
                    {"why", pass.why}});
  }
  return list;
}

Json limits_json(const Explanation& explanation) {
  Json list = Json::array();
  for (const StepLimitReport& limit : explanation.step_limits) {
    list.push_back({{"of", limit.of}, {"largest", limit.largest}});
  }
  return list;
}

Json contact_json(const ContactReport& contact) {
  if (contact.kind.empty()) return nullptr;
  return {{"kind", contact.kind},
          {"substeps", contact.substeps},
          {"iterations", contact.iterations},
          {"relax_iterations", contact.relax_iterations},
          {"margin", contact.margin},
          {"stiffness", contact.stiffness},
          {"sliding_stiffness", contact.sliding_stiffness},
          {"pull", contact.pull},
          {"largest_step", contact.largest_step},
          {"bodies", contact.bodies},
          {"walls", contact.walls},
          {"friction", contact.friction},
          {"laws", contact.laws}};
}

Json to_json(const std::string& scenario, const Explanation& explanation) {
  return {{"scenario", scenario},
          {"path", explanation.path},
          {"path_reason", explanation.path_reason},
          {"integrator", explanation.integrator},
          {"stages", explanation.stages.empty() ? Json(nullptr) : Json(explanation.stages)},
          {"rotation", explanation.rotation.empty() ? Json(nullptr) : Json(explanation.rotation)},
          {"precision", explanation.precision},
          {"target", explanation.target},
          {"threads", explanation.threads},
          {"block_length", explanation.block_length},
          {"bytes_per_body_step", explanation.bytes_per_body_step},
          {"flops_per_body_step", explanation.flops_per_body_step},
          {"column_bytes", explanation.column_bytes},
          {"contact", contact_json(explanation.contact)},
          {"step_limits", limits_json(explanation)},
          {"groups", groups_json(explanation)},
          {"columns", columns_json(explanation)},
          {"passes", passes_json(explanation)},
          {"narrowed", explanation.narrowed},
          {"off", explanation.off}};
}

}  // namespace

Exit explain(const Arguments& arguments) {
  const Options options = run_options(arguments);
  const scenes::SceneFile file = load_scene(arguments);
  check_memory(file.scene, options);
  Delivery delivery(arguments);
  const Explanation explanation = World(file.scene, options).explain();
  Page text = page();
  text.heading(file.scene.name);
  add_summary(text, explanation);
  add_groups(text, explanation);
  add_columns(text, explanation);
  add_contacts(text, explanation.contact);
  add_passes(text, explanation);
  add_rest(text, explanation);
  delivery.text(text.text());
  delivery.json(to_json(file.scene.name, explanation).dump(2));
  return done;
}

}  // namespace ballpark::command
