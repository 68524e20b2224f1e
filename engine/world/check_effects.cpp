#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/core/nearest.h"
#include "engine/world/check.h"

namespace ballpark {

namespace {

const char* type_of(ParameterKind kind) {
  switch (kind) {
    case ParameterKind::number:
      return "a number";
    case ParameterKind::vector:
      return "three numbers [x, y, z]";
    case ParameterKind::vectors:
      return "three numbers [x, y, z], or a row of them for each body";
    case ParameterKind::word:
      return "a word";
    case ParameterKind::numbers:
      return "a number, or one for each pair";
    case ParameterKind::pairs:
      return "pairs of ids [[a, b], ...]";
  }
  return "";
}

/// What a parameter may be, in words.
std::string expected(const ParameterInfo& info) {
  if (info.kind == ParameterKind::word) return fmt::format("one of \"{}\"", fmt::join(info.choices, "\", \""));
  return fmt::format("{} [{}]", type_of(info.kind), info.unit);
}

bool has_type(const Value& value, ParameterKind kind) {
  switch (kind) {
    case ParameterKind::number:
      return std::holds_alternative<double>(value);
    case ParameterKind::vector:
      return std::holds_alternative<Vector3d>(value);
    case ParameterKind::vectors:
      return std::holds_alternative<Vector3d>(value) || std::holds_alternative<std::vector<Vector3d>>(value);
    case ParameterKind::word:
      return std::holds_alternative<std::string>(value);
    case ParameterKind::numbers:
      return std::holds_alternative<double>(value) || std::holds_alternative<std::vector<double>>(value);
    case ParameterKind::pairs:
      return std::holds_alternative<std::vector<IdPair>>(value);
  }
  return false;
}

struct EffectCheck {
  const Scene& scene;
  const Effect& effect;
  std::size_t index;
  Problems& problems;

  std::string path(const std::string& key) const { return path_of("effects", index, key.c_str()); }

  void run() {
    std::vector<std::string> kinds;
    for (const EffectDescription& description : effects()) kinds.push_back(description.name);
    if (!problems.known(path("kind"), "effect", effect.kind, kinds)) return;
    const EffectDescription& description = *find_effect(effect.kind);
    check_groups();
    bool sound = true;
    std::vector<std::string> names;
    for (const ParameterInfo& info : description.parameters) {
      names.push_back(info.name);
      sound = check_parameter(info) && sound;
    }
    for (const auto& [key, value] : effect.parameters) problems.known(path(key), "parameter", key, names);
    if (sound) check_meaning(description);
  }

  void check_groups() {
    std::vector<std::string> names;
    for (const BodyGroup& group : scene.bodies) names.push_back(group.name);
    for (std::size_t i = 0; i < effect.groups.size(); ++i) {
      problems.known(path_of(path("groups"), i, effect.groups.size()), "group", effect.groups[i], names);
    }
  }

  bool check_parameter(const ParameterInfo& info) {
    const auto found = effect.parameters.find(info.name);
    const std::string at = path(info.name);
    if (found == effect.parameters.end()) {
      if (info.fallback) return true;
      problems.add(at, fmt::format("is missing, expected {}: {}", expected(info), info.doc));
      return false;
    }
    if (!has_type(found->second, info.kind)) {
      problems.add(at, "expected " + expected(info));
      return false;
    }
    return check_value(info, found->second, at);
  }

  bool check_value(const ParameterInfo& info, const Value& value, const std::string& at) {
    if (const auto* number = std::get_if<double>(&value)) return check_number(info, *number, at);
    if (const auto* word = std::get_if<std::string>(&value)) {
      return problems.known(at, info.name.c_str(), *word, info.choices);
    }
    if (const auto* numbers = std::get_if<std::vector<double>>(&value)) {
      for (std::size_t i = 0; i < numbers->size(); ++i) {
        if (!check_number(info, (*numbers)[i], path_of(at, i, numbers->size()))) return false;
      }
    }
    if (const auto* vector = std::get_if<Vector3d>(&value)) return problems.finite(at, *vector, info.unit.c_str());
    if (const auto* rows = std::get_if<std::vector<Vector3d>>(&value)) {
      for (std::size_t i = 0; i < rows->size(); ++i) {
        if (!problems.finite(path_of(at, i, rows->size()), (*rows)[i], info.unit.c_str())) return false;
      }
    }
    return true;
  }

  bool check_number(const ParameterInfo& info, double number, const std::string& at) {
    const bool may_be_infinite = info.fallback && std::get_if<double>(&*info.fallback) &&
                                 std::isinf(std::get<double>(*info.fallback)) && !std::isnan(number);
    if (!may_be_infinite && !problems.finite(at, number, info.unit.c_str())) return false;
    if (number >= info.minimum && number <= info.maximum) return true;
    const std::string bound = number < info.minimum ? ">= " + text(info.minimum) : "<= " + text(info.maximum);
    problems.add(at, fmt::format("is {}, expected a number {} [{}]", text(number), bound, info.unit));
    return false;
  }

  /// What parameters mean together, and for the groups that the effect acts on.
  void check_meaning(const EffectDescription& description) {
    const auto parameters = complete_parameters(effect, description);
    const auto at = parameters.find("at"), until = parameters.find("until");
    if (at != parameters.end() && until != parameters.end() &&
        !(std::get<double>(at->second) < std::get<double>(until->second))) {
      problems.add(path("until"),
                   fmt::format("is {} s, expected a time after at = {} s", text(std::get<double>(until->second)),
                               text(std::get<double>(at->second))));
    }
    const auto normal = parameters.find("normal");
    if (normal != parameters.end() && !(std::get<Vector3d>(normal->second).norm() > 1e-100)) {
      problems.add(path("normal"), "has length 0, expected a direction");
    }
    check_space(parameters);
    check_pairs(description, parameters);
    for (const BodyGroup& group : scene.bodies) {
      if (!acts_on(effect, group)) continue;
      check_rotation(description, parameters, group);
      check_size(description, group);
      if (description.name == "table") check_table(group);
      if (description.between_steps && pivot_of(scene, group)) {
        problems.add(path("groups"), "group " + group.name + " turns about a pivot, which ties its velocities to it: " +
                                         "expected other groups");
      }
      for (const ParameterInfo& info : description.parameters) {
        if (info.kind != ParameterKind::vectors) continue;
        const std::size_t rows = std::get<std::vector<Vector3d>>(parameters.at(info.name)).size();
        if (rows != 1 && rows != body_count(group)) {
          problems.add(path(info.name), fmt::format("has {} rows, expected one, or one for each of the {} bodies of {}",
                                                    rows, body_count(group), group.name));
        }
      }
    }
  }

  /// Of a body's images at most one may act: of those without end the sum has no limit.
  void check_space(const std::map<std::string, Value>& parameters) {
    const auto cutoff = parameters.find("cutoff");
    for (const Boundary& boundary : scene.boundaries) {
      if (boundary.shape != "periodic") continue;
      if (effect.kind == "mutual_gravity") {
        problems.add(path("kind"), "mutual_gravity acts over all of space, expected no periodic boundary");
      }
      for (int c = 0; c < 3 && cutoff != parameters.end(); ++c) {
        const double reach = std::get<double>(cutoff->second), length = boundary.size[c];
        if (!(length > 0) || 2 * reach <= length) continue;
        problems.add(path("cutoff"),
                     fmt::format("is {} m, expected at most {} m, half of the length after which space repeats",
                                 text(reach), text(length / 2)));
        break;
      }
    }
  }

  /// Pairs name two bodies of the effect's groups; what differs between pairs has a number for each.
  void check_pairs(const EffectDescription& description, const std::map<std::string, Value>& parameters) {
    const auto pairs = parameters.find("pairs");
    if (pairs == parameters.end()) return;
    const auto& list = std::get<std::vector<IdPair>>(pairs->second);
    if (list.empty()) return problems.add(path("pairs"), "is empty, expected a list of pairs of ids [[a, b], ...]");
    for (std::size_t i = 0; i < list.size(); ++i) {
      const std::string at = path_of(path("pairs"), i, list.size());
      if (list[i][0] == list[i][1]) {
        problems.add(at, fmt::format("joins body {} with itself, expected two bodies", list[i][0]));
      }
      for (const std::size_t id : list[i]) check_id(at, id);
    }
    for (const ParameterInfo& info : description.parameters) {
      if (info.kind != ParameterKind::numbers) continue;
      const std::size_t rows = std::get<std::vector<double>>(parameters.at(info.name)).size();
      if (rows == 1 || rows == list.size()) continue;
      problems.add(path(info.name),
                   fmt::format("has {} numbers, expected one, or one for each of the {} pairs", rows, list.size()));
    }
  }

  void check_id(const std::string& at, std::size_t id) {
    std::size_t first = 0;
    for (const BodyGroup& group : scene.bodies) {
      const std::size_t count = body_count(group);
      if (id >= first && id < first + count) {
        if (acts_on(effect, group)) return;
        problems.add(at, fmt::format("body {} is of group {}, on which this effect does not act", id, group.name));
        return;
      }
      first += count;
    }
    problems.add(at, fmt::format("body {} does not exist, expected an id below {}", id, first));
  }

  /// A particle at its own pivot has no inertia about it.
  void check_arm(const std::map<std::string, Value>& parameters, const BodyGroup& group) {
    const auto& points = std::get<std::vector<Vector3d>>(parameters.at("point"));
    const auto row = [](const std::vector<Vector3d>& rows, std::size_t i) { return rows[rows.size() == 1 ? 0 : i]; };
    const std::size_t bodies = body_count(group);
    for (const auto* rows : {&points, &group.position}) {
      if (rows->size() != 1 && rows->size() != bodies) return;  // a problem of its own
    }
    for (std::size_t i = 0; i < bodies; ++i) {
      if (row(group.position, i) != row(points, i)) continue;
      problems.add(path("point"),
                   fmt::format("is where particle {} of group {} is, expected a point beside it", i, group.name));
      return;
    }
  }

  void check_size(const EffectDescription& description, const BodyGroup& group) {
    const auto& reads = description.reads;
    if (std::find(reads.begin(), reads.end(), "radius") != reads.end() && group.radius.empty()) {
      problems.add(path("groups"),
                   fmt::format("{} needs the radius of the bodies, but group {} gives none: expected bodies.radius",
                               description.name, group.name));
    }
    if (description.name == "added_mass" && pivot_of(scene, group)) {
      problems.add(path("groups"), "group " + group.name +
                                       " turns about a pivot, where added_mass does not act: expected other groups");
    }
  }

  /// A table carries balls by what their mass and one moment of inertia make of friction.
  void check_table(const BodyGroup& group) {
    const auto refuse = [&](const char* what) {
      problems.add(path("groups"), "group " + group.name + " " + what + ": expected other groups");
    };
    for (std::size_t i = 0; i < group.inertia.size(); ++i) {
      const Vector3d inertia = inertia_of(group, i);
      if (inertia.minCoeff() != inertia.maxCoeff()) return refuse("has bodies of unequal moments of inertia");
    }
    if (pivot_of(scene, group)) refuse("turns about a pivot, which a table does not see");
    for (const Effect& other : scene.effects) {
      if (!acts_on(other, group)) continue;
      if (other.kind == "added_mass") refuse("takes fluid along (added_mass), which a table does not see");
      if (other.kind == "table" && &other < &effect) refuse("has a table already");
    }
  }

  void check_rotation(const EffectDescription& description, const std::map<std::string, Value>& parameters,
                      const BodyGroup& group) {
    const bool pivots = description.name == "pivot";
    if (pivots && pivot_of(scene, group) != &effect)
      problems.add(path("kind"), "group " + group.name + " has a pivot already");
    if (pivots && !rotates(group)) check_arm(parameters, group);
    if (rotates(group) || pivots || pivot_of(scene, group)) return;
    const auto& reads = description.reads;
    if (std::find(reads.begin(), reads.end(), "spin") != reads.end()) {
      problems.add(path("groups"), description.name + " needs spin, but group " + group.name +
                                       " are particles: expected bodies with a shape or an inertia");
    }
    const auto offset = parameters.find("offset");
    const bool off_centre = offset != parameters.end() && std::get<Vector3d>(offset->second) != Vector3d::Zero();
    if (off_centre) problems.add(path("offset"), "group " + group.name + " are particles, expected an offset of zero");
    if (description.name == "torque")
      problems.add(path("groups"), "group " + group.name + " are particles, which a torque cannot turn");
  }
};

}  // namespace

bool acts_on(const Effect& effect, const BodyGroup& group) {
  return effect.groups.empty() ||
         std::find(effect.groups.begin(), effect.groups.end(), group.name) != effect.groups.end();
}

const Effect* pivot_of(const Scene& scene, const BodyGroup& group) {
  for (const Effect& effect : scene.effects) {
    if (effect.kind == "pivot" && acts_on(effect, group)) return &effect;
  }
  return nullptr;
}

const EffectDescription* find_effect(const std::string& kind) {
  for (const EffectDescription& description : effects()) {
    if (description.name == kind) return &description;
  }
  return nullptr;
}

std::map<std::string, Value> complete_parameters(const Effect& effect, const EffectDescription& description) {
  std::map<std::string, Value> all = effect.parameters;
  for (const ParameterInfo& info : description.parameters) {
    if (info.fallback) all.emplace(info.name, *info.fallback);
    Value& value = all.at(info.name);
    if (info.kind == ParameterKind::vectors && std::holds_alternative<Vector3d>(value)) {
      value = std::vector<Vector3d>{std::get<Vector3d>(value)};
    }
    if (info.kind == ParameterKind::numbers && std::holds_alternative<double>(value)) {
      value = std::vector<double>{std::get<double>(value)};
    }
  }
  return all;
}

void check_effects(const Scene& scene, Problems& problems) {
  for (std::size_t i = 0; i < scene.effects.size(); ++i) EffectCheck{scene, scene.effects[i], i, problems}.run();
}

}  // namespace ballpark
