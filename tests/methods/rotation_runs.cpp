// Rotation updates as worlds run them: bits, snapshots, many steps at once, what is told and what is refused.
#include "tests/catch.h"
#include "tests/methods/turning_scenes.h"

using namespace ballpark;
using namespace ballpark::tests;

TEST_CASE("what a world tells of a body does not depend on the axes of its angular momentum", "[methods]") {
  Scene made = loaded(true);
  made.run.step = 1e-3;
  made.bodies.push_back(ball());
  made.bodies.back().angular_velocity = {{1, 2, 3}};
  World space(made), own(by(made, "body", "rk4"));
  for (World* world : {&space, &own}) {
    world->apply_impulse(0, {1, 2, -1}, {0.1, 0, 0.2});
    BodyState state = world->body(1);
    state.angular_velocity = {0, 5, 0};
    world->set(1, state);
    world->step(500);
  }
  const Totals a = space.totals(), b = own.totals();
  CHECK(std::abs(a.kinetic - b.kinetic) < 1e-10 * a.kinetic);
  CHECK((a.angular_momentum - b.angular_momentum).norm() < 1e-10 * a.angular_momentum.norm());
  for (std::size_t id : {0U, 1U}) {
    CHECK((space.body(id).angular_velocity - own.body(id).angular_velocity).norm() < 1e-9);
    CHECK((space.body(id).position - own.body(id).position).norm() < 1e-10);
  }
}

TEST_CASE("rotation updates: same bits on both paths, for any target and after a snapshot", "[methods]") {
  struct Way {
    std::string rule, integrator;
    double tolerance;
  };
  for (const Way& way : std::vector<Way>{{"exponential", "rk4", 0},
                                         {"exponential", "dormand_prince5", 1e-6},
                                         {"exponential", "pefrl", 0},
                                         {"splitting", "velocity_verlet", 0},
                                         {"splitting", "yoshida6", 0},
                                         {"body", "rk4", 0},
                                         {"body", "tsitouras5", 1e-6},
                                         {"renormalise", "boris", 0}}) {
    for (Scene made : {loaded(false), pendulum(2, 2, 1)}) {
      if (way.integrator == "boris" && made.effects.size() > 2) {
        made.effects.push_back(magnetic_field(1.5, {0.5, 1, -2}));
        made.effects.push_back(rotating_frame({0.1, 0, 0.3}, "on"));
      }
      INFO(way.rule << ", " << way.integrator << ", " << made.bodies[0].name);
      made = by(made, way.rule, way.integrator);
      made.run.step = way.tolerance > 0 ? 0 : 0.02;
      made.run.tolerance = way.tolerance;
      std::vector<std::uint64_t> hashes;
      for (const Path path : {Path::fused, Path::staged}) {
        for (const NamedDescription& target : targets()) {
          if (!target.available) continue;
          World world(made, Options{.threads = 1, .target = target.name, .precision = {}, .path = path});
          world.step(20);
          const Snapshot middle = world.snapshot();
          world.step(20);
          hashes.push_back(world.state_hash());
          world.restore(middle);
          world.step(20);
          hashes.push_back(world.state_hash());
        }
      }
      for (const std::uint64_t hash : hashes) CHECK(hash == hashes[0]);
    }
  }
}

TEST_CASE("a snapshot goes on by the rotation of the world that it is restored into", "[methods]") {
  const auto at = [](const std::string& rule, const std::string& integrator) {
    Scene made = by(loaded(false), rule, integrator);
    made.run.step = 0.01;
    return made;
  };
  World by_vector(at("exponential", "rk4")), plain(at("renormalise", "rk4")),
      verlet(at("splitting", "velocity_verlet"));
  by_vector.step(10);
  const Snapshot middle = by_vector.snapshot();
  for (World* world : {&plain, &verlet}) {
    world->restore(middle);
    const std::uint64_t before = world->state_hash();
    CHECK(before == by_vector.state_hash());
    world->step(20);
  }
  by_vector.step(20);
  CHECK(plain.state_hash() != by_vector.state_hash());
  for (const World* world : {&plain, &verlet}) {
    const double off = (world->body(0).angular_velocity - by_vector.body(0).angular_velocity).norm();
    CHECK(off > 0);
    CHECK(off < 1e-3);
  }
}

TEST_CASE("many steps at once are the same steps, one by one", "[methods]") {
  Scene made = loaded(true);
  made.run.step = 1e-3;
  made.impulses = {{.at = 0.3, .id = 0, .J = {1, 0, 0}},
                   {.at = 0.30025, .id = 0, .J = {0, 1, 0}, .offset = {0, 0, 0.1}}};
  made.effects.push_back({"force", {}, {{"force", Vector3d(1, 0, 0)}, {"at", 0.1}, {"until", 0.2005}}});
  for (const auto& [rule, integrator] :
       std::vector<std::pair<std::string, std::string>>{{"renormalise", "rk4"},
                                                        {"exponential", "rk4"},
                                                        {"body", "rk3"},
                                                        {"renormalise", "ab3"},
                                                        {"splitting", "velocity_verlet"}}) {
    INFO(rule << ", " << integrator);
    World many(by(made, rule, integrator)), single(by(made, rule, integrator));
    single.profile(true);  // passes are timed step by step
    many.step(1999);
    single.step(1999);
    CHECK(many.state_hash() == single.state_hash());
    CHECK(many.counters().steps == single.counters().steps);
    CHECK(many.counters().force_evaluations == single.counters().force_evaluations);
    CHECK(many.time() == single.time());
  }
}

TEST_CASE("rotation updates that an integrator or a scene cannot have are refused", "[methods]") {
  const auto refused = [](Scene made, const std::string& rule, const std::string& integrator) {
    for (const Problem& problem : check(by(std::move(made), rule, integrator))) {
      if (problem.path == "run.rotation") return problem.message;
    }
    return std::string();
  };
  for (const char* integrator : {"rk4", "ab4", "taylor2"}) {
    CHECK(refused(tumbling(), "splitting", integrator).find("velocity_verlet") != std::string::npos);
  }
  for (const char* integrator : {"ab4", "taylor2"}) {
    CHECK(refused(tumbling(), "exponential", integrator).find("explicit Runge-Kutta") != std::string::npos);
  }
  CHECK(refused(tumbling(), "body", "velocity_verlet").find("rk4") != std::string::npos);
  CHECK(refused(tumbling(), "exponental", "rk4").find("exponential") != std::string::npos);
  Scene compensated = tumbling();
  compensated.run.compensated = true;
  CHECK(refused(compensated, "exponential", "rk4").find("compensated") != std::string::npos);
  CHECK(refused(tumbling(), "exponential", "rk4").empty());
}
