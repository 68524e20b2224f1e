// What contacts of a scene need: slots of the bodies, walls, and the laws of their materials.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/world/build.h"

namespace ballpark::BALLPARK_PRECISION {

namespace {

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
  scene_.contact.kind == "penalty" ? choose_penalty() : choose_impulse();
  const std::vector<std::string> names = materials_in_use(scene_);
  LawTable& laws = world_.contacts_->scene().laws;
  laws.materials = names.size();
  for (const std::string& a : names) {
    for (const std::string& b : names) {
      const Material law = law_between(scene_, a, b);
      laws.laws.push_back({static_cast<Real>(law.restitution), static_cast<Real>(law.friction),
                           static_cast<Real>(law.restitution_speed), static_cast<Real>(law.cohesion)});
    }
  }
  add_walls(names);
  add_slots(names);
  if (world_.penalty_) start_penalty();
  describe_contacts(names);
}

void Builder::choose_impulse() {
  auto made = std::make_unique<ImpulseStep>();
  world_.impulse_ = made.get();
  const ContactSettings& contact = scene_.contact;
  made->substeps = contact.substeps;
  world_.contact_method_ = world_.method_over(world_.step_ / contact.substeps);
  ImpulseSettings& settings = made->solver.settings;
  settings.substeps = contact.substeps;
  settings.iterations = contact.iterations;
  settings.relax_iterations = contact.relax_iterations;
  settings.margin = static_cast<Real>(contact.margin);
  settings.restitution_threshold = static_cast<Real>(contact.restitution_threshold);
  world_.contacts_ = std::move(made);
}

void Builder::choose_penalty() {
  auto made = std::make_unique<PenaltyStep>();
  world_.penalty_ = made.get();
  const ContactSettings& contact = scene_.contact;
  made->phases = world_.method_.phases;
  made->penalty.returns = world_.adaptive_;
  PenaltySettings& settings = made->penalty.settings;
  settings.stiffness = static_cast<Real>(contact.stiffness);
  settings.slide_stiffness = static_cast<Real>(contact.stiffness * contact.tangential_stiffness);
  settings.margin = static_cast<Real>(contact.margin);
  settings.may_pull = contact.pull;
  world_.contacts_ = std::move(made);
}

/// The step is held against a contact of the two bodies that swing fastest, or of one with a wall.
void Builder::start_penalty() {
  Penalty& penalty = world_.penalty_->penalty;
  penalty.prepare();
  const Penalty::Bound pair = penalty.stiffest_pair();
  world_.watched_stiffness_ = {pair.spring, pair.damping};
  if (world_.status_.code == Status::Code::ok) world_.judge_contacts(world_.watched_stiffness_);
}

void Builder::describe_contacts(const std::vector<std::string>& materials) {
  const ContactSettings& contact = scene_.contact;
  const ContactScene& made = world_.contacts_->scene();
  ContactReport& report = world_.contacts_->report;
  report.kind = contact.kind;
  report.margin = contact.margin;
  report.bodies = made.bodies.count;
  report.walls = made.walls.size();
  report.friction = made.bodies.spins;
  if (world_.impulse_) {
    report.substeps = contact.substeps;
    report.iterations = contact.iterations;
    report.relax_iterations = contact.relax_iterations;
  } else {
    report.stiffness = contact.stiffness;
    report.sliding_stiffness = contact.stiffness * contact.tangential_stiffness;
    report.pull = contact.pull;
  }
  for (std::size_t i = 0; i < materials.size(); ++i) {
    for (std::size_t j = i; j < materials.size(); ++j) {
      const bool of_bodies = std::any_of(scene_.bodies.begin(), scene_.bodies.end(), [&](const BodyGroup& body) {
        return !body.shape.empty() && (body.material == materials[i] || body.material == materials[j]);
      });
      if (!of_bodies) continue;  // boundaries do not meet
      const Material law = law_between(scene_, materials[i], materials[j]);
      const auto name = [](const std::string& material) { return material.empty() ? "(no material)" : material; };
      std::string line =
          fmt::format("{} on {}: restitution {:g}", name(materials[i]), name(materials[j]), law.restitution);
      if (law.restitution_speed > 0) line += fmt::format(" at {:g} m/s", law.restitution_speed);
      line += fmt::format(", friction {:g}", law.friction);
      if (law.cohesion > 0) line += fmt::format(", cohesion {:g} J/m^2", law.cohesion);
      report.laws.push_back(line);
    }
  }
}

void Builder::add_walls(const std::vector<std::string>& materials) {
  ContactScene& made = world_.contacts_->scene();
  for (const Boundary& boundary : scene_.boundaries) {
    if (boundary.shape == "periodic") {
      for (int c = 0; c < 3; ++c) {
        made.period.length[c] = static_cast<Real>(boundary.size[c]);
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
      add_faces(boundary, wall, made.walls);
      continue;
    }
    if (boundary.shape == "plane") wall.shape = plane_through(boundary.point, boundary.normal);
    if (boundary.shape == "box") wall.shape = Box{real(boundary.point), real(boundary.size / 2)};
    if (boundary.shape == "tube") {
      wall.shape =
          Tube{real(boundary.point), real(boundary.normal.stableNormalized()), static_cast<Real>(boundary.radius)};
    }
    made.walls.push_back(wall);
  }
}

/// Slots in the order of ids: copy by copy, group by group as in the scene.
void Builder::add_slots(const std::vector<std::string>& materials) {
  ContactStep& contacts = *world_.contacts_;
  ContactBodies& bodies = contacts.scene().bodies;
  std::vector<std::size_t> touching;
  for (std::size_t g = 0; g < world_.groups_.size(); ++g) {
    const Group& group = world_.groups_[g];
    if (!scene_.bodies[group.scene_index].shape.empty() && group.copies.per_copy > 0) touching.push_back(g);
  }
  for (const std::size_t g : touching) bodies.per_copy += world_.groups_[g].copies.per_copy;
  bodies.resize(bodies.per_copy * world_.copies_, world_.impulse_ != nullptr);
  contacts.ranges = slot_ranges(world_.groups_, touching, world_.copies_);
  for (const SlotRange& range : contacts.ranges) {
    const Group& group = world_.groups_[range.group];
    const BodyGroup& body = scene_.bodies[group.scene_index];
    const bool spins = group.motion != MotionKind::point && has_friction(scene_, body);
    bodies.spins |= spins;
    bodies.turns |= spins && group.turns();
    const auto material =
        static_cast<std::uint16_t>(std::find(materials.begin(), materials.end(), body.material) - materials.begin());
    for (std::size_t k = 0; k < range.count; ++k) {
      const std::size_t i = (range.first_row + k) % group.copies.per_copy, slot = range.first_slot + k;
      const double radius = row_or(body.radius, i, 0.0), moment = inertia_of(body, i).x();
      bodies.radius[slot] = static_cast<Real>(radius);
      bodies.inverse_mass[slot] = static_cast<Real>(1 / (mass_of(body, i) + group.added_mass(range.first_row + k)));
      bodies.mobility[slot] = spins ? static_cast<Real>(radius * radius / moment) : Real(0);
      bodies.material[slot] = material;
    }
  }
  if (bodies.turns && world_.impulse_) bodies.turned.resize(bodies.count);
}

}  // namespace ballpark::BALLPARK_PRECISION
