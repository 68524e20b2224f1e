// What contacts of a scene need: slots of the bodies, walls, and the laws of their materials.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/world/build.h"

namespace ballpark::BALLPARK_PRECISION {

namespace {

constexpr std::size_t range_length = 2048;  // slots of a task

Vector3<Real> real(const Vector3d& a) {
  return {static_cast<Real>(a.x()), static_cast<Real>(a.y()), static_cast<Real>(a.z())};
}

Plane plane_through(const Vector3d& point, const Vector3d& normal) {
  const Vector3d unit = normal.stableNormalized();
  return {real(unit), static_cast<Real>(unit.dot(point))};
}

/// The six faces of a box seen from inside, but those that are open.
void add_faces(const Boundary& box, const Wall& like, std::vector<Wall>& walls) {
  for (int c = 0; c < 3; ++c) {
    for (const double side : {-1.0, 1.0}) {
      const std::string face = std::string(side < 0 ? "-" : "+") + "xyz"[c];
      if (std::find(box.open.begin(), box.open.end(), face) != box.open.end()) continue;
      Vector3d outwards = Vector3d::Zero();
      outwards[c] = side;
      walls.push_back(like);
      walls.back().shape = plane_through(box.point + box.size[c] / 2 * outwards, -outwards);
    }
  }
}

WallMotion motion_of(const Boundary& wall) {
  WallMotion motion;
  if (!wall.motion) return motion;
  for (int c = 0; c < 3; ++c) {
    motion.velocity[c] = wall.motion->velocity[c];
    motion.amplitude[c] = wall.motion->amplitude[c];
  }
  motion.frequency = wall.motion->frequency;
  motion.phase = wall.motion->phase;
  return motion;
}

}  // namespace

bool has_friction(const Scene& scene, const BodyGroup& group) {
  if (!touches(scene) || group.shape.empty()) return false;
  const std::vector<std::string> names = materials_in_use(scene);
  return std::any_of(names.begin(), names.end(),
                     [&](const std::string& other) { return law_between(scene, group.material, other).friction > 0; });
}

void Builder::add_contacts() {
  if (!touches(scene_)) return;
  world_.contacts_ = std::make_unique<ContactStep>();
  ImpulseSolver& solver = world_.contacts_->solver;
  const ContactSettings& contact = scene_.contact;
  world_.contacts_->substeps = contact.substeps;
  world_.contact_method_ = method_for(*world_.row_, world_.step_ / contact.substeps);
  solver.settings.iterations = contact.iterations;
  solver.settings.relax_iterations = contact.relax_iterations;
  solver.settings.margin = static_cast<Real>(contact.margin);
  solver.settings.restitution_threshold = static_cast<Real>(contact.restitution_threshold);
  const std::vector<std::string> names = materials_in_use(scene_);
  solver.laws.materials = names.size();
  for (const std::string& a : names) {
    for (const std::string& b : names) {
      const Material law = law_between(scene_, a, b);
      solver.laws.laws.push_back({static_cast<Real>(law.restitution), static_cast<Real>(law.friction)});
    }
  }
  add_walls(names);
  add_slots(names);
  describe_contacts(names);
}

void Builder::describe_contacts(const std::vector<std::string>& materials) {
  const ContactSettings& contact = scene_.contact;
  const ImpulseSolver& solver = world_.contacts_->solver;
  ContactReport& report = world_.contacts_->report;
  report = {contact.kind,
            contact.substeps,
            contact.iterations,
            contact.relax_iterations,
            contact.margin,
            solver.bodies.count,
            solver.walls.size(),
            solver.bodies.spins,
            {},
            0};
  for (std::size_t i = 0; i < materials.size(); ++i) {
    for (std::size_t j = i; j < materials.size(); ++j) {
      const bool of_bodies = std::any_of(scene_.bodies.begin(), scene_.bodies.end(), [&](const BodyGroup& body) {
        return !body.shape.empty() && (body.material == materials[i] || body.material == materials[j]);
      });
      if (!of_bodies) continue;  // boundaries do not meet
      const Material law = law_between(scene_, materials[i], materials[j]);
      const auto name = [](const std::string& material) { return material.empty() ? "(no material)" : material; };
      report.laws.push_back(fmt::format("{} on {}: restitution {:g}, friction {:g}", name(materials[i]),
                                        name(materials[j]), law.restitution, law.friction));
    }
  }
}

void Builder::add_walls(const std::vector<std::string>& materials) {
  ImpulseSolver& solver = world_.contacts_->solver;
  for (const Boundary& boundary : scene_.boundaries) {
    if (boundary.shape == "periodic") {
      for (int c = 0; c < 3; ++c) {
        solver.period.length[c] = static_cast<Real>(boundary.size[c]);
        world_.contacts_->lower[c] = boundary.point[c] - boundary.size[c] / 2;
      }
      continue;
    }
    Wall wall;
    wall.material = static_cast<std::uint16_t>(std::find(materials.begin(), materials.end(), boundary.material) -
                                               materials.begin());
    wall.motion = motion_of(boundary);
    wall.belt = real(boundary.surface_velocity);
    if (boundary.shape == "box" && boundary.side == "inside") {
      add_faces(boundary, wall, solver.walls);
      continue;
    }
    if (boundary.shape == "plane") wall.shape = plane_through(boundary.point, boundary.normal);
    if (boundary.shape == "box") wall.shape = Box{real(boundary.point), real(boundary.size / 2)};
    if (boundary.shape == "tube") {
      wall.shape =
          Tube{real(boundary.point), real(boundary.normal.stableNormalized()), static_cast<Real>(boundary.radius)};
    }
    solver.walls.push_back(wall);
  }
}

/// Slots in the order of ids: copy by copy, group by group as in the scene.
void Builder::add_slots(const std::vector<std::string>& materials) {
  ContactStep& contacts = *world_.contacts_;
  ContactBodies& bodies = contacts.solver.bodies;
  std::vector<std::size_t> touching;  // in the order of ids
  for (std::size_t g = 0; g < world_.groups_.size(); ++g) {
    const Group& group = world_.groups_[g];
    if (!scene_.bodies[group.scene_index].shape.empty() && group.per_copy > 0) touching.push_back(g);
  }
  std::sort(touching.begin(), touching.end(), [&](std::size_t a, std::size_t b) {
    return world_.groups_[a].scene_index < world_.groups_[b].scene_index;
  });
  for (const std::size_t g : touching) bodies.per_copy += world_.groups_[g].per_copy;
  bodies.resize(bodies.per_copy * world_.copies_);
  std::size_t slot = 0;
  for (std::size_t copy = 0; copy < world_.copies_; ++copy) {
    for (const std::size_t g : touching) {
      const Group& group = world_.groups_[g];
      const BodyGroup& body = scene_.bodies[group.scene_index];
      const bool spins = group.motion != MotionKind::point && has_friction(scene_, body);
      bodies.spins |= spins;
      bodies.turns |= spins && group.turns();
      const auto material =
          static_cast<std::uint16_t>(std::find(materials.begin(), materials.end(), body.material) - materials.begin());
      for (std::size_t first = 0; first < group.per_copy; first += range_length) {
        contacts.ranges.push_back(
            {g, copy * group.per_copy + first, slot + first, std::min(range_length, group.per_copy - first)});
      }
      for (std::size_t i = 0; i < group.per_copy; ++i, ++slot) {
        const double radius = row_or(body.radius, i, 0.0), moment = inertia_of(body, i).x();
        bodies.radius[slot] = static_cast<Real>(radius);
        bodies.inverse_mass[slot] = static_cast<Real>(1 / mass_of(body, i));
        bodies.mobility[slot] = spins ? static_cast<Real>(radius * radius / moment) : Real(0);
        bodies.material[slot] = material;
      }
    }
  }
  if (bodies.turns) bodies.turned.resize(bodies.count);
}

}  // namespace ballpark::BALLPARK_PRECISION
