// Local effects on a group: what they make of their parameters, the mass that they add, and how stiff they are.
#include <algorithm>
#include <cmath>

#include "engine/world/build.h"

namespace ballpark::BALLPARK_PRECISION {

std::vector<double> numbers_of(const Effect& effect) {
  std::vector<double> numbers;
  for (const auto& [name, value] : complete_parameters(effect, *find_effect(effect.kind))) {
    if (const auto* number = std::get_if<double>(&value)) numbers.push_back(*number);
    if (const auto* vector = std::get_if<Vector3d>(&value))
      numbers.insert(numbers.end(), vector->data(), vector->data() + 3);
    if (const auto* rows = std::get_if<std::vector<Vector3d>>(&value)) {
      for (const Vector3d& row : *rows) numbers.insert(numbers.end(), row.data(), row.data() + 3);
    }
    if (const auto* word = std::get_if<std::string>(&value)) numbers.insert(numbers.end(), word->begin(), word->end());
    if (const auto* list = std::get_if<std::vector<double>>(&value)) {
      numbers.insert(numbers.end(), list->begin(), list->end());
    }
    if (const auto* pairs = std::get_if<std::vector<IdPair>>(&value)) {
      for (const IdPair& pair : *pairs) numbers.insert(numbers.end(), pair.begin(), pair.end());
    }
  }
  return numbers;
}

namespace {

/// The effects on a group in an order that does not depend on the scene's.
std::vector<Effect> sorted_effects(const Scene& scene, const BodyGroup& body) {
  std::vector<Effect> effects;
  for (const Effect& effect : scene.effects) {
    if (acts_on(effect, body)) effects.push_back(effect);
  }
  std::stable_sort(effects.begin(), effects.end(),
                   [](const Effect& a, const Effect& b) { return numbers_of(a) < numbers_of(b); });
  return effects;
}

/// At the start, relative to what flows there.
double largest_speed(const Group& group) {
  Real most = 0;
  for (std::size_t row = 0; row < group.live; ++row) {
    const StateColumns& state = group.kernel.state;
    Body<Real> at{row, 0, {}, {}, {}};
    at.position = {state.position[0][row], state.position[1][row], state.position[2][row]};
    at.velocity = {state.velocity[0][row], state.velocity[1][row], state.velocity[2][row]};
    const Vector3<Real> v = at.velocity - group.kernel.forces.flow(at, 0);
    most = std::max(most, dot(v, v));
  }
  return std::sqrt(static_cast<double>(most));
}

}  // namespace

/// Constants of every effect, then what follows from all of them together.
void Builder::add_effects(Group& group) {
  const BodyGroup& body = scene_.bodies[group.scene_index];
  const std::vector<Effect> effects = sorted_effects(scene_, body);
  std::optional<PerBody> radius;
  for (const Effect& effect : effects) {
    const int index = local_effect_index(effect.kind);
    if (index < 0 || group.live == 0) continue;
    const EffectInfo& info = local_effects()[static_cast<std::size_t>(index)];
    const auto parameters = complete_parameters(effect, info.description);
    const auto per_body = [&](const std::string& name, const std::vector<Vector3d>& rows) {
      PerBody out[3];
      constant(group, (effect.kind + "." + name).c_str(), "m", out, effect.kind.c_str(), [&](std::size_t row) {
        const Vector3d v = row_or(rows, group.copies.index_of(row), Vector3d(0, 0, 0));
        return std::array<Wide, 3>{v.x(), v.y(), v.z()};
      });
      return std::array<PerBody, 3>{out[0], out[1], out[2]};
    };
    if (info.reads("radius") && !radius) {
      PerBody out[1];
      constant(group, "radius", "m", out, effect.kind.c_str(), [&](std::size_t row) {
        return std::array<Wide, 1>{row_or(body.radius, group.copies.index_of(row), 0.0)};
      });
      radius = out[0];
    }
    std::vector<std::byte>& instances = group.effects[static_cast<std::size_t>(index)];
    instances.resize(instances.size() + info.constants_size);
    info.pack({parameters, 0, per_body, 0, radius.value_or(PerBody{}), {}, group.kernel.constants.inverse_inertia[0]},
              instances.data() + instances.size() - info.constants_size);
  }
  group.list_instances();
  group.kernel.forces.turning_apart = world_.row_->turns_velocity;
  if (group.live == 0 || group.pivots()) return;
  add_effective_mass(group);
  add_stiffness(group, effects);
}

void Builder::add_effective_mass(Group& group) {
  if (group.added_mass(0) == 0) return;
  const BodyGroup& body = scene_.bodies[group.scene_index];
  PerBody mass[1];
  constant(group, "effective_mass", "kg", mass, "added_mass", [&](std::size_t row) {
    return std::array<Wide, 1>{mass_of(body, group.copies.index_of(row)) + Wide(group.added_mass(row))};
  });
  group.kernel.constants.effective_mass = mass[0];
  if (!mass[0].rows) group.constants.emplace_back("effective_mass", static_cast<double>(mass[0].value));
}

/// Of all effects together, over the least mass and the least moment of inertia.
void Builder::add_stiffness(Group& group, const std::vector<Effect>& effects) {
  const BodyGroup& body = scene_.bodies[group.scene_index];
  const bool alike = std::max({body.mass.size(), body.radius.size(), body.density.size()}) < 2;
  std::vector<EffectInput::Size> sizes;
  double resisting = std::numeric_limits<double>::infinity(), share = 0;  // of it, a body's own mass: the most
  for (std::size_t i = 0; i < (alike ? 1 : group.copies.per_copy); ++i) {
    const double mass = mass_of(body, i), all = mass + group.added_mass(group.copies.row_of(0, i));
    sizes.push_back({row_or(body.radius, i, 0.0), all});
    share = std::max(share, mass / all);
    resisting = std::min(resisting, all);
  }
  Stiffness sum;
  const double speed = largest_speed(group);
  for (const Effect& effect : effects) {
    const int index = local_effect_index(effect.kind);
    if (index < 0 || !local_effects()[static_cast<std::size_t>(index)].stiffness) continue;
    const EffectInfo& info = local_effects()[static_cast<std::size_t>(index)];
    const auto parameters = complete_parameters(effect, info.description);
    sum = sum + info.stiffness({parameters, speed, {}, share * resisting, {}, sizes});
  }
  local_stiffness_.push_back({&group, sum / resisting});
  if (sum.turning == 0) return;
  double moment = std::numeric_limits<double>::infinity();
  for (const Vector3d& inertia : group.inertia) moment = std::min(moment, inertia.minCoeff());
  spin_damping_.push_back({&group, sum.turning / moment});
}

}  // namespace ballpark::BALLPARK_PRECISION
