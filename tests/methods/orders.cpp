// Each row's observed order on smooth scenes: halving the step three times, the two finest slopes.
#include "tests/catch.h"
#include "tests/methods/rows.h"

using namespace ballpark;
using namespace ballpark::tests;

namespace {

/// Steps of the coarsest of four runs: those of a method of order 1, 2 and 4, and between and beyond them.
std::uint64_t coarsest(const IntegratorDescription& row, std::uint64_t first, std::uint64_t second,
                       std::uint64_t fourth) {
  if (row.order == 1) return first;
  const std::uint64_t looks_back = row.start_steps > 0 ? 4 : 1;  // with larger errors
  const std::uint64_t n[] = {first,      first,      second,     8 * fourth,  fourth,     fourth / 2,
                             fourth / 4, fourth / 8, fourth / 8, fourth / 16, fourth / 16};
  return looks_back * n[row.order];
}

/// Rounding of references and of steps that are no binary fractions.
constexpr long double floor_of_errors = 1e-14L;

/// The two finest slopes are within 0.15 of the order, or within 0.3 where rounding begins to show. Of rows of order 5
/// and more, and of those that look back, leading errors cancel here and there: they do no worse than their order.
void has_its_order(const IntegratorDescription& row, const Refinement& refinement) {
  const auto& errors = refinement.errors;
  INFO(row.name << ": " << errors[0] << ", " << errors[1] << ", " << errors[2] << ", " << errors[3]);
  if (row.order >= 5 || row.start_steps > 1) {
    std::size_t halvings = 0;
    while (halvings < 3 && errors[halvings + 1] > floor_of_errors) ++halvings;
    REQUIRE(halvings > 0);
    const long double slope = std::log2(errors[0] / errors[halvings]) / static_cast<long double>(halvings);
    const long double short_range = row.order == 10 ? 1.25L : 0.5L;  // before rounding ends it
    CHECK(slope > row.order - short_range);
    return;
  }
  for (const std::size_t halving : {1U, 2U}) {
    const bool rounded = errors[halving + 1] < 1e-11L;
    CHECK(std::abs(refinement.slope(halving) - row.order) < (rounded ? 0.3L : 0.15L));
  }
}

/// Where bodies turn, splittings of higher order promise the second: their drifts turn bodies by the midpoint rule.
/// Where its errors happen to cancel, they do better.
void has_its_order_turning(const IntegratorDescription& row, const Refinement& refinement) {
  if (row.family != "splitting" || row.order <= 2) return has_its_order(row, refinement);
  const auto& errors = refinement.errors;
  INFO(row.name << ": " << errors[0] << ", " << errors[1] << ", " << errors[2] << ", " << errors[3]);
  CHECK(errors[3] < errors[0]);
  for (const std::size_t halving : {1U, 2U}) {
    if (errors[halving] > 1e-11L) CHECK(refinement.slope(halving) > 1.85L);
  }
}

long double pendulum_error(const World& world) {
  return std::max(std::abs(pendulum_angle(world) - 0.278680673569982948L),
                  std::abs(pendulum_rate(world) + 4.34316069286468305L));
}

/// On the unit orbit: E - e sin E = t by Newton's method.
Numbers on_orbit(long double e, long double t) {
  long double anomaly = t;
  for (int i = 0; i < 50; ++i) anomaly -= (anomaly - e * std::sin(anomaly) - t) / (1 - e * std::cos(anomaly));
  const long double b = std::sqrt(1 - e * e), rate = 1 / (1 - e * std::cos(anomaly));
  return {std::cos(anomaly) - e, b * std::sin(anomaly), -rate * std::sin(anomaly), rate * b * std::cos(anomaly)};
}

long double orbit_error(const World& world, long double e, long double t) {
  const Numbers x = position(world), v = velocity(world);
  return largest_difference({x[0], x[1], v[0], v[1]}, on_orbit(e, t));
}

/// Angle between two orientations [rad], exact for small ones.
long double angle_between(const Numbers& q, const Numbers& reference) {
  long double square = 0;
  for (std::size_t i = 0; i < 4; ++i) square += (q[i] - reference[i]) * (q[i] - reference[i]);
  return 4 * std::asin(std::sqrt(square) / 2);
}

/// Everything that a rigid body's step changes.
Numbers whole_state(const World& world) {
  Numbers all = position(world);
  for (const char* name : {"velocity", "angular_momentum"}) {
    for (const long double value : column(world, name)) all.push_back(value);
  }
  for (const long double value : orientation(world)) all.push_back(value);
  return all;
}

/// Each row's order, against rk4 in extended precision with steps so small that its error does not show.
void keep_their_orders_on(Scene made, std::uint64_t steps_of_fifth_order) {
  constexpr std::uint64_t finest = 65536;
  made.run.step = made.run.duration / finest;
  made.run.integrator = "rk4";
  made.run.precision = Precision::extended;
  World reference(made);
  reference.step(finest);
  const Numbers exact = whole_state(reference);
  made.run.precision = Precision::double_;
  for (const IntegratorDescription& row : integrators_for(made)) {
    // Powers of two divide the duration without rounding, which would show at these orders.
    const std::uint64_t high = row.order >= 8 ? steps_of_fifth_order / 8 : steps_of_fifth_order;
    const std::uint64_t n = row.order >= 5 ? high : coarsest(row, 16000, 1000, 200);
    made.run.integrator = row.name;
    has_its_order_turning(
        row, refine(made, n, [&](const World& world) { return largest_difference(whole_state(world), exact); }));
  }
}

BodyGroup tumbler() {
  BodyGroup group = rigid_body({0.2, 0.3, 0.4}, {1, 2, -1}, {0.6, 0, 0.8, 0});
  group.position = {{1, 0.5, 0.25}};
  return group;
}

std::vector<Effect> resisted_loads() {
  const Effect push{"force", {}, {{"force", Vector3d(0.3, 0.1, 0)}, {"offset", Vector3d(0, 0.1, 0.2)}}};
  const Effect twist{"torque", {}, {{"torque", Vector3d(0.1, -0.2, 0.3)}}};
  return {gravity(), effect("linear_drag", 0.2), effect("quadratic_drag", 0.1), push, twist};
}

}  // namespace

TEST_CASE("order on the pendulum: a particle on a rod", "[methods]") {
  for (const IntegratorDescription& row : integrators()) {
    const std::uint64_t n = coarsest(row, 64000, 8000, 1000);
    has_its_order_turning(row, refine(pendulum(pi / 2, 10, 1, row.name), n, pendulum_error));
  }
}

TEST_CASE("order on the pendulum: a rigid body of the same period", "[methods]") {
  for (const IntegratorDescription& row : integrators()) {
    Scene made = pendulum(pi / 2, 10, 1, row.name);
    made.bodies[0].position = {{0.5, 0, 0}};  // (I + m a^2) / (m a) = 1 m, as for the particle
    made.bodies[0].inertia = {{0.3, 0.25, 0.2}};
    const std::uint64_t n = coarsest(row, 64000, 8000, 1000);
    has_its_order_turning(row, refine(made, n, [](const World& world) {
                            const Numbers x = position(world), v = velocity(world);
                            return std::max(std::abs(std::atan2(x[0], -x[2]) - 0.278680673569982948L),
                                            std::abs((x[0] * v[2] - x[2] * v[0]) / 0.25L + 4.34316069286468305L));
                          }));
  }
}

TEST_CASE("order on the Kepler orbit, e = 0.6", "[methods]") {
  const Numbers known = on_orbit(0.6L, 20);
  CHECK(largest_difference(known, {-0.77007557841124045L, 0.78834481699442439L, -0.8941837319886915L,
                                   -0.12346176415844096L}) < 1e-15L);
  for (const IntegratorDescription& row : integrators()) {
    const std::uint64_t n = coarsest(row, 64000, 8000, 1000);
    has_its_order(
        row, refine(orbit(0.6, 8, 1, row.name), n, [](const World& world) { return orbit_error(world, 0.6L, 8); }));
  }
}

TEST_CASE("order on a body that tumbles freely: the angle to the true orientation", "[methods]") {
  const Numbers reference =
      one_sign({0.401006595702115135L, -0.367493469174623553L, -0.583785903125753275L, 0.602773821287096871L});
  for (const IntegratorDescription& row : integrators()) {
    // Without torque the splitting rows are their drifts: of order 2 at least.
    IntegratorDescription as_rotation = row;
    if (row.family == "splitting") as_rotation.order = 2;
    const std::uint64_t n = coarsest(row.family == "splitting" ? as_rotation : row, 32000, 2000, 500);
    if (row.order > 2) as_rotation = row;
    has_its_order_turning(as_rotation,
                          refine(scene(rigid_body({1, 2, 3}, {1, 0.5, -0.7}), {}, 10, 1, row.name), n,
                                 [&](const World& world) { return angle_between(orientation(world), reference); }));
  }
}

TEST_CASE("order with forces that read velocity: thrown with linear drag", "[methods]") {
  for (const IntegratorDescription& row : integrators()) {
    const Scene made =
        scene(particle(Vector3d::Zero(), {5, 0, 20}), {gravity(), effect("linear_drag", 0.5)}, 3, 1, row.name);
    if (!accepts(made, row.name)) continue;
    has_its_order(row, refine(made, coarsest(row, 300, 300, 30), [](const World& world) {
                    const long double k = 0.5L, g = 9.81L, t = 3, decay = std::exp(-k * t);
                    const long double x = 5 / k * (1 - decay), z = (20 + g / k) / k * (1 - decay) - g * t / k;
                    const long double vx = 5 * decay, vz = (20 + g / k) * decay - g / k;
                    const Numbers p = position(world), v = velocity(world);
                    return largest_difference({p[0], p[2], v[0], v[2]}, {x, z, vx, vz});
                  }));
  }
}

TEST_CASE("order with position and velocity in one force: damped oscillator", "[methods]") {
  for (const IntegratorDescription& row : integrators()) {
    const Scene made = scene(particle({1, 0, 0}), {spring(25, 0.4)}, 10, 1, row.name);
    if (!accepts(made, row.name)) continue;
    const std::uint64_t n = coarsest(row, 64000, 4000, 1000);
    if (!accepts(made, row.name)) continue;
    has_its_order(row, refine(made, n, [](const World& world) {
                    return largest_difference({position(world)[0], velocity(world)[0]},
                                              {0.127439385220689954L, 0.203686033903173761L});
                  }));
  }
}

TEST_CASE("order with forces across the velocity: Magnus lift", "[methods]") {
  for (const IntegratorDescription& row : integrators()) {
    BodyGroup group = ball();
    group.velocity = {{1, 0, 0.5}};
    group.angular_velocity = {{0, 0, -2}};
    const Scene made = scene(std::move(group), {effect("magnus", 3)}, 4, 1, row.name);
    if (!accepts(made, row.name)) continue;
    const std::uint64_t n = coarsest(row, 64000, 2000, 500);
    if (!accepts(made, row.name)) continue;
    has_its_order(row, refine(made, n, [](const World& world) {
                    const Numbers x = position(world), v = velocity(world);
                    return largest_difference({x[0], x[1], v[0], v[1]}, {-0.15092972700110397L, -0.095970165443833837L,
                                                                         0.42417900733699698L, 0.90557836200662385L});
                  }));
  }
}

TEST_CASE("order with quadratic drag", "[methods]") {
  const double angle = 35 * pi / 180;
  for (const IntegratorDescription& row : integrators()) {
    const Scene made = scene(particle(Vector3d::Zero(), {40 * std::cos(angle), 0, 40 * std::sin(angle)}),
                             {gravity(), effect("quadratic_drag", 0.02)}, 3, 1, row.name);
    if (!accepts(made, row.name)) continue;
    const auto error = [](const World& world) {
      const Numbers x = position(world), v = velocity(world);
      return largest_difference({x[0], x[2], v[0], v[2]}, {52.1250704508110414L, 4.68004363794871736L,
                                                           10.1541529990439372L, -11.8648616108535336L});
    };
    const std::uint64_t n = row.order == 10  ? 4
                            : row.order == 8 ? 6
                            : row.order >= 5 ? 30
                                             : coarsest(row, 600, 600, 60);
    has_its_order(row, refine(made, row.start_steps > 1 ? 4 * n : n, error));
  }
}

TEST_CASE("order with every effect at once, on a rigid body that turns", "[methods]") {
  BodyGroup group = tumbler();
  group.velocity = {{0.5, -1, 2}};
  Effect stretched = spring(4, 0.1), softened = attraction();
  stretched.parameters["rest_length"] = 0.75;
  softened.parameters["softening"] = 0.5;
  std::vector<Effect> effects = resisted_loads();
  const Effect charged{"electric_field", {}, {{"charge", 0.5}, {"field", Vector3d(1, 0, -0.5)}}};
  effects.insert(effects.end(), {stretched, softened, effect("magnus", 0.3), charged, magnetic_field(-0.5, {1, 0.5, 0}),
                                 rotating_frame({0.1, -0.2, 0.3}, "on")});
  keep_their_orders_on(scene(group, effects, 2, 1), 128);
}

TEST_CASE("order in a fluid that flows in gusts", "[methods]") {
  BodyGroup group = tumbler();
  group.velocity = {{0.5, -1, 2}};
  group.radius = {0.4};
  const Effect shear{"wind", {}, {{"velocity", Vector3d(2, -1, 0)}, {"shear", Vector3d(0.5, 0, 0)}}};
  const Effect gusts{"gusts", {}, {{"speed", 0.5}, {"length", 30.0}, {"velocity", Vector3d(2, -1, 0)}}};
  const Effect trap{"harmonic_trap", {}, {{"stiffness", Vector3d(2, 3, 1)}}};
  const Effect lift{"buoyancy", {}, {{"density", 0.5}}}, heavier{"added_mass", {}, {{"density", 0.5}}};
  const Effect viscous{"reynolds_drag", {}, {{"density", 0.5}, {"viscosity", 0.05}}};
  keep_their_orders_on(scene(group,
                             {gravity(), shear, gusts, trap, lift, heavier, viscous, effect("linear_drag", 0.2),
                              effect("quadratic_drag", 0.1), effect("magnus", 0.3), effect("spin_decay", 0.05)},
                             3, 1),
                       64);
}

TEST_CASE("order with drag and loads on a rigid body that turns about a pivot off its axes", "[methods]") {
  std::vector<Effect> effects = resisted_loads();
  effects.push_back(pivot());
  keep_their_orders_on(scene(tumbler(), effects, 2, 1), 512);
}
