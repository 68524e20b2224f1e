// ballpark describe: one thing by its name, whatever kind of thing it is.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "ballpark/catalogue.h"
#include "ballpark/scenes.h"
#include "scenarios/command/catalogue_text.h"
#include "scenarios/command/commands.h"
#include "scenarios/command/deliver.h"
#include "scenarios/command/expectation_text.h"
#include "scenarios/command/scenario_folder.h"
#include "scenarios/command/scene_options.h"
#include "scenarios/command/terminal.h"
#include "scenarios/command/text.h"

namespace ballpark::command {
namespace {

constexpr Column::Align wrap = Column::Align::wrap;

struct Description {
  Page text;
  Json json;
};

template <class Entry>
const Entry* find(const std::vector<Entry>& entries, const std::string& name) {
  const auto found =
      std::find_if(entries.begin(), entries.end(), [&](const Entry& entry) { return entry.name == name; });
  return found == entries.end() ? nullptr : &*found;
}

/// "NAME, a KIND", and what it is.
Page titled(const std::string& name, const std::string& kind, const std::string& doc) {
  Page text = page();
  text.heading(name + ", " + kind);
  text.paragraph(doc);
  return text;
}

std::string or_none(const std::vector<std::string>& words) {
  return words.empty() ? "none" : joined(words);
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  for (std::size_t start = 0, end; start < text.size(); start = end + 1) {
    end = std::min(text.find('\n', start), text.size());
    lines.push_back(text.substr(start, end - start));
  }
  return lines;
}

void add_lines(Page& text, const std::string& lines) {
  for (const std::string& line : lines_of(lines)) text.aligned_line(line);
}

/// Prose: lines are joined up to the next empty or indented one.
void add_prose(Page& text, const std::string& lines) {
  std::vector<std::string> joined_lines;
  bool open = false;  // the last line takes more
  for (const std::string& line : lines_of(lines)) {
    const bool prose = !line.empty() && line.front() != ' ';
    if (prose && open) {
      joined_lines.back() += " " + line;
    } else {
      joined_lines.push_back(line);
    }
    open = prose;
  }
  for (const std::string& line : joined_lines) text.aligned_line(line);
}

Description describe_effect(const EffectDescription& effect) {
  Page text = titled(effect.name, "an effect", effect.doc);
  text.heading("Parameters");
  Table table{{{"name"}, {"kind"}, {"unit"}, {"default"}, {"range"}, {"", wrap}}, {}};
  for (const ParameterInfo& parameter : effect.parameters) {
    table.rows.push_back({Cell(parameter.name, Style::strong), kind_name(parameter.kind), parameter.unit,
                          parameter.fallback ? toml(*parameter.fallback) : "required", range(parameter),
                          parameter.doc});
  }
  text.table(table);
  text.heading("Properties");
  text.fields({{"reads", or_none(effect.reads)},
               {"exerts", or_none(effect.exerts)},
               {"energy", effect.has_energy ? "has a potential, counted in the run's energy" : "no potential"},
               {"taylor2", effect.between_steps          ? "no matter: acts between steps"
                           : effect.has_force_derivative ? "gives its force derivative"
                                                         : "no force derivative: refused"},
               {"cost", counted(static_cast<std::uint64_t>(effect.flops), "flop", "flops") +
                            (effect.between_bodies ? " per pair" : " per body") +
                            (effect.between_steps ? " and step" : " and evaluation")},
               {"source", effect.source}});
  text.heading("In a scene file");
  add_lines(text, example(effect));
  Json json = to_json(effect);
  json["kind"] = "effect";
  json["example"] = example(effect);
  return {text, json};
}

std::string cost_of(const IntegratorDescription& row) {
  const auto evaluations = static_cast<std::uint64_t>(row.evaluations);
  std::string cost = counted(evaluations, "evaluation", "evaluations") + " of all forces per step";
  if (row.implicit) {
    cost +=
        " and iteration of Newton's method, with their derivatives; most steps take two or three. Where a force has "
        "none, "
        "of a fixed-point iteration; steps take 7 to 40";
  }
  if (row.start_steps > 0)
    cost += fmt::format("; the first {} by rk4, 4 each, and again after an impulse", row.start_steps);
  return cost;
}

Description describe_integrator(const IntegratorDescription& row) {
  Page text = titled(row.name, "an integrator", row.doc);
  text.heading("Properties");
  text.fields(
      {{"family", row.family},
       {"order", std::to_string(row.order)},
       {"cost", cost_of(row)},
       {"step", row.adaptive ? "given, or chosen by a tolerance" : "given"},
       {"symplectic", row.symplectic ? "yes, for forces that do not read velocity" : "no"},
       {"stable, decay",
        std::isinf(row.real_limit) ? "at any step"
        : row.real_limit == 0
            ? (row.turns_velocity ? "takes forces that only turn velocity; others that read it: refused"
                                  : "not for forces that read velocity: refused")
            : "step * |lambda| up to " + number(row.real_limit) + " for y' = lambda y, lambda < 0"},
       {"stable, oscillation", std::isinf(row.imaginary_limit) ? "at any step"
                               : row.imaginary_limit == 0
                                   ? "never: an undamped oscillation always grows"
                                   : "step * omega up to " + number(row.imaginary_limit) + " for x'' = -omega^2 x"},
       {"source", row.source}});
  text.heading("In a scene file");
  add_lines(text, fmt::format("[run]\nintegrator = \"{}\"\n", row.name));
  Json json = to_json(row);
  json["kind"] = "integrator";
  return {text, json};
}

std::string expectation_text(const scenes::Expectation& expectation) {
  const std::string when = expectation.at ? fmt::format(" at {} s", number(*expectation.at)) : "";
  return expectation.quantity + when + ": " + wanted(expectation);
}

std::vector<std::string> group_lines(const Scene& scene) {
  std::vector<std::string> lines;
  for (const BodyGroup& group : scene.bodies) {
    Scene alone;
    alone.bodies = {group};
    lines.push_back(fmt::format("{}: {}", group.name, counted(body_count(alone), "body", "bodies")));
  }
  return lines;
}

Description describe_scenario(const std::string& name, const std::string& path) {
  const scenes::SceneFile file = scenes::load(path);
  const RunSettings& run = file.scene.run;
  const std::string comment = leading_comment(path);
  Page text =
      titled(name, file.stress ? "a hard case" : "a scenario", file.stress ? file.stress->what : file.scene.doc);
  if (!comment.empty()) text.blank();
  add_prose(text, comment);
  std::vector<std::string> effects, expectations;
  for (const Effect& effect : file.scene.effects) effects.push_back(effect.kind);
  for (const auto& expectation : file.expectations) expectations.push_back(expectation_text(expectation));
  text.heading("Facts");
  text.fields({{"bodies", or_none(group_lines(file.scene))},
               {"effects", or_none(effects)},
               {"run", pace_text(run)},
               {"file", path}});
  if (!expectations.empty()) text.heading("Expected");
  text.list(expectations);
  Json json{{"name", name},
            {"kind", file.stress ? "hard case" : "scenario"},
            {"doc", file.stress ? file.stress->what : file.scene.doc},
            {"comment", comment},
            {"file", path},
            {"bodies", body_count(file.scene)},
            {"effects", effects},
            {"duration", run.duration},
            {"step", run.tolerance > 0 ? Json(nullptr) : Json(run.step)},
            {"tolerance", run.tolerance > 0 ? Json(run.tolerance) : Json(nullptr)},
            {"integrator", run.integrator},
            {"expectations", expectations}};
  return {text, json};
}

Description describe_entry(const NamedDescription& entry, const std::string& kind) {
  Json json = to_json(entry);
  json["kind"] = kind;
  Page text = titled(entry.name, (kind == "instruction set" ? "an " : "a ") + kind, entry.doc);
  if (kind == "instruction set") {
    json["available"] = entry.available;
    text.paragraph(entry.available ? "This machine has it." : "This machine does not have it.");
  }
  return {text, json};
}

Description describe_scene_file() {
  Page text = page();
  text.line("scene, the keys of a scene file", Style::strong);
  add_lines(text, scenes::key_help());
  return {text, Json::parse(scenes::json_schema())};
}

[[noreturn]] void unknown(const std::string& name) {
  std::vector<std::string> names{"scene"};
  for (const auto& entry : effects()) names.push_back(entry.name);
  for (const auto& entry : integrators()) names.push_back(entry.name);
  for (const auto* entries : {&shapes(), &boundary_shapes(), &contacts(), &rotations(), &targets()}) {
    for (const auto& entry : *entries) names.push_back(entry.name);
  }
  for (const auto& scenario : all_scenes()) names.push_back(scenario.name);
  const std::string near = nearest(name, names);
  throw UsageError(fmt::format("nothing is named '{}'{}; `ballpark list` shows all names", name,
                               near.empty() ? "" : fmt::format("; did you mean '{}'?", near)));
}

Description description_of(const std::string& name) {
  if (name == "scene") return describe_scene_file();
  if (const auto* effect = find(effects(), name)) return describe_effect(*effect);
  if (const auto* integrator = find(integrators(), name)) return describe_integrator(*integrator);
  if (const auto* shape = find(shapes(), name)) return describe_entry(*shape, "shape");
  if (const auto* shape = find(boundary_shapes(), name)) return describe_entry(*shape, "shape");
  if (const auto* contact = find(contacts(), name)) return describe_entry(*contact, "contact formulation");
  if (const auto* rotation = find(rotations(), name)) return describe_entry(*rotation, "rotation rule");
  if (const auto* target = find(targets(), name)) return describe_entry(*target, "instruction set");
  for (const Scenario& scenario : all_scenes()) {
    if (scenario.name == name) return describe_scenario(name, scenario.file);
  }
  if (name.ends_with(".toml")) return describe_scenario(name, name);
  unknown(name);
}

}  // namespace

Exit describe(const Arguments& arguments) {
  Delivery delivery(arguments);
  const Description description = description_of(arguments.name);
  delivery.text(description.text.text());
  delivery.json(description.json.dump(2));
  return done;
}

}  // namespace ballpark::command
