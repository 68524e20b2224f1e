// Contacts over several blocks of bodies: the same bits for threads and targets, for a body that is far away, and for a
// run that goes on from a snapshot.
#include "tests/catch.h"
#include "tests/determinism/body_bits.h"
#include "tests/determinism/scenarios.h"

namespace {

using ballpark::BodyGroup;
using ballpark::Boundary;
using ballpark::Precision;
using ballpark::Scene;
using ballpark::World;

#ifdef BALLPARK_SANITIZE  // which takes many times as long: two blocks of bodies, not three
constexpr std::size_t heap_layers = 4;
#else
constexpr std::size_t heap_layers = 8;
#endif

/// Balls packed so that all touch at once, thrown at the floor of a box.
Scene heap(std::size_t layers, const std::string& kind) {
  const bool soft = kind == "penalty";
  Scene scene;
  scene.run.duration = 1;
  scene.run.step = soft ? 1e-3 : 1.0 / 60;
  scene.run.integrator = soft ? "velocity_verlet" : "semi_implicit_euler";
  scene.contact.kind = kind;
  if (soft) scene.contact.stiffness = 1e5;
  scene.materials["ball"] = {0.3, 0.4};
  BodyGroup balls;
  balls.name = "balls";
  balls.shape = "sphere";
  balls.material = "ball";
  balls.radius = {0.05};
  balls.density = {1000};
  balls.velocity = {{0.3, -0.2, -3}};
  balls.generate = ballpark::Generate{.kind = "lattice",
                                      .count = {25, 25, layers},
                                      .origin = {0.06, 0.06, 0.06},
                                      .spacing = 0.1001,
                                      .velocity_spread = {0.5, 0.5, 0.5}};
  scene.bodies = {balls};
  Boundary box;
  box.shape = "box", box.point = {1.3, 1.3, 2}, box.size = {2.6, 2.6, 4}, box.material = "ball";
  scene.boundaries = {box};
  scene.effects = {{.kind = "gravity", .groups = {}, .parameters = {}}};
  return scene;
}

}  // namespace

TEST_CASE("Contacts: the same bits for threads and targets, over several blocks", "[bits]") {
  const std::string kind = GENERATE(as<std::string>(), "impulse", "penalty");
  const Scene scene = heap(heap_layers, kind);
  CAPTURE(kind);
  for (const Precision precision : {Precision::double_, Precision::single_}) {
    const std::uint64_t plain =
        scenarios::hash_after(scene, {.threads = 1, .target = "base", .precision = precision}, 12);
    for (const int threads : {2, 3, 5, 8}) {
      CAPTURE(threads);
      CHECK(scenarios::hash_after(scene, {.threads = threads, .precision = precision}, 12) == plain);
    }
    for (const std::string& target : scenarios::available_targets()) {
      CAPTURE(target);
      CHECK(scenarios::hash_after(scene, {.threads = 2, .target = target, .precision = precision}, 12) == plain);
    }
  }
}

TEST_CASE("Contacts: bodies far away change no bit", "[bits]") {
  const std::string kind = GENERATE(as<std::string>(), "impulse", "penalty");
  CAPTURE(kind);
  const Scene few = heap(2, kind);
  Scene many = few;
  BodyGroup far = few.bodies[0];
  far.name = "far";
  far.generate->origin = {50, 60, 0.07};
  far.velocity = {{1, 2, 40}};
  many.bodies.push_back(far);
  many.boundaries[0].open = {"+x", "+y"};
  Scene alone = few;
  alone.boundaries[0].open = {"+x", "+y"};
  World with(many, {.threads = 2}), without(alone, {.threads = 1});
  with.step(20);
  without.step(20);
  CHECK((body_bits::of(with, 0, 1250) == body_bits::of(without, 0, 1250)));
  CHECK(without.counters().contacts > 0);
}

TEST_CASE("Contacts: a run goes on from a snapshot with the same bits", "[bits]") {
  const std::string kind = GENERATE(as<std::string>(), "impulse", "penalty");
  CAPTURE(kind);
  const Scene scene = heap(3, kind);
  World whole(scene, {.threads = 1}), first(scene, {.threads = 2}), second(scene, {.threads = 1});
  whole.step(20);
  first.step(11);
  second.restore(first.snapshot());
  second.step(9);
  CHECK(second.state_hash() == whole.state_hash());
  CHECK(second.counters().contacts == whole.counters().contacts);
  ballpark::Snapshot broken = first.snapshot();
  broken.contacts.resize(broken.contacts.size() / 2 - 1);
  CHECK_THROWS_AS(second.restore(broken), ballpark::SceneError);
}
