// The energy ledger against closed forms: what each cause did, and what is left for the integrator.
#include <functional>

#include "tests/catch.h"
#include "tests/physics/contact_scenes.h"
#include "tests/physics/scenes.h"

using namespace ballpark;
using namespace ballpark::tests;

namespace {

Ledger booked(const Scene& made, std::vector<UserEffect> users = {}) {
  World world(made, {}, std::move(users));
  world.keep_ledger(true);
  world.advance_to(made.run.duration);
  return world.ledger();
}

const LedgerLine& line(const Ledger& ledger, const std::string& name) {
  for (const LedgerLine& line : ledger.lines) {
    if (line.name == name) return line;
  }
  FAIL("no line " + name);
  return ledger.lines.front();
}

double error_of(const Scene& made) {
  return std::abs(booked(made).integrator_error());
}

/// Two balls on a spring with a damper, and a third that they pull.
Scene bound(double damping) {
  Scene made = scene(particle(Vector3d::Zero()), {}, 1.0, 1e-3);
  made.bodies[0].mass = {1.0, 2.0, 0.5};
  made.bodies[0].position = {{0, 0, 0}, {1.3, 0.2, 0}, {0, 2, 1}};
  made.bodies[0].velocity = {{0, 1, 0}, {0, -0.5, 0.2}, {0.3, 0, 0}};
  made.effects = {{"mutual_gravity", {}, {{"strength", 2.0}, {"softening", 0.1}}},
                  {"bonds",
                   {},
                   {{"pairs", std::vector<IdPair>{{0, 1}}},
                    {"stiffness", std::vector<double>{40}},
                    {"damping", std::vector<double>{damping}},
                    {"rest_length", std::vector<double>{1}}}}};
  return made;
}

}  // namespace

TEST_CASE("Ledger: linear drag takes what the closed form says", "[physics]") {
  const double c = 0.7, T = 2, h = 1e-2;
  const Ledger ledger = booked(scene(particle({0, 0, 0}, {3, -1, 2}), {effect("linear_drag", c)}, T, h));
  const double before = 0.5 * 14, after = before * std::exp(-2 * c * T);
  CHECK(std::abs(ledger.initial.translation - before) < 1e-15);
  CHECK(std::abs(line(ledger, "linear_drag").work - (after - before)) < 1e-9);
  CHECK(!line(ledger, "linear_drag").has_energy);
  CHECK(std::abs(ledger.integrator_error()) < 1e-9);
  CHECK(ledger.from == 0);
  CHECK(std::abs(ledger.to - T) < 1e-12);
}

TEST_CASE("Ledger: a damped spring, potential and loss apart", "[physics]") {
  // x'' = -k x - c x': the spring takes c x'^2 for good; by the closed form x = e^-gt (cos wt + g/w sin wt).
  const double k = 25, c = 0.8, T = 3, g = c / 2, w = std::sqrt(k - g * g);
  const Ledger ledger = booked(scene(particle({1, 0, 0}), {spring(k, c)}, T, 5e-4));
  const double x = std::exp(-g * T) * (std::cos(w * T) + g / w * std::sin(w * T));
  const double v = -std::exp(-g * T) * k / w * std::sin(w * T);
  const LedgerLine& of = line(ledger, "spring");
  CHECK(std::abs(of.initial - k / 2) < 1e-14);
  CHECK(std::abs(of.final - k * x * x / 2) < 1e-9);
  CHECK(std::abs(of.work - v * v / 2) < 1e-9);
  CHECK(std::abs(of.gain() - (v * v / 2 + k * x * x / 2 - k / 2)) < 1e-9);
  CHECK(std::abs(ledger.integrator_error()) < 1e-9);
}

TEST_CASE("Ledger: quadratic drag and weight near the terminal speed", "[physics]") {
  // m v' = m g - c v^2: v = u tanh(g t / u), fallen (u^2 / g) ln cosh(g t / u), u = sqrt(m g / c)
  const double c = 0.4, T = 1.5, u = std::sqrt(9.81 / c);
  const Ledger ledger = booked(scene(particle({0, 0, 0}), {gravity(), effect("quadratic_drag", c)}, T, 1e-3));
  const double v = u * std::tanh(9.81 * T / u), fallen = u * u / 9.81 * std::log(std::cosh(9.81 * T / u));
  CHECK(std::abs(line(ledger, "gravity").work - 9.81 * fallen) < 1e-9);
  CHECK(std::abs(line(ledger, "gravity").gain()) < 1e-9);
  CHECK(std::abs(line(ledger, "quadratic_drag").work - (v * v / 2 - 9.81 * fallen)) < 1e-9);
}

TEST_CASE("Ledger: on conservative scenes the integrator's error falls with its order", "[physics]") {
  struct Row {
    const char* name;
    double order;
  };
  for (const Row& row : {Row{"euler", 1}, Row{"midpoint", 2}, Row{"velocity_verlet", 2}, Row{"rk4", 4}, Row{"ab4", 4},
                         Row{"implicit_midpoint", 2}, Row{"dormand_prince5", 5}}) {
    CAPTURE(row.name);
    const double T = 2.5, h = row.order < 2 ? 1e-3 : row.order < 4 ? 1e-2 : 2.5e-2;
    const auto at = [&](double step) { return error_of(orbit(0.3, T, step, row.name)); };
    const double coarse = at(h), fine = at(h / 2), slope = std::log2(coarse / fine);
    CAPTURE(coarse, fine);
    CHECK(slope > row.order - 0.35);
    CHECK(slope < row.order + 1.2);
    const World world = [&] {
      World run(orbit(0.3, T, h / 2, row.name));
      run.advance_to(T);
      return run;
    }();
    const double drift = std::abs(world.totals().energy() - World(orbit(0.3, T, h, row.name)).totals().energy());
    CHECK(std::abs(fine - drift) < 1e-13);
  }
}

TEST_CASE("Ledger: a field that only turns does no work, frames and fields that push do", "[physics]") {
  const Ledger turning =
      booked(scene(particle({1, 0, 0}, {0, 1, 0.3}), {magnetic_field(2, {0.1, -0.4, 1})}, 3, 1e-3, "boris"));
  CHECK(std::abs(line(turning, "magnetic_field").work) < 1e-14);
  // Coriolis does none, the centrifugal force W^2 r^2 / 2 outwards.
  const Scene frame = scene(particle({1, 0, 0}, {0, 1, 0}), {rotating_frame({0, 0, 0.5}, "on")}, 2, 1e-3);
  World world(frame);
  world.keep_ledger(true);
  world.advance_to(2);
  const double r = world.body(0).position.norm();
  CHECK(std::abs(line(world.ledger(), "rotating_frame").work - 0.125 * (r * r - 1)) < 1e-10);
}

TEST_CASE("Ledger: torques work on the rotation, a pivot on neither", "[physics]") {
  Scene spun = scene(ball(), {}, 2, 1e-2);
  spun.bodies[0].angular_velocity = {Vector3d(0, 0, 10)};
  spun.effects = {{"torque", {}, {{"torque", Vector3d(0, 0, -0.3)}}}};
  const Ledger ledger = booked(spun);
  const double spin = 10 - 0.3 / 0.4 * 2;
  CHECK(std::abs(ledger.initial.rotation - 0.2 * 100) < 1e-13);
  CHECK(std::abs(ledger.final.rotation - 0.2 * spin * spin) < 1e-12);
  CHECK(std::abs(line(ledger, "torque").work - 0.2 * (spin * spin - 100)) < 1e-12);

  const Ledger swung = booked(pendulum(2, 3, 1e-3));
  CHECK(std::abs(swung.integrator_error()) < 1e-9);
  CHECK(std::abs(line(swung, "gravity").gain()) < 1e-9);
  const Ledger nodding = booked(top(0.3, {0, 0, 40}, 0.5, 1e-4));
  CHECK(std::abs(nodding.integrator_error()) < 1e-8);
}

TEST_CASE("Ledger: forces between bodies", "[physics]") {
  const Ledger kept = booked(bound(0));
  CHECK(std::abs(kept.integrator_error()) < 1e-8);
  CHECK(std::abs(line(kept, "mutual_gravity").gain()) < 1e-8);
  CHECK(std::abs(line(kept, "bonds").gain()) < 1e-8);
  CHECK(std::abs(line(kept, "bonds").work) > 0.1);
  Scene split = bound(0);  // one more network of bonds, on the line of the first
  split.effects.push_back(split.effects[1]);
  split.effects[1].parameters["stiffness"] = split.effects[2].parameters["stiffness"] = std::vector<double>{20};
  const Ledger both = booked(split);
  CHECK(both.lines.size() == kept.lines.size());
  CHECK(std::abs(line(both, "bonds").work - line(kept, "bonds").work) < 1e-12);
  CHECK(std::abs(both.integrator_error()) < 1e-8);
  const Ledger damped = booked(bound(3));
  CHECK(std::abs(damped.integrator_error()) < 1e-8);
  CHECK(line(damped, "bonds").gain() < -0.1);
  CHECK(std::abs(line(damped, "mutual_gravity").gain()) < 1e-8);
}

TEST_CASE("Ledger: a user's drag and the built-in one", "[physics]") {
  UserEffect drag;
  drag.name = "molasses";
  drag.run_double = [](const BodyBlock<double>& bodies) {
    for (int c = 0; c < 3; ++c) {
      for (std::size_t i = 0; i < bodies.count; ++i) bodies.force[c][i] -= 0.7 * bodies.velocity[c][i];
    }
  };
  const Scene bare = scene(particle({0, 0, 0}, {3, -1, 2}), {gravity()}, 1, 1e-2);
  Scene built_in = bare;
  built_in.effects.push_back(effect("linear_drag", 0.7));
  const double work = line(booked(bare, {drag}), "molasses").work;
  CHECK(work < -1);
  CHECK(std::abs(work - line(booked(built_in), "linear_drag").work) < 1e-13);
}

TEST_CASE("Ledger: impulses and what is set come from outside, windows begin and end between steps", "[physics]") {
  const double h = 0.01;
  Scene made = scene(particle({0, 0, 0}, {1, 0, 0}), {gravity()}, 1, h);
  made.effects.push_back({"force", {}, {{"force", Vector3d(2, 0, 0)}, {"at", 0.125}, {"until", 0.3333}}});
  made.impulses.push_back({.at = 0.777, .id = 0, .J = {0, 3, 0}});
  World world(made);
  world.keep_ledger(true);
  world.advance_to(1);
  // Pushed by 2 N for 0.2083 s: 1 -> 1.4166 m/s.
  const double pushed = 1 + 2 * (0.3333 - 0.125);
  CHECK(std::abs(line(world.ledger(), "force").work - (pushed * pushed - 1) / 2) < 1e-12);
  CHECK(std::abs(line(world.ledger(), "from outside").work - 4.5) < 1e-12);
  CHECK(std::abs(world.ledger().integrator_error()) < 1e-11);
  BodyState state = world.body(0);
  const double before = world.totals().energy();
  state.position += Vector3d(0, 0, 10);
  state.velocity *= 2;
  world.set(0, state);
  const double lifted = world.totals().energy() - before;
  CHECK(std::abs(line(world.ledger(), "from outside").work - 4.5 - lifted) < 1e-9);
  CHECK(std::abs(line(world.ledger(), "gravity").gain()) < 1e-9);
  CHECK(std::abs(world.ledger().integrator_error()) < 1e-9);
}

TEST_CASE("Ledger: contacts take 1 - e^2 of an impact, under both formulations", "[physics]") {
  using namespace contact_scenes;
  for (const char* kind : {"impulse", "penalty"}) {
    CAPTURE(kind);
    Scene made = touching_scene(1e-5, {0.5, 0}, "velocity_verlet");
    made.contact.kind = kind;
    if (made.contact.kind == "penalty") made.contact.stiffness = 1e6;
    made.bodies = {ball_group({{0, 0, 0}, {1.05, 0, 0}}, {{1, 0, 0}, {-1, 0, 0}})};
    made.run.duration = 0.2;
    const Ledger ledger = booked(made);
    const LedgerLine& contacts = line(ledger, "contacts");
    CHECK(std::abs(contacts.work + 0.75) < 0.01);
    CHECK(std::abs(contacts.gain() + 0.75) < 0.01);
    // 2 xi sqrt(k m / 2) for e = 0.5: within a step it begins to take 4 times so much a second.
    const double dashpot = made.contact.kind == "penalty" ? 0.4309 * std::sqrt(0.5e6) : 0;
    CHECK(std::abs(ledger.integrator_error()) < 4 * dashpot * made.run.step + 1e-12);
  }
}

TEST_CASE("Ledger: a ball that rests takes nothing", "[physics]") {
  using namespace contact_scenes;
  Scene made = touching_scene(1e-3, {0.5, 0.3}, "velocity_verlet");
  made.bodies = {ball_group({{0, 0, 0.5}})};
  made.boundaries = {plane()};
  made.effects = {contact_scenes::gravity()};
  const Ledger ledger = booked(made);
  CHECK(std::abs(line(ledger, "gravity").work) < 1e-9);
  CHECK(std::abs(line(ledger, "contacts").work) < 1e-9);
  CHECK(std::abs(ledger.integrator_error()) < 1e-9);
}

TEST_CASE("Ledger: steps of a tolerance, and snapshots that hold it", "[physics]") {
  Scene made = orbit(0.6, 3, 0, "dormand_prince5");
  made.run.tolerance = 1e-9;
  made.effects.push_back(effect("linear_drag", 0.1));
  World world(made);
  CHECK_THROWS_AS(world.ledger(), SceneError);
  world.keep_ledger(true);
  world.advance_to(1.5);
  const Snapshot half = world.snapshot();
  const double taken = line(world.ledger(), "linear_drag").work;
  world.advance_to(3);
  const Ledger whole = world.ledger();
  CHECK(std::abs(whole.integrator_error()) < 1e-7);
  CHECK(line(whole, "linear_drag").work < taken);
  world.restore(half);
  CHECK(line(world.ledger(), "linear_drag").work == taken);
  world.advance_to(3);
  CHECK(line(world.ledger(), "linear_drag").work == line(whole, "linear_drag").work);
  World other(made);
  const Snapshot start = other.snapshot();
  world.restore(start);
  CHECK(line(world.ledger(), "linear_drag").work == 0);
  CHECK(world.ledger().from == 0);
}
