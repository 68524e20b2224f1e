#include "engine/world/build.h"

#include <algorithm>
#include <cmath>

#include "engine/core/nearest.h"
#include "engine/core/targets.h"

namespace ballpark::BALLPARK_PRECISION {

namespace {

bool all_isotropic(const BodyGroup& group) {
  return std::all_of(group.inertia.begin(), group.inertia.end(),
                     [](const Vector3d& i) { return i.x() == i.y() && i.y() == i.z(); });
}

/// Who needs the spin of this group, or turns it: the name of the first, "" if nobody.
std::string spin_user(const Scene& scene, const BodyGroup& group, const std::vector<UserEffect>& users) {
  for (const Effect& effect : scene.effects) {
    if (!acts_on(effect, group)) continue;
    const int index = local_effect_index(effect.kind);
    if (index < 0) continue;  // effects between bodies pull at their centres
    const EffectInfo& info = local_effects()[static_cast<std::size_t>(index)];
    const auto offset = effect.parameters.find("offset");
    const bool turns = info.exerts("torque") &&
                       (effect.kind == "torque" ||
                        (offset != effect.parameters.end() && std::get<Vector3d>(offset->second) != Vector3d::Zero()));
    if (info.reads("spin") || turns) return effect.kind;
  }
  if (has_friction(scene, group)) return "contact friction";
  for (const UserEffect& user : users) {
    if (user.needs_rotation && acts_on({.kind = {}, .groups = user.groups, .parameters = {}}, group)) return user.name;
  }
  return "";
}

RotationRule rotation_rule(const std::string& word) {
  for (const auto rule : {RotationRule::exponential, RotationRule::splitting, RotationRule::body}) {
    if (word == name(rule)) return rule;
  }
  return RotationRule::renormalise;
}

bool is_kicked_off_centre(const Scene& scene, std::size_t first_id, std::size_t count) {
  return std::any_of(scene.impulses.begin(), scene.impulses.end(), [&](const Impulse& i) {
    return i.offset != Vector3d::Zero() && i.id >= first_id && i.id < first_id + count;
  });
}

}  // namespace

bool turns_by_vector(const Group& group) {
  return with_motion(group.turning, []<class M>() { return M::by_vector; });
}

Builder::Builder(World& world, const Scene& scene, const Options& options)
    : world_(world), scene_(scene), options_(options) {}

void Builder::build() {
  problems_ = ballpark::check(scene_);
  check_options();
  if (!problems_.empty()) throw SceneError(problems_);
  world_.kernels_ = kernel_table(options_.target);
  world_.copies_ = static_cast<std::size_t>(options_.copies);
  world_.row_ = find_row(scene_.run.integrator);
  world_.rotation_ = rotation_rule(scene_.run.rotation);
  for (std::size_t g = 0; g < scene_.bodies.size(); ++g) choose_motion(g);
  choose_path();
  choose_method();
  weave();
  place_groups();
  add_state_columns();
  for (Group& group : world_.groups_) {
    fill_constants(group);
    fill_state(group);
    add_effects(group);
    if (scene_.run.compensated) add_carry(group);
    if (!world_.fused_) add_scratch(group);
    if (world_.fused_) add_rates(group);
    if (world_.adaptive_) add_before(group);
  }
  add_pair_systems();
  add_step_effects();
  check_stability();
  check_orbits();
  check_resolution();
  add_blocks();
  add_implicit();
  add_events();
  add_contacts();
  check_iteration();
}

void Builder::check_options() {
  const auto refuse = [this](const char* what, const std::string& message) { problems_.push_back({what, message}); };
  if (options_.threads < 0) refuse("threads", "is negative, expected a number of threads, or 0 for all cores");
  if (options_.copies < 1) refuse("copies", "is " + std::to_string(options_.copies) + ", expected at least 1");
  if (!std::isfinite(options_.perturb)) refuse("perturb", "is not finite");
  std::vector<std::string> names{"auto"};
  for (const Target& target : known_targets()) names.push_back(target.name);
  if (std::find(names.begin(), names.end(), options_.target) == names.end()) {
    refuse("target", "unknown target \"" + options_.target + "\"" + suggestion(options_.target, names));
  } else if (resolve_target(options_.target).empty()) {
    refuse("target", "this machine cannot run " + options_.target);
  }
  for (const UserEffect& user : world_.users_) {
    for (const std::string& name : user.groups) {
      std::vector<std::string> groups;
      for (const BodyGroup& group : scene_.bodies) groups.push_back(group.name);
      if (std::find(groups.begin(), groups.end(), name) == groups.end()) {
        refuse("user effects", "unknown group \"" + name + "\" of \"" + user.name + "\"" + suggestion(name, groups));
      }
    }
    const bool callable = std::is_same_v<Real, float> ? bool(user.run_single) : bool(user.run_double);
    if (!callable || std::is_same_v<Real, long double>) {
      refuse("user effects", "\"" + user.name + "\" has no function for this precision");
    }
    const auto row = std::find_if(integrators().begin(), integrators().end(),
                                  [&](const auto& known) { return known.name == scene_.run.integrator; });
    if (user.reads_velocity && row != integrators().end() && blind(*row)) {
      refuse("run.integrator", needs_blind_forces(*row, "user effect \"" + user.name + "\""));
    }
    if (scene_.run.integrator == "taylor2") {
      refuse("run.integrator", "taylor2 needs the time derivative of every force, which user effect \"" + user.name +
                                   "\" cannot give; expected another integrator, e.g. midpoint");
    }
  }
  if (options_.path == Path::fused && !world_.users_.empty()) {
    refuse("path", "user effects take the staged path, expected automatic or staged");
  }
  if (options_.path == Path::fused && scene_.contact.kind == "penalty") {
    refuse("path", "penalty contacts take the staged path, expected automatic or staged");
  }
  if (options_.path == Path::fused && pair_effect_of(scene_)) {
    refuse("path", pair_effect_of(scene_)->kind + " takes the staged path, expected automatic or staged");
  }
}

/// The row, scaled by the step; of a pair that has a tolerance, as it will be scaled.
void Builder::choose_method() {
  const RunSettings& run = scene_.run;
  world_.step_ = run.step;
  world_.duration_ = run.duration;
  world_.adaptive_ = run.tolerance > 0;
  if (world_.adaptive_) {
    const double absolute = run.absolute_tolerance > 0 ? run.absolute_tolerance : run.tolerance;
    world_.unit_ = pair_for(*world_.row_, absolute, run.tolerance);
    if (world_.fused_) world_.unit_.last_set = 1;
    world_.keeps_rates_ = scene_.contact.kind != "penalty" &&  // whose first phase sets its springs
                          std::none_of(world_.groups_.begin(), world_.groups_.end(), turns_by_vector);
    world_.control_.order = world_.row_->error_order + 1;
    world_.method_ = world_.unit_;
    return;
  }
  world_.method_ = world_.method_over(world_.step_);
  if (world_.row_->family != Family::multistep) return;
  world_.starter_ = method_for(*find_row(starter_name), world_.step_);
  world_.starter_.family = Family::explicit_runge_kutta;  // which leaves its first rates
  world_.starter_.keeps_first = true;
  if (!world_.fused_) world_.method_.history_begin = std::max(world_.method_.phases, world_.starter_.phases);
}

/// What the group must carry, from what the scene gives and asks for.
void Builder::choose_motion(std::size_t g) {
  const BodyGroup& body = scene_.bodies[g];
  Group group;
  group.name = body.name;
  group.scene_index = g;
  group.copies.per_copy = body_count(body);
  group.id_offset = world_.per_copy_;
  group.live = group.copies.per_copy * world_.copies_;
  world_.per_copy_ += group.copies.per_copy;
  const std::string user = spin_user(scene_, body, world_.users_);
  const bool kicked = is_kicked_off_centre(scene_, group.id_offset, group.copies.per_copy);
  const bool spins = !body.angular_velocity.empty() || kicked ||
                     (body.generate && body.generate->angular_velocity_spread != Vector3d::Zero());
  const bool turns = !body.orientation.empty() || (body.generate && body.generate->random_orientation);
  const auto choose = [&](MotionKind carried, MotionKind motion, const std::string& why) {
    const bool wanted = world_.rotation_ == RotationRule::body, own_axes = wanted && carried == MotionKind::rigid;
    group.carried = own_axes ? MotionKind::body_frame : carried;
    group.turning = stepped(group.carried);
    group.motion = motion == MotionKind::point ? motion : group.turning;
    if (wanted && !own_axes && group.turns()) {
      world_.narrowed_.push_back(body.name + ": not a free body of three moments: angular momentum stays in space");
    }
    group.why = why;
  };
  const auto narrowed = [&](const std::string& what) { world_.narrowed_.push_back(body.name + ": " + what); };
  if (pivot_of(scene_, body)) {
    choose(MotionKind::pivoted, MotionKind::pivoted, "turns about a fixed point (pivot)");
  } else if (!rotates(body)) {
    choose(MotionKind::point, MotionKind::point, "particles: no shape, no inertia");
  } else if (!all_isotropic(body)) {
    if (spins || !user.empty()) {
      choose(MotionKind::rigid, MotionKind::rigid, "three moments of inertia: spin depends on orientation");
    } else {
      choose(turns ? MotionKind::rigid : MotionKind::point, MotionKind::point, "no spin and no torque in this scene");
      narrowed("nothing turns these bodies: no rotation is computed");
    }
  } else if (turns && (spins || !user.empty())) {
    choose(MotionKind::oriented, MotionKind::oriented, "orientation is given, one moment of inertia");
    narrowed("isotropic inertia: no gyroscopic term, w = L / I");
  } else if (!user.empty()) {
    choose(MotionKind::spinning, MotionKind::spinning, "spin is used by " + user);
    narrowed("no orientation: nobody asks for it");
  } else {
    choose(turns   ? MotionKind::oriented
           : spins ? MotionKind::spinning
                   : MotionKind::point,
           MotionKind::point,
           spins ? "spin is given but no torque changes it and no force reads it" : "nothing reads or changes spin");
    narrowed(spins ? "no torque: angular momentum is kept, not integrated" : "no effect needs spin: none is carried");
  }
  world_.groups_.push_back(std::move(group));
}

/// How bodies that turn are stepped: within a step, exponential maps replace quaternions in Runge-Kutta methods.
MotionKind Builder::stepped(MotionKind carried) const {
  if (world_.rotation_ != RotationRule::exponential || world_.row_->family == Family::splitting) return carried;
  switch (carried) {
    case MotionKind::oriented:
      return MotionKind::oriented_exponential;
    case MotionKind::rigid:
      return MotionKind::rigid_exponential;
    case MotionKind::pivoted:
      return MotionKind::pivoted_exponential;
    default:
      return carried;
  }
}

/// Groups that carry more columns come last, so that each column covers one range of rows.
void Builder::place_groups() {
  const auto carries = [](const Group& g) {
    return int(g.spins()) + int(g.turns()) + int(g.carried == MotionKind::body_frame);
  };
  std::stable_sort(world_.groups_.begin(), world_.groups_.end(),
                   [&](const Group& a, const Group& b) { return carries(a) < carries(b); });
  std::size_t row = 0;
  for (Group& group : world_.groups_) {
    group.first_row = row;
    row += padded(group.live);
  }
}

void Builder::add_state_columns() {
  std::vector<Group>& groups = world_.groups_;
  const std::size_t end = groups.empty() ? 0 : groups.back().first_row + padded(groups.back().live);
  const auto first = [&](auto carries) {
    const auto group = std::find_if(groups.begin(), groups.end(), carries);
    return group == groups.end() ? end : group->first_row;
  };
  const std::size_t spinning = first([](const Group& g) { return g.spins(); });
  const std::size_t turning = first([](const Group& g) { return g.turns(); });
  const std::size_t own_axes = first([](const Group& g) { return g.carried == MotionKind::body_frame; });
  Columns& columns = world_.columns_;
  Column& position = columns.add({"position", "m", 3, Role::state, "every body"}, 0, end);
  Column& velocity = columns.add({"velocity", "m/s", 3, Role::state, "every body"}, 0, end);
  const auto add = [&](const char* name, const char* unit, int components, const char* why, std::size_t begin,
                       std::size_t stop) {
    return begin < stop ? &columns.add({name, unit, components, Role::state, why}, begin, stop - begin) : nullptr;
  };
  Column* orientation = add("orientation", "1", 4, "given by the scene, or inertia with three moments", turning, end);
  Column* momentum =
      add("angular_momentum", "kg m^2/s", 3, "spin given by the scene or used by an effect", spinning, own_axes);
  Column* own_momentum = add(body_momentum, "kg m^2/s", 3, "run.rotation: spin in the body's axes", own_axes, end);
  for (Group& group : groups) {
    if (group.live == 0) continue;
    StateColumns& state = group.kernel.state;
    group.kernel.live = group.live;
    for (int c = 0; c < 3; ++c) {
      state.position[c] = position.at(c, group.first_row);
      state.velocity[c] = velocity.at(c, group.first_row);
      if (group.spins())
        state.momentum[c] = (group.first_row < own_axes ? momentum : own_momentum)->at(c, group.first_row);
    }
    for (int c = 0; c < 4 && group.turns(); ++c) {
      state.orientation[c] = orientation->at(c, group.first_row);
      group.kernel.constants.orientation[c] = state.orientation[c];
    }
  }
}

/// Impulses of every copy, and the ends of windows, by time.
void Builder::add_events() {
  for (std::size_t copy = 0; copy < world_.copies_; ++copy) {
    for (Impulse impulse : scene_.impulses) {
      impulse.id += copy * world_.per_copy_;
      world_.add_event({impulse.at, impulse});
    }
  }
  for (Group& group : world_.groups_) {
    for (std::size_t e = 0; e < group.effects.size(); ++e) {
      const EffectInfo& info = local_effects()[e];
      for (std::size_t at = 0; info.window && at < group.effects[e].size(); at += info.constants_size) {
        const Window& window = *info.window(group.effects[e].data() + at);
        for (const double edge : {window.at, window.until}) {
          if (std::isfinite(edge) && edge > 0) world_.add_event({edge, {}});
        }
      }
    }
  }
}

void Builder::choose_path() {
  const bool implicit = world_.row_->family == Family::implicit_runge_kutta;
  if (implicit) {
    world_.not_differentiated_ = world_.users_.empty()
                                     ? without_derivatives(scene_, world_.row_->phases)
                                     : "user effect \"" + world_.users_.front().name + "\" gives no derivatives";
  }
  if (!world_.users_.empty()) {
    world_.fused_ = false;
    world_.path_reason_ = "user effects run as passes of their own";
  } else if (implicit && world_.not_differentiated_.empty()) {
    world_.fused_ = true;
    world_.path_reason_ = "each body, or set of bodies that pull at each other, is solved for its stages at once";
  } else if (const Effect* effect = pair_effect_of(scene_)) {
    world_.fused_ = false;
    world_.path_reason_ = effect->kind + " acts between bodies: their forces are summed in passes of their own";
  } else if (scene_.contact.kind == "penalty") {
    world_.fused_ = false;
    world_.path_reason_ = "penalty contacts are forces between bodies: they are summed in passes of their own";
  } else if (options_.path == Path::staged) {
    world_.fused_ = false;
    world_.path_reason_ = "asked for; every effect is local, so the fused path would give the same bits faster";
  } else {
    world_.fused_ = true;
    world_.path_reason_ = "every effect needs only its own body: one kernel does the whole step in registers";
  }
}

World::World(const Scene& scene, const Options& options, std::vector<UserEffect> user_effects)
    : users_(std::move(user_effects)), workers_(std::max(options.threads, 0)) {
  Builder(*this, scene, options).build();
}

std::unique_ptr<WorldInterface> make_world(const Scene& scene, const Options& options, std::vector<UserEffect> users) {
  return std::make_unique<World>(scene, options, std::move(users));
}

}  // namespace ballpark::BALLPARK_PRECISION
