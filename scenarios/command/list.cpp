// ballpark list: what there is, from the catalogue and the scenarios' folder.
#include <fmt/format.h>

#include <algorithm>

#include "ballpark/catalogue.h"
#include "ballpark/scenes.h"
#include "scenarios/command/catalogue_text.h"
#include "scenarios/command/commands.h"
#include "scenarios/command/deliver.h"
#include "scenarios/command/scenario_folder.h"
#include "scenarios/command/terminal.h"
#include "scenarios/command/text.h"

namespace ballpark::command {
namespace {

/// A section as rows for people and as JSON.
struct Section {
  Table table;
  Json json = Json::array();
};

constexpr Column::Align wrap = Column::Align::wrap, right = Column::Align::right;

std::string doc_of(const scenes::SceneFile& file) {
  return file.stress ? file.stress->what : file.scene.doc;
}

std::string scenario_doc(const std::string& file) {
  try {
    return doc_of(scenes::load(file));
  } catch (const scenes::SceneFileError& error) {
    return "(broken: " + error.problems().front().message + ")";
  }
}

Section scenario_section(const std::vector<Scenario>& list) {
  Section section{{{{""}, {"", wrap}}, {}}};
  for (const Scenario& scenario : list) {
    const std::string doc = scenario_doc(scenario.file);
    section.table.rows.push_back({Cell(scenario.name, Style::strong), doc});
    section.json.push_back({{"name", scenario.name}, {"doc", doc}, {"file", scenario.file}});
  }
  return section;
}

Section integrator_section() {
  Section section{{{{""}, {"order", right}, {"forces/step", right}, {"", wrap}}, {}}};
  for (const IntegratorDescription& row : integrators()) {
    section.table.rows.push_back({Cell(row.name, Style::strong), std::to_string(row.order),
                                  std::to_string(row.evaluations), row.doc + (row.symplectic ? "; symplectic" : "")});
    section.json.push_back(to_json(row));
  }
  return section;
}

Section effect_section() {
  Section section{{{{""}, {"", wrap}}, {}}};
  for (const EffectDescription& effect : effects()) {
    section.table.rows.push_back({Cell(effect.name, Style::strong), effect.doc});
    section.json.push_back(to_json(effect));
  }
  return section;
}

Section named_section(std::initializer_list<const std::vector<NamedDescription>*> lists) {
  Section section{{{{""}, {"", wrap}}, {}}};
  for (const auto* list : lists) {
    for (const NamedDescription& item : *list) {
      section.table.rows.push_back({Cell(item.name, Style::strong), item.doc});
      section.json.push_back(to_json(item));
    }
  }
  return section;
}

Section target_section() {
  Section section{{{{""}, {"this machine"}, {"", wrap}}, {}}};
  for (const NamedDescription& target : targets()) {
    section.table.rows.push_back({Cell(target.name, Style::strong), target.available ? "yes" : "no", target.doc});
    section.json.push_back({{"name", target.name}, {"available", target.available}});
  }
  return section;
}

Section section_named(const std::string& name) {
  if (name == "scenarios") return scenario_section(scenarios());
  if (name == "stress") return scenario_section(stress_cases());
  if (name == "integrators") return integrator_section();
  if (name == "effects") return effect_section();
  if (name == "shapes") return named_section({&shapes(), &boundary_shapes()});
  if (name == "contacts") return named_section({&contacts()});
  if (name == "targets") return target_section();
  return {};
}

}  // namespace

const std::vector<std::string>& list_sections() {
  static const std::vector<std::string> names{"scenarios", "integrators", "effects", "shapes",
                                              "contacts",  "targets",     "stress"};
  return names;
}

Exit list(const Arguments& arguments) {
  const std::vector<std::string>& all = list_sections();
  const bool one = !arguments.name.empty();
  if (one && std::find(all.begin(), all.end(), arguments.name) == all.end()) {
    throw UsageError(no_such("list of", arguments.name, all));
  }
  Delivery delivery(arguments);
  Page text = page();
  Json json;
  for (const std::string& name : one ? std::vector{arguments.name} : all) {
    Section section = section_named(name);
    if (!one) text.heading(name);
    if (section.table.rows.empty()) text.line("  none");
    if (!section.table.rows.empty()) text.table(section.table);
    (one ? json : json[name]) = std::move(section.json);
  }
  delivery.text(text.text());
  delivery.json(json.dump(2));
  return done;
}

}  // namespace ballpark::command
