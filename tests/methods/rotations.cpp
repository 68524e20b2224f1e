// How orientations follow from spins: order, what each rule keeps, and what it is exact for.
#include "tests/catch.h"
#include "tests/methods/turning_scenes.h"

using namespace ballpark;
using namespace ballpark::tests;

namespace {

const Numbers tumbled = {0.401006595702115135L, -0.367493469174623553L, -0.583785903125753275L, 0.602773821287096871L};

/// Between two orientations [rad], exact for small angles.
long double angle_between(const Numbers& a, const Numbers& b) {
  const Numbers q = one_sign(a), r = one_sign(b);
  long double square = 0;
  for (std::size_t i = 0; i < 4; ++i) square += (q[i] - r[i]) * (q[i] - r[i]);
  return 4 * std::asin(std::sqrt(square) / 2);
}
long double tumbling_error(const World& world) {
  return angle_between(column(world, "orientation"), tumbled);
}

long double norm_of(const Numbers& q) {
  return std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
}

struct Case {
  std::string rule, integrator;
  double order;
  std::uint64_t steps;  ///< of the coarsest run
};

void has_slope(const Case& c, const Refinement& refinement) {
  const auto& e = refinement.errors;
  INFO(c.rule << ", " << c.integrator << ": " << e[0] << ", " << e[1] << ", " << e[2] << ", " << e[3]);
  CHECK(std::abs(refinement.slope(1) - c.order) < 0.15L);
  CHECK(std::abs(refinement.slope(2) - c.order) < 0.15L);
}

/// Position and orientation, held against rk4 in extended precision.
void has_slope_on(Scene made, const std::vector<Case>& cases) {
  constexpr std::uint64_t finest = 32768;
  made.run.precision = Precision::extended;
  made.run.step = made.run.duration / finest;
  World reference(by(made, "renormalise", "rk4"));
  reference.step(finest);
  const Numbers x = position(reference), q = column(reference, "orientation");
  for (const Case& c : cases) {
    has_slope(c, refine(by(made, c.rule, c.integrator), c.steps, [&](const World& world) {
                return std::max(largest_difference(position(world), x), angle_between(column(world, "orientation"), q));
              }));
  }
}

}  // namespace

TEST_CASE("P-R1b: the angle of a free body converges at the order of each rotation update", "[methods]") {
  for (const Case& c : std::vector<Case>{{"renormalise", "rk4", 4, 500},
                                         {"exponential", "euler", 1, 32000},
                                         {"exponential", "midpoint", 2, 2000},
                                         {"exponential", "rk3", 3, 1000},
                                         {"exponential", "rk4", 4, 250},
                                         {"exponential", "velocity_verlet", 2, 2000},
                                         {"body", "rk4", 4, 500},
                                         {"body", "midpoint", 2, 2000},
                                         {"splitting", "semi_implicit_euler", 2, 1000},
                                         {"splitting", "velocity_verlet", 2, 1000},
                                         {"splitting", "yoshida4", 4, 500},
                                         {"splitting", "pefrl", 4, 100}}) {
    has_slope(c, refine(by(tumbling(), c.rule, c.integrator), c.steps, tumbling_error));
  }
}

TEST_CASE("P-R1b: rows of order 5 and more keep it under every update that they have", "[methods]") {
  for (const Case& c : std::vector<Case>{{"exponential", "dormand_prince5", 5, 100},
                                         {"exponential", "tsitouras5", 5, 100},
                                         {"exponential", "dormand_prince8", 8, 20},
                                         {"body", "dormand_prince8", 8, 40},
                                         {"splitting", "yoshida6", 6, 100}}) {
    const Refinement r = refine(by(tumbling(), c.rule, c.integrator), c.steps, tumbling_error);
    INFO(c.rule << ", " << c.integrator << ": " << r.errors[0] << ", " << r.errors[1] << ", " << r.errors[2]);
    CHECK(std::log2(r.errors[0] / r.errors[2]) / 2 > c.order - 0.4);
    CHECK(r.errors[2] < 1e-9L);
  }
}

TEST_CASE("rotation updates keep a row's order where forces turn the body", "[methods]") {
  has_slope_on(loaded(true), {{"exponential", "midpoint", 2, 400},
                              {"exponential", "rk4", 4, 100},
                              {"body", "rk4", 4, 100},
                              {"splitting", "velocity_verlet", 2, 400}});
}

TEST_CASE("splittings of higher order are so on bodies that turn, by exact or composed drifts", "[methods]") {
  Scene rod = pendulum(pi / 2, 10, 1);
  const auto error = [](const World& world) {
    return std::max(std::abs(pendulum_angle(world) - 0.278680673569982948L),
                    std::abs(pendulum_rate(world) + 4.34316069286468305L));
  };
  for (const Case& c : std::vector<Case>{{"splitting", "velocity_verlet", 2, 8000},
                                         {"splitting", "ruth3", 3, 4000},
                                         {"splitting", "forest_ruth", 4, 2000},
                                         {"splitting", "yoshida4", 4, 2000},
                                         {"splitting", "pefrl", 4, 1000},
                                         {"splitting", "yoshida6", 6, 200}}) {
    rod.run.precision = Precision::extended;
    has_slope(c, refine(by(rod, c.rule, c.integrator), c.steps, error));
  }
  BodyGroup off_axes = rigid_body({0.2, 0.3, 0.4}, {1, 2, -1}, {0.6, 0, 0.8, 0});
  off_axes.position = {{1, 0.5, 0.25}};
  has_slope_on(
      scene(off_axes, {gravity(), pivot()}, 2, 1),
      {{"splitting", "velocity_verlet", 2, 800}, {"splitting", "yoshida4", 4, 200}, {"exponential", "rk4", 4, 100}});
}

TEST_CASE("P-R1b: Lie-group updates keep the quaternion's length, and L to the last bit", "[methods]") {
  for (const auto& [rule, integrator] :
       std::vector<std::pair<std::string, std::string>>{{"exponential", "rk4"},
                                                        {"exponential", "euler"},
                                                        {"exponential", "velocity_verlet"},
                                                        {"splitting", "velocity_verlet"},
                                                        {"splitting", "yoshida6"}}) {
    INFO(rule << ", " << integrator);
    World world(by(tumbling(), rule, integrator));
    const Numbers L = column(world, "angular_momentum");
    for (int n = 0; n < 2000; ++n) {
      world.step();
      REQUIRE(std::abs(norm_of(column(world, "orientation")) - 1) < 4e-16L);
    }
    CHECK(largest_difference(column(world, "angular_momentum"), L) == 0);
  }
}

TEST_CASE("P-R1b: Strang splitting keeps the energy within a band that shrinks with h^2", "[methods]") {
  const auto band = [](double h, int periods, int first) {
    Scene made = by(tumbling(), "splitting", "velocity_verlet");
    made.run.step = h;
    World world(made);
    const double before = world.totals().kinetic, period = 11.1823954296029494;
    world.advance_to(first * period);
    double most = 0;
    const auto steps = static_cast<int>(periods * period / h);
    for (int n = 0; n < steps; ++n) {
      world.step();
      most = std::max(most, std::abs(world.totals().kinetic / before - 1));
    }
    return most;
  };
  const double early = band(0.1, 20, 0), late = band(0.1, 20, 10000), fine = band(0.05, 20, 0);
  INFO(early << " " << late << " " << fine);
  CHECK(early < 2e-3);
  CHECK(std::abs(late / early - 1) < 0.02);
  CHECK(std::abs(early / fine - 4) < 0.1);
}

TEST_CASE("X10: a fast steady spin by the exponential map is exact for 1e7 steps", "[methods]") {
  BodyGroup group = ball();
  group.orientation = {Quaternion{}};
  group.angular_velocity = {{0, 0, 1e4}};
  World world(by(scene(group, {}, 1000, 1e-4), "exponential", "rk4"));
  world.step(10000000);
  const Numbers q = column(world, "orientation");
  CHECK(std::abs(norm_of(q) - 1) < 1e-14L);
  const long double turned = 2 * std::atan2(q[3], q[0]), wanted = std::remainder(1e7L, 2 * std::acos(-1.0L));
  CHECK(std::abs(std::remainder(turned - wanted, 2 * std::acos(-1.0L))) < 1e-7L);
}

TEST_CASE("free rotation by splitting is exact for balls and bodies with an axis of symmetry", "[methods]") {
  for (const Vector3d& inertia : {Vector3d(2, 2, 2), Vector3d(2, 2, 0.5), Vector3d(0.5, 2, 2), Vector3d(2, 3.5, 2)}) {
    INFO(inertia.transpose());
    const Scene made = scene(rigid_body(inertia, {1, -2, 3}, {0.6, 0, 0.8, 0}), {}, 10, 0.5, "velocity_verlet");
    World coarse(by(made, "splitting", "velocity_verlet"));
    coarse.step(20);
    Scene exact = by(made, "exponential", "dormand_prince8");
    exact.run.precision = Precision::extended;
    exact.run.step = 0.0025;
    World fine(exact);
    fine.step(4000);
    CHECK(angle_between(column(coarse, "orientation"), column(fine, "orientation")) < 1e-13L);
  }
}

TEST_CASE("X11: a needle keeps its spin in its own axes, and loses digits of it in space", "[methods]") {
  const Vector3d needle(1e-6, 1, 1);
  const Numbers exact = {100, 0.446866186873894693L, -0.300517239154071537L};
  Scene made = scene(rigid_body(needle, {100, 0.5, 0.2}), {}, 10, 1, "dormand_prince8");
  made.run.step = 0;
  made.run.tolerance = 1e-12;
  World space(made);
  space.advance_to(10);
  CHECK(largest_difference(body_spin(space, needle), exact) < 1e-4L);
  World own(by(made, "body", "dormand_prince8"));
  own.advance_to(10);
  Numbers spin = column(own, "body_angular_momentum");
  for (std::size_t c = 0; c < 3; ++c) spin[c] /= needle[static_cast<Eigen::Index>(c)];
  CHECK(std::abs(spin[0] - exact[0]) < 1e-8L);
  CHECK(largest_difference(spin, exact) < 1e-8L);
}
