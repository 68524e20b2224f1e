// What an integrator asks of the forces that it is to follow.
#include <fmt/format.h>

#include <algorithm>

#include "engine/core/nearest.h"
#include "engine/world/check.h"
#include "engine/world/interface.h"

namespace ballpark {

namespace {

const IntegratorDescription* find_integrator(const std::string& name) {
  for (const IntegratorDescription& row : integrators()) {
    if (row.name == name) return &row;
  }
  return nullptr;
}

bool contains(const std::vector<std::string>& words, const std::string& word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

/// Does the force change with velocity? A damper of strength 0 does not.
bool reads_velocity(const Effect& effect, const EffectDescription& description) {
  if (!contains(description.reads, "velocity") && !contains(description.reads, "spin")) return false;
  if (description.name == "pivot") return false;  // turns by its own momentum
  const auto damping = effect.parameters.find("damping");
  const bool damper = std::any_of(description.parameters.begin(), description.parameters.end(),
                                  [](const ParameterInfo& info) { return info.name == "damping"; });
  if (!damper) return true;
  if (damping == effect.parameters.end()) return false;
  if (const auto* one = std::get_if<double>(&damping->second)) return *one != 0;
  const auto* list = std::get_if<std::vector<double>>(&damping->second);
  return list && std::any_of(list->begin(), list->end(), [](double c) { return c != 0; });
}

/// Does it act between all bodies, or between listed pairs?
bool joins_all(const EffectDescription& description) {
  return description.between_bodies &&
         std::none_of(description.parameters.begin(), description.parameters.end(),
                      [](const ParameterInfo& info) { return info.kind == ParameterKind::pairs; });
}

template <class Is>
bool any_law(const Scene& scene, Is is) {
  const std::vector<std::string> names = materials_in_use(scene);
  for (const std::string& a : names) {
    for (const std::string& b : names) {
      if (is(law_between(scene, a, b))) return true;
    }
  }
  return false;
}

bool contacts_rub(const Scene& scene) {
  return any_law(scene, [](const Material& law) { return law.friction > 0; });
}

/// Do penalty contacts lose energy?
bool contacts_read_velocity(const Scene& scene) {
  return any_law(scene, [](const Material& law) { return law.restitution < 1 || law.friction > 0; });
}

}  // namespace

std::string needs_blind_forces(const IntegratorDescription& row, const std::string& reader) {
  return fmt::format(
      "{} is of order {} for forces that do not read velocity{}, but {} reads it; expected another "
      "integrator, e.g. velocity_verlet or rk4",
      row.name, row.order, row.turns_velocity ? " or only turn it" : "", reader);
}

/// Not every family can move orientations by every rule.
void check_rotation(const Scene& scene, const IntegratorDescription& row, Problems& problems) {
  const std::string& rule = scene.run.rotation;
  const bool runge_kutta = row.family == "explicit Runge-Kutta", splits = row.family == "splitting";
  const auto refuse = [&](const std::string& message) { problems.add("run.rotation", rule + message); };
  if (rule == "exponential" && !runge_kutta && !splits) {
    refuse(" needs an explicit Runge-Kutta or splitting integrator, not " + row.name + "; expected renormalise");
  }
  if (rule == "splitting" && !splits) {
    refuse(" needs a splitting integrator, e.g. velocity_verlet, not " + row.name + "; expected another rotation");
  }
  if (rule == "body" && !runge_kutta) {
    refuse(" needs an explicit Runge-Kutta integrator, e.g. rk4, not " + row.name + "; expected another rotation");
  }
  if (rule == "body" && touches(scene) && !scene.contact.kind.empty()) {
    refuse(" leaves out contacts, which turn bodies in the world's axes; expected renormalise or exponential");
  }
  if (scene.run.compensated && (rule == "exponential" || rule == "splitting" || rule == "body")) {
    refuse(" does not carry what rounding takes; expected renormalise, or run.compensated = false");
  }
}

/// Tolerances need an estimate of the error; contacts need steps that begin anew each time.
void check_pace(const Scene& scene, const IntegratorDescription& row, Problems& problems) {
  const bool multistep = row.start_steps > 0, tolerance = scene.run.tolerance != 0;
  if (tolerance && !row.adaptive) {
    std::string pairs;
    for (const IntegratorDescription& other : integrators()) {
      if (other.adaptive) pairs += (pairs.empty() ? "" : ", ") + other.name;
    }
    problems.add("run.integrator",
                 row.name + " has no estimate of its error, which run.tolerance needs; expected one of " + pairs);
  }
  if (!touches(scene) || scene.contact.kind.empty()) return;
  if (scene.contact.kind == "impulse" && (multistep || tolerance)) {
    problems.add(multistep ? "run.integrator" : "run.tolerance",
                 "impulse contacts change velocities at once: expected a one-step integrator and run.step, e.g. rk4");
  }
  if (scene.contact.kind == "penalty" && multistep && contacts_rub(scene)) {
    problems.add("run.integrator", row.name +
                                       " looks back, to before a contact began and its friction with it; expected a "
                                       "one-step integrator, e.g. rk4");
  }
}

/// What all bodies do to each other makes a full matrix.
std::string without_derivatives(const Scene& scene, int stages) {
  constexpr std::size_t most = 1200, of_particle = 6, of_rigid_body = 13;
  if (scene.contact.kind == "penalty" && touches(scene)) return "penalty contacts give no derivatives";
  for (const Effect& effect : scene.effects) {
    if (!joins_all(*find_effect(effect.kind))) continue;
    std::size_t values = 0;
    for (const BodyGroup& group : scene.bodies) {
      if (acts_on(effect, group)) values += body_count(group) * (rotates(group) ? of_rigid_body : of_particle);
    }
    const std::size_t unknowns = values * static_cast<std::size_t>(stages);
    if (unknowns <= most) continue;
    return fmt::format("{} joins {} unknowns, more than the {} that Newton's method is good for", effect.kind, unknowns,
                       most);
  }
  return "";
}

void check_integrator(const Scene& scene, Problems& problems) {
  std::vector<std::string> names;
  for (const IntegratorDescription& row : integrators()) names.push_back(row.name);
  if (!problems.known("run.integrator", "integrator", scene.run.integrator, names)) return;
  const IntegratorDescription& row = *find_integrator(scene.run.integrator);
  const bool penalty = scene.contact.kind == "penalty" && touches(scene);
  const auto refuse = [&](const std::string& message) { problems.add("run.integrator", message); };
  for (const Effect& effect : scene.effects) {
    const EffectDescription* description = find_effect(effect.kind);
    if (!description) continue;  // a problem of its own
    if (description->between_steps && (row.start_steps > 0 || scene.run.tolerance != 0)) {
      problems.add(
          row.start_steps > 0 ? "run.integrator" : "run.tolerance",
          effect.kind + " changes bodies at once between steps: expected a one-step integrator and run.step, e.g. rk4");
    }
    if (row.family == "Taylor" && !description->has_force_derivative && !description->between_steps) {
      refuse("taylor2 needs the time derivative of every force, which " + effect.kind +
             " does not give; expected another integrator, e.g. midpoint");
    }
    if (row.turns_velocity && effect.kind == "added_mass") {
      refuse(row.name +
             " turns velocities by a body's own mass, to which added_mass adds; expected another integrator, e.g. rk4");
    }
    const bool turned = row.turns_velocity && description->turns_velocity;
    if (blind(row) && !turned && reads_velocity(effect, *description)) refuse(needs_blind_forces(row, effect.kind));
    for (const BodyGroup& group : scene.bodies) {
      if (turned && acts_on(effect, group) && pivot_of(scene, group)) {
        refuse(
            fmt::format("{} turns velocities, which the pivot of {} ties, by {}; expected another integrator, e.g. rk4",
                        row.name, group.name, effect.kind));
      }
    }
  }
  check_pace(scene, row, problems);
  check_rotation(scene, row, problems);
  if (row.implicit && penalty && contacts_read_velocity(scene)) {
    refuse(row.name +
           " iterates for its stages where contacts give no derivatives, but a penalty contact with restitution below "
           "1 pushes at once as surfaces meet, and one with friction remembers how it slid; expected neither, or "
           "another integrator, e.g. rk4");
  }
  if (row.adaptive && penalty && scene.run.tolerance > 0 && !f64::estimates_at_end(row.name)) {
    refuse(row.name +
           " has no force at the end of a step in its error: a penalty contact that begins there goes unseen; expected "
           "another adaptive integrator, e.g. dormand_prince8");
  }
  if (row.family == "Taylor" && scene.contact.kind == "penalty") {
    refuse(
        "taylor2 needs the time derivative of every force, which penalty contacts do not give; expected another "
        "integrator, e.g. midpoint");
  }
  if (blind(row) && penalty && contacts_read_velocity(scene)) {
    refuse(needs_blind_forces(row, "a penalty contact with restitution below 1 or friction"));
  }
}

bool blind(const IntegratorDescription& row) {
  return row.family == "splitting" && (row.order > 2 || row.turns_velocity);
}

}  // namespace ballpark
