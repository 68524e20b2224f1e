// Bodies that come and go: emitters, outlets and absorbing walls against free flight, and what they leave alone.
#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/catch.h"
#include "tests/physics/scenes.h"

using namespace ballpark;
using namespace ballpark::tests;

namespace {

constexpr double never = std::numeric_limits<double>::infinity();

Effect emitter(double every, double at = 0, double until = never, std::vector<std::string> groups = {}) {
  return {"emitter", std::move(groups), {{"every", every}, {"at", at}, {"until", until}}};
}
Effect absorbing(const Vector3d& point, const Vector3d& normal, std::vector<std::string> groups = {}) {
  return {"absorbing_wall", std::move(groups), {{"point", point}, {"normal", normal}}};
}
Effect outlet(const Vector3d& point, const Vector3d& size) {
  return {"outlet", {}, {{"point", point}, {"size", size}}};
}

/// Particles anywhere in a cube of 2 m, at up to 1 m/s beside the velocity.
BodyGroup cloud(std::size_t count, const Vector3d& velocity = Vector3d::Zero()) {
  BodyGroup group = particle(Vector3d::Zero(), velocity);
  group.position.clear();
  group.generate = Generate{};
  group.generate->kind = "random";
  group.generate->count = {count};
  group.generate->lower = {-1, -1, -1};
  group.generate->upper = {1, 1, 1};
  group.generate->velocity_spread = {1, 1, 1};
  return group;
}

BodyGroup drops(const char* name, std::size_t count, const Vector3d& velocity) {
  BodyGroup group{.name = name, .shape = "sphere", .material = "rubber", .radius = {0.1}, .mass = {1}};
  group.position.assign(count, {0, 0, 2});
  group.velocity = {velocity};
  return group;
}

/// Balls one after the other onto a floor and each other.
Scene heap(const std::string& kind, double duration) {
  Scene made = scene({drops("drops", 12, {0.2, 0.1, -3})}, {gravity(), emitter(0.1)}, duration, 1e-3);
  made.bodies[0].generate.reset();
  made.run.integrator = "velocity_verlet";
  made.contact.kind = kind;
  if (kind == "penalty") made.contact.stiffness = 1e5;
  made.materials["rubber"] = {0.5, 0.3};
  made.boundaries = {{.shape = "plane", .material = "rubber"}};
  return made;
}

std::size_t present(const World& world) {
  return world.body_count() - world.totals().absent_bodies;
}

std::string problem_of(const Scene& made) {
  const auto problems = check(made);
  return problems.empty() ? "" : problems[0].path + " " + problems[0].message;
}

}  // namespace

TEST_CASE("Emitter: body k enters at its time, and flies on as if it had always been there", "[physics]") {
  const double every = 0.037, at = 0.05;
  for (const double h : {0.01, 0.1}) {  // fewer than one, and several, in a step
    Scene made = scene({cloud(20)}, {emitter(every, at)}, 0.7, h);
    World always(scene({cloud(20)}, {}, 0.7, h)), world(made);
    CHECK(present(world) == 0);
    CHECK(world.totals().energy() == 0);
    CAPTURE(h);
    for (int step = 1; step <= static_cast<int>(0.7 / h + 0.5); ++step) {
      world.step();
      const double t = world.time();
      for (std::size_t k = 0; k < 20; ++k) {
        const double due = at + static_cast<double>(k) * every;
        const BodyState body = world.body(k), start = always.body(k);
        if (std::abs(due - t) < 1e-12) continue;
        CHECK(body.present == (due < t));
        CHECK(std::isnan(body.position.x()) == (due > t));
        if (due > t) continue;
        CHECK((body.velocity - start.velocity).norm() == 0);
        CHECK((body.position - start.position - (t - due) * start.velocity).norm() < 1e-13);
      }
    }
    CHECK(world.counters().entered == 18);
    CHECK(world.status().code == Status::Code::ok);
    CHECK(world.totals().non_finite_bodies == 0);
  }
}

TEST_CASE("Emitter: until its end, and with room for no more than the group's bodies", "[physics]") {
  World ends(scene({cloud(20)}, {emitter(0.1, 0, 0.45)}, 2, 0.01));
  ends.advance_to(2);
  CHECK(present(ends) == 5);
  CHECK(ends.counters().entered == 4);  // the first one is there at the start
  CHECK(ends.status().code == Status::Code::ok);

  CHECK(
      problem_of(scene({cloud(20)}, {emitter(0.1)}, 2, 0.01)) ==
      "effects[0].every 21 bodies would enter by 2 s, but group particle has 20: expected more bodies, or until < 2 s");
  World full(scene({cloud(20)}, {emitter(0.1)}, 1.95, 0.01));
  full.advance_to(1.95);
  CHECK(full.status().code == Status::Code::ok);
  full.advance_to(2);
  CHECK(full.status().code == Status::Code::full);
  CHECK(full.status().sentence == "the emitter of group particle has no body left: all 20 have entered");
  CHECK(full.status().body == 19);
  CHECK(full.status().step == 200);
  CHECK(std::string(name(full.status().code)) == "full");

  World burst(scene({cloud(20)}, {emitter(0, 0.3)}, 1, 0.1));
  burst.advance_to(0.2);
  CHECK(present(burst) == 0);
  burst.advance_to(1);
  CHECK(present(burst) == 20);
}

TEST_CASE("Absorbing wall, outlet: who is behind or inside when a step ends is gone, no other", "[physics]") {
  const double h = 0.1, t = 1;
  const World start(scene({cloud(5000)}, {}, t, h));
  World walled(scene({cloud(5000)}, {absorbing({-0.5, 0, 0}, {2, 0, 0})}, t, h)),
      drained(scene({cloud(5000)}, {outlet({0.2, 0, 0.3}, {0.5, 1, 2})}, t, h));
  walled.advance_to(t);
  drained.advance_to(t);
  std::size_t behind = 0, inside = 0, wrong = 0;
  for (std::size_t id = 0; id < start.body_count(); ++id) {
    const BodyState body = start.body(id);
    bool crosses = false, enters = false;
    for (int step = 1; step <= 10; ++step) {
      const Vector3d x = body.position + step * h * body.velocity, off = (x - Vector3d(0.2, 0, 0.3)).cwiseAbs();
      crosses = crosses || x.x() < -0.5;
      enters = enters || (off.x() <= 0.25 && off.y() <= 0.5 && off.z() <= 1);
    }
    behind += crosses, inside += enters;
    wrong += (walled.body(id).present == crosses) + (drained.body(id).present == enters);
  }
  CHECK(behind > 1000);
  CHECK(inside > 500);
  CHECK(wrong == 0);
  CHECK(walled.counters().left == behind);
  CHECK(drained.counters().left == inside);
  CHECK(walled.totals().absent_bodies == behind);
}

TEST_CASE("Effusion: through a wall that takes them, n v/4 A of a gas's molecules leave", "[physics]") {
  // from a long column behind the plane, of which none far away arrives in time: n <v_x, v_x < 0> A t
  BodyGroup gas = cloud(100000);
  gas.generate->lower = {0, -1, -1};
  gas.generate->upper = {2, 1, 1};
  const double t = 1;  // at 1 m/s at most
  World world(scene({gas}, {absorbing({0, 0, 0}, {1, 0, 0})}, t, 0.01));
  world.advance_to(t);
  const double expected = 100000 / 2.0 * t * 0.25;  // uniform speeds: <v_x, v_x < 0> = 1/4
  CHECK(std::abs(static_cast<double>(world.counters().left) - expected) < 5 * std::sqrt(expected));
}

TEST_CASE("Presence: who is not there touches nobody, and changes no bit of who is", "[physics]") {
  for (const std::string kind : {"impulse", "penalty"}) {
    CAPTURE(kind);
    Scene alone = heap(kind, 1);
    alone.effects.pop_back();
    alone.bodies[0].position = {{0, 0, 0.5}, {0.05, 0, 1.2}};
    Scene beside = alone;
    beside.bodies.push_back(drops("late", 3, {0, 0, 0}));
    beside.bodies[1].position = {{0, 0, 0.4}, {0, 0, 0.8}, {0.1, 0, 0.1}};  // in the way
    beside.effects.push_back(emitter(1, 10, never, {"late"}));
    World one(alone), two(beside);
    one.advance_to(1);
    two.advance_to(1);
    CHECK(one.counters().contacts > 0);
    CHECK(one.counters().contacts == two.counters().contacts);
    for (std::size_t id = 0; id < 2; ++id) {
      CHECK(one.body(id).position == two.body(id).position);
      CHECK(one.body(id).velocity == two.body(id).velocity);
    }
    CHECK(one.counters().neighbour_lists == two.counters().neighbour_lists);
  }
}

TEST_CASE("Presence: balls that enter fall on those that lie there, under both formulations", "[physics]") {
  for (const std::string kind : {"impulse", "penalty"}) {
    World world(heap(kind, 1.15));
    world.advance_to(1.15);
    CAPTURE(kind, world.status().sentence);
    CHECK(world.status().code == Status::Code::ok);
    CHECK(present(world) == 12);
    CHECK(world.totals().bodies_outside == 0);
    CHECK(world.counters().max_penetration < 0.02);
    CHECK(world.counters().peak_contacts > 1);
    double lowest = 1;
    for (std::size_t id = 0; id < 12; ++id) lowest = std::min(lowest, world.body(id).position.z());
    CHECK(lowest > 0.08);
  }
}

TEST_CASE("Presence: the same bits on any number of threads, in copies, and after a restored snapshot", "[physics]") {
  Scene many = scene({cloud(20000)}, {gravity(), emitter(2e-5, 0.01), absorbing({0, 0, -0.9}, {0, 0, 1})}, 0.4, 1e-2);
  World one(many, {.threads = 1}), four(many, {.threads = 4});
  one.advance_to(0.2);
  const Snapshot half = one.snapshot();
  one.advance_to(0.4);
  four.advance_to(0.4);
  CHECK(one.counters().left > 100);
  CHECK(one.state_hash() == four.state_hash());
  four.restore(half);
  CHECK(four.state_hash() != one.state_hash());
  four.advance_to(0.4);
  CHECK(one.state_hash() == four.state_hash());
  CHECK(one.counters().left == four.counters().left);
  CHECK(present(one) == present(four));

  many.bodies[0].generate->count = {50};
  many.effects[1] = emitter(0.008, 0.01);
  World solo(many), copies(many, {.copies = 40});
  solo.advance_to(0.4);
  copies.advance_to(0.4);
  CHECK(copies.counters().entered == 40 * solo.counters().entered);
  for (std::size_t id = 0; id < 50; ++id) {
    CHECK(solo.body(id).present == copies.body(id).present);
    if (solo.body(id).present) CHECK(solo.body(id).position == copies.body(id).position);
  }
}

TEST_CASE("Presence: on the staged path, compensated, and with spin, bodies enter as they do on the fused one",
          "[physics]") {
  for (const bool compensated : {false, true}) {
    Scene made = scene({drops("drops", 20, {1, 0, 0})}, {gravity(), emitter(0.01, 0.02)}, 0.15, 1e-2);
    made.materials["rubber"] = {0.5, 0.3};
    made.bodies[0].angular_velocity = {{3, 2, 1}};
    made.effects.push_back({"magnus", {}, {{"coefficient", 0.1}}});
    made.run.compensated = compensated;
    World fused(made, {.path = Path::fused}), staged(made, {.path = Path::staged});
    fused.advance_to(0.15);
    staged.advance_to(0.15);
    CAPTURE(compensated);
    CHECK(present(fused) == 14);
    CHECK(fused.state_hash() == staged.state_hash());
    const Vector3d spin = fused.body(0).angular_velocity;
    CHECK((spin - Vector3d(3, 2, 1)).norm() < 1e-14);
  }
}

TEST_CASE("Presence: the ledger gives emitters what bodies bring, and walls what they take", "[physics]") {
  Scene made = scene({cloud(300)}, {gravity(), emitter(1e-3, 0), absorbing({0, 0, -0.5}, {0, 0, 1})}, 0.25, 1e-2);
  World world(made);
  world.keep_ledger(true);
  world.advance_to(0.25);
  const Ledger ledger = world.ledger();
  double entered = 0, left = 0;
  for (const LedgerLine& line : ledger.lines) {
    if (line.name == "emitter") entered = line.work;
    if (line.name == "absorbing_wall") left = line.work;
  }
  CHECK(entered > 0);
  CHECK(left != 0);
  CHECK(std::abs(ledger.integrator_error()) < 1e-9 * (std::abs(entered) + std::abs(left)));
}

TEST_CASE("Presence: a body that turns infinite is named, whoever is not there", "[physics]") {
  Scene made = scene({cloud(50)}, {emitter(0.01, 0.005)}, 0.3, 1e-2);
  World world(made);
  world.advance_to(0.1);
  CHECK(world.status().code == Status::Code::ok);
  BodyState sick = world.body(3);
  sick.velocity = {1e308, 1e308, 1e308};
  sick.position = {1.7e308, 0, 0};
  world.set(3, sick);
  world.advance_to(100);
  CHECK(world.status().code == Status::Code::non_finite);
  CHECK(world.status().body == 3);
  CHECK(world.totals().non_finite_bodies == 1);
}

TEST_CASE("Presence: what does not fit is refused, and who is not there cannot be changed", "[physics]") {
  const auto with = [](Effect effect) { return scene({cloud(20)}, {emitter(1), std::move(effect)}, 1, 0.01); };
  CHECK(problem_of(with({"mutual_gravity", {}, {{"strength", 1.0}}})).find("effects[1].groups mutual_gravity acts") ==
        0);
  CHECK(problem_of(with(emitter(1))).find("effects[1].groups group particle has an emitter already") == 0);
  CHECK(problem_of(with(outlet({0, 0, 0}, {1, 0, 1}))).find("effects[1].size has a length <= 0") == 0);
  Scene implicit = scene({cloud(20)}, {emitter(1)}, 1, 0.01);
  implicit.run.integrator = "implicit_midpoint";
  CHECK(problem_of(implicit).find("run.integrator implicit_midpoint") == 0);
  implicit.run.integrator = "ab4";
  CHECK(problem_of(implicit).find("run.integrator emitter") == 0);

  World world(scene({cloud(20)}, {emitter(1, 0.5)}, 1, 0.01));
  const std::string refused = "apply_impulse: body 2 is not there: it has not entered yet, or is gone";
  CHECK_THROWS_WITH(world.apply_impulse(2, {1, 0, 0}), refused);
  CHECK_THROWS_AS(world.set(2, BodyState()), SceneError);
}
