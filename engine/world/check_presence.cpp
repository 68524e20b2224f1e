// Bodies that come and go: what does not fit with them.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/core/nearest.h"
#include "engine/world/check.h"

namespace ballpark {

namespace {

bool contains(const std::vector<std::string>& words, const char* word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

/// The effect, if bodies enter or leave by it.
const EffectDescription* opening(const Effect& effect) {
  const EffectDescription* description = find_effect(effect.kind);
  return description && description->between_steps && contains(description->exerts, "present") ? description : nullptr;
}

struct PresenceCheck {
  const Scene& scene;
  Problems& problems;

  void run() {
    bool open = false;
    for (std::size_t i = 0; i < scene.effects.size(); ++i) {
      const EffectDescription* description = opening(scene.effects[i]);
      if (!description) continue;
      open = true;
      if (scene.effects[i].kind == "emitter") check_emitter(i, *description);
      if (scene.effects[i].kind == "outlet") check_box(i);
    }
    if (!open) return;
    for (std::size_t i = 0; i < scene.effects.size(); ++i) check_partner(i);
    for (const IntegratorDescription& row : integrators()) {
      if (row.name != scene.run.integrator || !row.implicit) continue;
      problems.add("run.integrator", row.name +
                                         " solves for the stages of bodies that may not be there: expected an "
                                         "explicit integrator where bodies enter or leave, e.g. rk4");
    }
  }

  static std::string path(std::size_t i, const char* key) { return path_of("effects", i, key); }

  double number(const Effect& effect, const EffectDescription& description, const char* name) const {
    const auto given = effect.parameters.find(name);
    if (given != effect.parameters.end()) {
      const double* value = std::get_if<double>(&given->second);
      return value ? *value : NAN;  // a problem of its own
    }
    for (const ParameterInfo& info : description.parameters) {
      if (info.name == name && info.fallback) return std::get<double>(*info.fallback);
    }
    return NAN;
  }

  /// A group holds all bodies that ever enter.
  void check_emitter(std::size_t i, const EffectDescription& description) {
    const Effect& effect = scene.effects[i];
    const double every = number(effect, description, "every"), at = number(effect, description, "at");
    const double end = std::min(scene.run.duration, number(effect, description, "until"));
    for (const BodyGroup& group : scene.bodies) {
      if (!acts_on(effect, group)) continue;
      for (std::size_t other = 0; other < i; ++other) {
        if (scene.effects[other].kind != "emitter" || !acts_on(scene.effects[other], group)) continue;
        problems.add(path(i, "groups"), "group " + group.name + " has an emitter already, expected other groups");
        break;
      }
      const double due = every > 0 && end >= at ? 1 + std::floor((end - at) / every * (1 + 1e-12)) : 0;
      const std::size_t room = body_count(group);
      if (!(due > static_cast<double>(room)) || room == 0) continue;
      problems.add(path(i, "every"),
                   fmt::format("{} bodies would enter by {} s, but group {} has {}: expected more "
                               "bodies, or until < {} s",
                               due, text(end), group.name, room, text(at + every * static_cast<double>(room))));
    }
  }

  void check_box(std::size_t i) {
    const auto& parameters = scene.effects[i].parameters;
    const auto found = parameters.find("size");
    const auto* size = found == parameters.end() ? nullptr : std::get_if<Vector3d>(&found->second);
    if (size && size->allFinite() && !(size->minCoeff() > 0))
      problems.add(path(i, "size"), "has a length <= 0, expected a box's lengths > 0 [m]");
  }

  /// What names bodies, or sums over all of them, must have them all.
  void check_partner(std::size_t i) {
    const Effect& effect = scene.effects[i];
    const EffectDescription* description = find_effect(effect.kind);
    if (!description || !description->between_bodies) return;
    const auto& parameters = description->parameters;
    if (std::any_of(parameters.begin(), parameters.end(), [](const auto& p) { return p.name == "cutoff"; })) return;
    for (const BodyGroup& group : scene.bodies) {
      if (!acts_on(effect, group)) continue;
      for (const Effect& other : scene.effects) {
        if (!opening(other) || !acts_on(other, group)) continue;
        problems.add(path(i, "groups"), effect.kind + " acts between all bodies of group " + group.name +
                                            ", which enter or leave (" + other.kind + "): expected other groups");
        return;
      }
    }
  }
};

}  // namespace

void check_presence(const Scene& scene, Problems& problems) {
  PresenceCheck{scene, problems}.run();
}

}  // namespace ballpark
