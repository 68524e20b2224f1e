// Calls that make no sense are refused with SceneError, and leave the world as it was.
#include <limits>

#include "tests/catch.h"
#include "tests/unit/world/made_scenes.h"

using namespace made_scenes;
using ballpark::BodyState;
using ballpark::Precision;
using ballpark::World;

namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double inf = std::numeric_limits<double>::infinity();
const Vector3d one(1, 1, 1), bad(0, not_a_number, 0), endless(0, 0, inf);

/// Bodies 0, 1: particles; 2, 3: balls that spin; 4, 5: bricks.
Scene mixed() {
  return scene_of({particles("p", 2), spinning(balls("s", 2)), bricks("b", 2)}, {effect("gravity")});
}

/// The call must be refused under its name, with these words, and change nothing.
template <class Call>
void check_refused(World& world, const std::string& path, const std::string& words, Call call) {
  const std::uint64_t hash = world.state_hash();
  const Problem problem = refusal(call);
  CAPTURE(path, words, problem.message);
  CHECK(problem.path == path);
  CHECK(contains(problem.message, words));
  CHECK(world.state_hash() == hash);
}

BodyState state_with(const Vector3d& position) {
  BodyState state;
  state.position = position;
  return state;
}

BodyState turned(double w, double x, double y, double z) {
  BodyState state;
  state.has_orientation = true;
  state.orientation = {w, x, y, z};
  return state;
}

}  // namespace

TEST_CASE("Misuse: unknown ids", "[misuse]") {
  World world(mixed(), {.copies = 2});
  const std::string below = "does not exist, expected an id below 12";
  for (const std::size_t id : {std::size_t{12}, std::numeric_limits<std::size_t>::max()}) {
    check_refused(world, "body", below, [&] { world.body(id); });
    check_refused(world, "set", below, [&] { world.set(id, {}); });
    check_refused(world, "apply_impulse", below, [&] { world.apply_impulse(id, one); });
    check_refused(world, "apply_impulse_at", below, [&] { world.apply_impulse_at(1, id, one); });
    check_refused(world, "apply_force", below, [&] { world.apply_force(id, one, 0, 1); });
    check_refused(world, "apply_torque", below, [&] { world.apply_torque(id, one, 0, 1); });
  }
  World empty(scene_of({}));
  CHECK(refusal([&] { empty.apply_impulse(0, one); }).path == "apply_impulse");
}

TEST_CASE("Misuse: values that are not finite", "[misuse]") {
  World world(mixed());
  for (const Vector3d& v : {bad, endless}) {
    check_refused(world, "apply_impulse", "J is not finite", [&] { world.apply_impulse(2, v); });
    check_refused(world, "apply_impulse", "offset is not finite", [&] { world.apply_impulse(2, one, v); });
    check_refused(world, "apply_impulse_at", "J is not finite", [&] { world.apply_impulse_at(1, 2, v); });
    check_refused(world, "apply_impulse_at", "offset is not", [&] { world.apply_impulse_at(1, 2, one, v); });
    check_refused(world, "apply_force", "force is not finite", [&] { world.apply_force(2, v, 0, 1); });
    check_refused(world, "apply_torque", "torque is not finite", [&] { world.apply_torque(2, v, 0, 1); });
    check_refused(world, "set", "position is not finite", [&] { world.set(2, state_with(v)); });
  }
  BodyState fast, spun;
  fast.velocity = endless;
  spun.angular_velocity = bad;
  spun.has_angular_velocity = true;
  check_refused(world, "set", "velocity is not finite", [&] { world.set(0, fast); });
  check_refused(world, "set", "angular_velocity is not finite", [&] { world.set(2, spun); });
}

TEST_CASE("Misuse: values that single precision cannot hold", "[misuse]") {
  World world(mixed(), {.precision = Precision::single_});
  const Vector3d huge(0, 1e39, 0);
  check_refused(world, "set", "position", [&] { world.set(0, state_with(huge)); });
  check_refused(world, "apply_impulse", "J", [&] { world.apply_impulse(0, huge); });
  check_refused(world, "apply_force", "force", [&] { world.apply_force(0, huge, 0, 1); });
}

TEST_CASE("Misuse: times that are over, not numbers, or the wrong way round", "[misuse]") {
  World world(mixed());
  world.step(10);
  const double now = world.time();
  for (const double at : {now / 2, -1.0, not_a_number, inf, -inf}) {
    CAPTURE(at);
    check_refused(world, "apply_impulse_at", "expected a time from now on",
                  [&] { world.apply_impulse_at(at, 0, one); });
  }
  for (const auto& [at, until] :
       {std::pair(not_a_number, 1.0), {now, not_a_number}, {now + 1, now + 1}, {now + 2, now + 1}, {inf, inf}}) {
    CAPTURE(at, until);
    check_refused(world, "apply_force", "until", [&] { world.apply_force(0, one, at, until); });
    check_refused(world, "apply_torque", "until", [&] { world.apply_torque(2, one, at, until); });
  }
  check_refused(world, "apply_force", "from now on", [&] { world.apply_force(0, one, now / 4, now / 2); });
  CHECK(refusal([&] { world.apply_impulse_at(now, 0, one); }).path.empty());
  CHECK(refusal([&] { world.apply_force(0, one, now, inf); }).path.empty());
}

TEST_CASE("Misuse: what the group does not carry", "[misuse]") {
  World world(mixed());
  check_refused(world, "apply_torque", "group p carries no rotation", [&] { world.apply_torque(0, one, 0, 1); });
  check_refused(world, "apply_impulse", "offset of zero", [&] { world.apply_impulse(0, one, one); });
  check_refused(world, "apply_impulse_at", "offset of zero", [&] { world.apply_impulse_at(1, 0, one, one); });
  check_refused(world, "set", "group p carries no orientation", [&] { world.set(0, turned(1, 0, 0, 0)); });
  check_refused(world, "set", "group s carries no orientation", [&] { world.set(2, turned(1, 0, 0, 0)); });
  BodyState spun;
  spun.has_angular_velocity = true;
  check_refused(world, "set", "group p carries no rotation", [&] { world.set(0, spun); });
}

TEST_CASE("Misuse: an orientation that is not a unit quaternion", "[misuse]") {
  World world(mixed());
  for (const BodyState& state : {turned(0, 0, 0, 0), turned(1, 1, 0, 0), turned(1.001, 0, 0, 0),
                                 turned(not_a_number, 0, 0, 0), turned(inf, 0, 0, 0)}) {
    check_refused(world, "set", "not a unit quaternion", [&] { world.set(4, state); });
  }
  CHECK(refusal([&] { world.set(4, turned(0.6, 0, -0.8, 0)); }).path.empty());
}

TEST_CASE("Misuse: a snapshot of another world", "[misuse]") {
  const auto refused = [](World& world, const World& other) {
    check_refused(world, "restore", "another scene, number of copies or precision",
                  [&] { world.restore(other.snapshot()); });
  };
  World world(mixed());
  refused(world, World(mixed(), {.precision = Precision::single_}));
  refused(world, World(mixed(), {.copies = 20}));
  refused(world, World(scene_of({particles("p", 2)})));
  refused(world, World(scene_of({})));
  refused(world, World(scene_of({particles("p", 3), spinning(balls("s", 2)), bricks("b", 2)})));
  World small(scene_of({particles("p", 1)}));
  refused(small, World(scene_of({particles("p", 2)})));
  refused(small, World(scene_of({particles("p", 20)}), {.precision = Precision::single_}));
  ballpark::Snapshot torn = world.snapshot();
  torn.columns.pop_back();
  check_refused(world, "restore", "another scene", [&] { world.restore(torn); });
  check_refused(world, "restore", "another scene", [&] { world.restore({}); });
}

TEST_CASE("Misuse: zero steps, and times already past, do nothing", "[misuse]") {
  World world(mixed());
  world.step(5);
  const std::uint64_t hash = world.state_hash();
  world.step(0);
  for (const double t : {-1.0, 0.0, world.time(), not_a_number, -inf}) world.advance_to(t);
  CHECK(world.state_hash() == hash);
  CHECK(world.steps() == 5);
}
