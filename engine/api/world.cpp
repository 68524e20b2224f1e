// The facade: picks the precision at run time and speaks double.
#include "ballpark/world.h"

#include "engine/world/interface.h"

namespace ballpark {

namespace {

std::string lines(const std::vector<Problem>& problems) {
  std::string text;
  for (const Problem& problem : problems) {
    text += (text.empty() ? "" : "\n") + problem.path + ": " + problem.message;
  }
  return text;
}

std::unique_ptr<WorldInterface> make(Scene scene, const Options& options, std::vector<UserEffect> users) {
  scene.run.precision = options.precision.value_or(scene.run.precision);
  if (scene.run.automatic_step && scene.run.step == 0) {
    scene.run.step = automatic_step(scene);
    scene.run.automatic_step = false;
  }
  switch (scene.run.precision) {
    case Precision::single_:
      return f32::make_world(scene, options, std::move(users));
    case Precision::extended:
      return extended::make_world(scene, options, std::move(users));
    case Precision::double_:
      break;
  }
  return f64::make_world(scene, options, std::move(users));
}

template <class Real>
constexpr Precision precision_of = std::is_same_v<Real, float>    ? Precision::single_
                                   : std::is_same_v<Real, double> ? Precision::double_
                                                                  : Precision::extended;

}  // namespace

SceneError::SceneError(std::vector<Problem> problems)
    : std::runtime_error(lines(problems)), problems_(std::move(problems)) {}

SceneError::SceneError(const std::string& path, const std::string& message)
    : SceneError(std::vector<Problem>{{path, message}}) {}

const char* name(Status::Code code) {
  switch (code) {
    case Status::Code::ok:
      return "ok";
    case Status::Code::full:
      return "full";
    case Status::Code::stability:
      return "stability";
    case Status::Code::accuracy:
      return "accuracy";
    case Status::Code::unconverged:
      return "unconverged";
    case Status::Code::non_finite:
      return "non_finite";
  }
  return "";
}

World::World(const Scene& scene, const Options& options, std::vector<UserEffect> user_effects)
    : world_(make(scene, options, std::move(user_effects))) {}
World::World(World&&) noexcept = default;
World& World::operator=(World&&) noexcept = default;
World::~World() = default;

void World::step(std::uint64_t n) {
  world_->step(n);
}

void World::advance_to(double t, std::uint64_t most_steps) {
  world_->advance_to(t, most_steps);
}

bool World::approach(double t, double end, std::uint64_t most_steps) {
  return world_->approach(t, end, most_steps);
}

void World::look_ahead(double t, const std::function<void()>& look) {
  world_->look_ahead(t, look);
}

double World::time() const {
  return world_->time();
}
std::uint64_t World::steps() const {
  return world_->counters().steps;
}
const Status& World::status() const {
  return world_->status();
}
Counters World::counters() const {
  return world_->counters();
}
std::size_t World::body_count() const {
  return world_->body_count();
}
std::size_t World::row_of(std::size_t id) const {
  return world_->row_of(id);
}

template <class Real>
View<Real> World::view(const std::string& column) const {
  if (precision_of<Real> != world_->precision()) {
    throw SceneError("view",
                     "the world is of another precision, expected view<double> for double, view<float> for single");
  }
  const RawView raw = world_->view(column);
  View<Real> view{raw.first_row, {}};
  for (const void* p : raw.components) view.components.emplace_back(static_cast<const Real*>(p), raw.rows);
  return view;
}
template View<double> World::view<double>(const std::string&) const;
template View<float> World::view<float>(const std::string&) const;
template View<long double> World::view<long double>(const std::string&) const;

double World::constant(const std::string& name, const std::string& group) const {
  return world_->constant(name, group);
}
BodyState World::body(std::size_t id) const {
  return world_->body(id);
}
std::vector<ContactLoad> World::contact_loads() const {
  return world_->contact_loads();
}
void World::set(std::size_t id, const BodyState& state) {
  world_->set(id, state);
}

void World::apply_impulse(std::size_t id, const Vector3d& J, const Vector3d& offset) {
  world_->apply_impulse(id, J, offset);
}
void World::apply_impulse_at(double at, std::size_t id, const Vector3d& J, const Vector3d& offset) {
  world_->schedule_impulse({at, id, J, offset});
}
void World::apply_force(std::size_t id, const Vector3d& F, double at, double until) {
  world_->apply_load("force", id, F, at, until);
}
void World::apply_torque(std::size_t id, const Vector3d& torque, double at, double until) {
  world_->apply_load("torque", id, torque, at, until);
}

Totals World::totals() const {
  return world_->totals();
}
void World::keep_ledger(bool on) {
  world_->keep_ledger(on);
}
Ledger World::ledger() const {
  return world_->ledger();
}
std::uint64_t World::state_hash() const {
  return world_->state_hash();
}
Explanation World::explain() const {
  return world_->explain();
}
Snapshot World::snapshot() const {
  return world_->snapshot();
}
void World::restore(const Snapshot& snapshot) {
  world_->restore(snapshot);
}
void World::profile(bool on) {
  world_->profile(on);
}
std::vector<PassTime> World::pass_times() const {
  return world_->pass_times();
}
Precision World::precision() const {
  return world_->precision();
}
std::string World::target() const {
  return world_->target();
}
int World::threads() const {
  return world_->threads();
}

}  // namespace ballpark
