#include "scenarios/view/shown.h"

#include <algorithm>
#include <map>
#include <numbers>

namespace ballpark::view {
namespace {

/// A list has no row (the default), one for all, or one for each.
template <class T>
T row_of(const std::vector<T>& list, std::size_t row, const T& fallback) {
  return list.empty() ? fallback : list[list.size() == 1 ? 0 : row];
}

Inertia inertia_of(const BodyGroup& group, std::size_t row) {
  const double radius = row_of(group.radius, row, 0.0);
  const double volume = 4 * std::numbers::pi / 3 * radius * radius * radius;
  Inertia inertia;
  inertia.mass = group.mass.empty() ? row_of(group.density, row, 0.0) * volume : row_of(group.mass, row, 0.0);
  const Vector3d of_ball = Vector3d::Constant(0.4 * inertia.mass * radius * radius);
  inertia.moments = row_of(group.inertia, row, group.shape == "sphere" ? of_ball : Vector3d::Zero().eval());
  return inertia;
}

}  // namespace

std::vector<std::size_t> group_counts(const Scene& scene, const World& world, int copies) {
  std::map<std::string, std::size_t> by_name;
  for (const GroupReport& group : world.explain().groups) {
    by_name[group.name] = group.bodies / static_cast<std::size_t>(copies);
  }
  std::vector<std::size_t> counts;
  for (const BodyGroup& group : scene.bodies) counts.push_back(by_name[group.name]);
  return counts;
}

ShownBodies shown_bodies(const Scene& scene, const World& world, int copies, std::size_t most) {
  ShownBodies shown;
  shown.stride = std::max<std::size_t>(1, (world.body_count() + most - 1) / most);
  const std::vector<std::size_t> counts = group_counts(scene, world, copies);
  const std::size_t per_copy = world.body_count() / static_cast<std::size_t>(copies);
  std::size_t first_id = 0;
  for (std::size_t g = 0; g < counts.size(); ++g) {
    const BodyGroup& group = scene.bodies[g];
    if (counts[g] == 0) continue;
    ShownGroup part{group.name, shown.ids.size(), 0, {}, false};
    for (std::size_t i = 0; i < counts[g] * static_cast<std::size_t>(copies); i += shown.stride) {
      const std::size_t row = i % counts[g];
      shown.ids.push_back(i / counts[g] * per_copy + first_id + row);
      shown.inertias.push_back(inertia_of(group, row));
      if (group.radius.size() > 1) part.radius.push_back(group.radius[row]);
    }
    if (group.radius.size() == 1) part.radius = group.radius;
    part.count = shown.ids.size() - part.first;
    part.turns = world.body(shown.ids[part.first]).has_orientation;
    shown.groups.push_back(part);
    first_id += counts[g];
  }
  return shown;
}

void let_spinning_balls_turn(Scene& scene, const Options& options) {
  const World world(scene, options);
  const std::vector<std::size_t> counts = group_counts(scene, world, options.copies);
  Scene turning = scene;
  std::size_t first_id = 0;
  for (std::size_t g = 0; g < counts.size(); ++g) {
    if (counts[g] > 0) {
      const BodyState body = world.body(first_id);
      if (body.has_angular_velocity && !body.has_orientation) turning.bodies[g].orientation = {Quaternion{}};
    }
    first_id += counts[g];
  }
  if (check(turning).empty()) scene = turning;
}

}  // namespace ballpark::view
