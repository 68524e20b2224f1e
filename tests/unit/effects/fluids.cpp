// Fluids and traps: each force against its formula, and as in forces.cpp.
#include <vector>

#include "tests/unit/effects/effect_checks.h"

using namespace effect_checks;

namespace {

constexpr double pi = 3.14159265358979323846;
constexpr double radius = 0.2, volume = 4 / 3.0 * pi * radius * radius * radius;
const Value along = Vector3d(1, -2, 0.5);

/// Under drag and lift in what flows.
struct InFlow {
  std::vector<EffectInstance> instances;
  LocalForces forces;

  InFlow(const EffectInstance& flow, std::vector<EffectInstance> pushing, double start)
      : instances(std::move(pushing)) {
    instances.push_back(flow);
    forces.begin = instances.data();
    forces.flow_end = forces.begin + instances.size();
    forces.end = forces.flow_begin = forces.flow_end - 1;
    forces.start = start;
  }
};

EffectInstance instance(const char* name, const void* constants) {
  return {local_effect_index(name), constants};
}

/// The rate of the flow at the body as a difference along its path.
void check_flow_rate(const LocalForces& forces, double time) {
  const double t = 1e-5;
  const Vector difference = forces.flow(later(t), time + t) - forces.flow(later(-t), time - t);
  CHECK(near(forces.flow_rate(body, time), (1 / (2 * t)) * difference, 1e-8));
}

/// Drag and lift of velocity relative to the flow, and their rates with it.
void check_in_flow(const EffectInstance& flow) {
  const LinearDrag::Constants linear{0.5};
  const QuadraticDrag::Constants quadratic{0.25};
  const Magnus::Constants lift{2};
  const Gravity::Constants fall{{0.1, 0.2, -9}};
  const double start = 0.7, after = 0.3;
  const InFlow all(flow,
                   {instance("gravity", &fall), instance("linear_drag", &linear),
                    instance("quadratic_drag", &quadratic), instance("magnus", &lift)},
                   start);
  Body<Real> through = body;
  through.velocity -= all.forces.flow(body, start + after);
  Loads<Real> expected;
  Gravity::force(fall, body, expected);
  LinearDrag::force(linear, through, expected);
  QuadraticDrag::force(quadratic, through, expected);
  Magnus::force(lift, through, expected);
  const Loads<Real> found = all.forces.loads(body, after);
  CHECK(near(found.force, expected.force, 0));
  check_flow_rate(all.forces, start);
  const double t = 1e-5;
  const Vector difference = all.forces.loads(later(t), t).force - all.forces.loads(later(-t), -t).force;
  CHECK(near(all.forces.load_rates(body, bend).force, (1 / (2 * t)) * difference, 1e-8));
}

}  // namespace

TEST_CASE("Effects: a harmonic trap along each axis", "[effects]") {
  const auto c = packed<HarmonicTrap>({{"centre", along}, {"stiffness", Vector3d(4, 0, -3)}});
  CHECK(near(loads<HarmonicTrap>(c, body).force, {-4 * (0.3 - 1), 0, 3 * (1.1 - 0.5)}, 1e-15));
  CHECK(std::abs(HarmonicTrap::energy(c, body) - (2 * 0.49 - 1.5 * 0.36)) < 1e-14);
  check_energy<HarmonicTrap>(c);
  check_force_rate<HarmonicTrap>(c);
  const std::map<std::string, Value> parameters{{"stiffness", Vector3d(4, 0, -3)}};
  CHECK(HarmonicTrap::stiffness(EffectInput{parameters, 0, {}}).spring == 4);
}

TEST_CASE("Effects: spin decay", "[effects]") {
  const auto c = packed<SpinDecay>({{"coefficient", 0.5}});
  CHECK(near(loads<SpinDecay>(c, body).torque, {-1.5, 0.5, -0.25}, 1e-15));
  CHECK(near(loads<SpinDecay>(c, body).force, {}, 0));
  check_force_rate<SpinDecay>(c);
  const std::map<std::string, Value> parameters{{"coefficient", 0.5}};
  CHECK(SpinDecay::stiffness(EffectInput{parameters, 0, {}}).turning == 0.5);
  CHECK_FALSE(SpinDecay::stiffness(EffectInput{parameters, 0, {}}).any());
}

TEST_CASE("Effects: buoyancy is the weight of what is displaced, upwards", "[effects]") {
  const auto c = packed<Buoyancy>({{"density", 1000.0}, {"acceleration", along}});
  const double mass = 1000 * volume;
  CHECK(near(loads<Buoyancy>(c, body).force, {-mass, 2 * mass, -mass / 2}, 1e-14));
  check_energy<Buoyancy>(c);
  check_force_rate<Buoyancy>(c);
}

TEST_CASE("Effects: added mass is half of what is displaced, and has its kinetic energy", "[effects]") {
  const auto c = packed<AddedMass>({{"density", 1000.0}, {"coefficient", 0.5}});
  const double mass = 500 * volume;
  CHECK(std::abs(AddedMass::added_mass<Real>(c, 0) / mass - 1) < 1e-14);
  const double square = 1.5 * 1.5 + 0.25 * 0.25 + 4;
  CHECK(std::abs(AddedMass::energy(c, body) / (mass / 2 * square) - 1) < 1e-14);
  CHECK_FALSE(effect_info<AddedMass>().pushes);
}

TEST_CASE("Effects: drag by the Reynolds number is Schiller and Naumann's", "[effects]") {
  const double speed = std::sqrt(1.5 * 1.5 + 0.25 * 0.25 + 4), density = 1.2;
  for (const double reynolds : {1e-6, 0.1, 1.0, 37.5, 999.0, 1001.0, 1e6}) {
    const double viscosity = 2 * radius * density * speed / reynolds;
    const auto c = packed<ReynoldsDrag>({{"density", density}, {"viscosity", viscosity}});
    const double coefficient = reynolds < 1000 ? 24 / reynolds * (1 + 0.15 * std::pow(reynolds, 0.687)) : 0.44;
    const double drag = coefficient * density / 2 * pi * radius * radius * speed;
    CAPTURE(reynolds);
    CHECK(near((1 / drag) * loads<ReynoldsDrag>(c, body).force, -1.0 * body.velocity, 1e-14));
    check_force_rate<ReynoldsDrag>(c);
    const std::map<std::string, Value> parameters{{"density", density}, {"viscosity", viscosity}};
    const EffectInput input{parameters, speed, {}, body.mass, {}, {{radius / 3, 5.0}, {radius, 2.5}}};
    Body<Real> faster = body;
    faster.velocity = (1 + 1e-6) * body.velocity;
    const Vector change = loads<ReynoldsDrag>(c, faster).force - loads<ReynoldsDrag>(c, body).force;
    CHECK(std::abs(ReynoldsDrag::stiffness(input).damping * 1e-6 * speed / length(change) - 1) < 1e-5);
  }
  const auto c = packed<ReynoldsDrag>({{"density", density}, {"viscosity", 0.1}});
  Body<Real> still = body;
  still.velocity = {};
  Loads<Real> rate;
  ReynoldsDrag::force_rate(c, still, bend, rate);
  CHECK(near(loads<ReynoldsDrag>(c, still).force, {}, 0));
  CHECK(near(rate.force, (-6 * pi * 0.1 * radius) * bend.linear, 1e-14));
}

TEST_CASE("Effects: drag and lift read velocity relative to the wind, uniform and sheared", "[effects]") {
  for (const Vector3d& shear : {Vector3d(0, 0, 0), Vector3d(0.5, -0.25, 0)}) {
    const auto c = packed<Wind>({{"velocity", Vector3d(8, -3, 0.5)}, {"shear", shear}, {"height", 2.0}});
    const EffectInstance wind = instance("wind", &c);
    const double above = 1.1 - 2;
    const Vector expected = {8 + above * shear.x(), -3 + above * shear.y(), 0.5};
    CHECK(near(InFlow(wind, {}, 0).forces.flow(body, 0), expected, 1e-15));
    check_in_flow(wind);
  }
}

TEST_CASE("Effects: gusts are as strong as asked, do not swell, and go with the wind", "[effects]") {
  const Vector3d carried(5, -2, 1);
  const auto make = [&](double seed) {
    return packed<Gusts>({{"speed", 1.5}, {"length", 4.0}, {"velocity", carried}, {"seed", seed}});
  };
  const auto c = make(3), other = make(4);
  CHECK_FALSE(near(Gusts::flow(c, body, 0), Gusts::flow(other, body, 0), 1e-3));
  Body<Real> ahead = body;
  const double time = 1234.5;
  ahead.position += time * Vector{carried.x(), carried.y(), carried.z()};
  CHECK(near(Gusts::flow(c, ahead, time), Gusts::flow(c, body, 0), 1e-11));
  Real square = 0;
  for (const Gusts::PlaneWave& wave : c.waves) {
    CHECK(std::abs(dot(wave.number, wave.amplitude)) < 1e-15 * 16);  // so that no fluid piles up
    square += dot(wave.amplitude, wave.amplitude) / 2;
  }
  CHECK(std::abs(square / (3 * 1.5 * 1.5) - 1) < 1e-14);
  CHECK(std::abs(length(c.waves[0].number) * 4 - 1) < 1e-14);
  CHECK(std::abs(length(c.waves[7].number) * 4 / std::pow(2.0, 3.5) - 1) < 1e-14);
  const Real ratio = length(c.waves[6].amplitude) / length(c.waves[0].amplitude);
  CHECK(std::abs(ratio * ratio / std::pow(8.0, -2 / 3.0) - 1) < 1e-14);
  const auto long_ones = packed<Gusts>({{"speed", 1.5}, {"length", 100.0}, {"velocity", carried}, {"seed", 3.0}});
  check_in_flow(instance("gusts", &long_ones));
}
