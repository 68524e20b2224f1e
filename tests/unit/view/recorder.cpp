#include "scenarios/view/recorder.h"

#include <cmath>

#include "scenarios/view/frame_times.h"
#include "scenarios/view/touching.h"
#include "tests/catch.h"

using namespace ballpark;
using namespace ballpark::view;

namespace {

/// A spinning ball, ten points that fall, and three dice, two copies of all.
Scene mixed() {
  Scene scene;
  scene.name = "mixed";
  scene.run.duration = 1;
  scene.run.step = 1.0 / 64;
  BodyGroup ball, points, dice;
  ball.name = "ball";
  ball.shape = "sphere";
  ball.radius = {0.5};
  ball.mass = {3};
  ball.position = {{100, 0, 0}};
  ball.velocity = {{2, 0, 0}};
  ball.angular_velocity = {{0, 0, 4}};
  points.name = "points";
  points.mass = {1};
  for (int i = 0; i < 10; ++i) points.position.push_back({0.1 * i, 1.0 * i, 3});
  dice.name = "dice";
  dice.mass = {2};
  dice.inertia = {{1, 2, 2.5}};
  dice.position = {{0, 0, 1}, {0, 0, 2}, {0, 0, 3}};
  dice.angular_velocity = {{1, 2, 3}};
  dice.orientation = {{std::sqrt(0.5), 0, 0, -std::sqrt(0.5)}};
  scene.bodies = {ball, points, dice};
  return scene;
}

Options two_copies() {
  Options options;
  options.copies = 2;
  options.threads = 1;
  return options;
}

Recording recorded(const Scene& scene, const Options& options, Columns columns, Limits limits = {}) {
  Recorder recorder(scene, options, columns, 3, limits);
  World world(scene, options);
  for (int f = 0; f < 3; ++f) {
    recorder.add(world);
    world.step(16);
  }
  return recorder.take();
}

}  // namespace

TEST_CASE("a recording holds the bodies by group, over all copies") {
  const Scene scene = mixed();
  const Recording recording = recorded(scene, two_copies(), {true, true, true, false});
  CHECK(recording.bodies == 28);
  CHECK(recording.shown == 28);
  REQUIRE(recording.groups.size() == 3);
  CHECK(recording.groups[0].count == 2);
  CHECK(recording.groups[1].first == 2);
  CHECK(recording.groups[2].first == 22);
  CHECK(recording.groups[0].radius == std::vector<double>{0.5});
  CHECK(recording.groups[1].radius.empty());
  CHECK_FALSE(recording.groups[0].turns);
  CHECK(recording.groups[2].turns);
  CHECK(recording.times == std::vector<double>{0, 0.25, 0.5});
  const auto x = [&](std::size_t frame, std::size_t body) {
    return recording.origin.x() + recording.position[3 * (frame * 28 + body)];
  };
  CHECK(x(0, 0) == 100);
  CHECK(x(2, 1) == 101);  // the second copy of the ball
  CHECK(std::abs(x(0, 2 + 13) - 0.3) < 1e-5);
  CHECK(recording.speed[0] == 2);
  // Balls of 3 kg at 2 m/s, with 2/5 m r^2 at 4 rad/s; a die at (1, 2, 3) rad/s turned by -90 degrees about z: its
  // own axes see (-2, 1, 3).
  CHECK(recording.energy[0] == Approx(0.5 * 3 * 4 + 0.5 * 0.4 * 3 * 0.25 * 16));
  CHECK(recording.energy[22] == Approx(0.5 * (1 * 4 + 2 * 1 + 2.5 * 9)));
  const Quaternion q = orientation_of(recording, 0, 22);
  CHECK(std::abs(q.w - std::sqrt(0.5)) < 1e-4);
  CHECK(std::abs(q.z + std::sqrt(0.5)) < 1e-4);
  CHECK(orientation_of(recording, 0, 0).w == Approx(1));
  CHECK(recording.label == "rk4, step 0.015625 s");
}

TEST_CASE("of the series, one number a frame") {
  const Scene scene = mixed();
  const Recording recording = recorded(scene, two_copies(), {});
  REQUIRE(recording.series.size() == 6);  // bodies that do not touch have no contacts to tell of
  for (const Series& series : recording.series) {
    CHECK(series.values.size() == 3);
    for (const double value : series.values) CHECK((value > 0 || series.name == "potential energy"));
  }
  CHECK(recording.series[3].values[1] == Approx(2 * 3 * 2));  // momentum of both balls
}

TEST_CASE("where there is no room for all, every group shows its first and each further k-th") {
  const Scene scene = mixed();
  const Recording recording = recorded(scene, two_copies(), {}, {7, 1e9});
  CHECK(recording.stride == 4);
  CHECK(recording.shown == 1 + 5 + 2);
  const auto y = [&](std::size_t body) { return recording.origin.y() + recording.position[3 * body + 1]; };
  CHECK(std::abs(y(1) - 0) < 1e-5);
  CHECK(std::abs(y(2) - 4) < 1e-5);
  CHECK(std::abs(y(4) - 2) < 1e-5);  // 12 is 2 of the second copy
  // 22 bytes each of three frames: room for 4 bodies.
  CHECK(recorded(scene, two_copies(), {}, {100, 22 * 3 * 4.5}).stride == 7);
}

TEST_CASE("bodies that are no longer finite stay, and the notes say so") {
  Scene scene = mixed();
  scene.bodies[1].velocity = {{1e200, 0, 0}};
  scene.effects = {{"quadratic_drag", {"points"}, {{"coefficient", 1.0}}}};
  const Recording recording = recorded(scene, Options{}, {});
  REQUIRE(recording.notes.size() == 1);
  CHECK(recording.notes[0] == "10 of the shown bodies are no longer finite: they stay where they last were");
  const std::size_t frame = recording.shown * 3;
  CHECK(recording.position[2 * frame + 3] == recording.position[3]);
}

TEST_CASE("balls that spin are given orientations, others nothing") {
  Scene scene = mixed();
  scene.contact.kind = "impulse";
  scene.materials["rough"] = {0.5, 0.3};
  scene.bodies[0].material = "rough";
  let_spinning_balls_turn(scene, Options{});
  CHECK(scene.bodies[0].orientation.size() == 1);
  CHECK(scene.bodies[1].orientation.empty());
  CHECK(check(scene).empty());
  Scene as_it_was = scene;
  as_it_was.bodies[0].orientation.clear();
  World turning(scene), plain(as_it_was);
  turning.step(16);
  plain.step(16);
  CHECK(turning.body(0).position == plain.body(0).position);
  CHECK(turning.body(0).has_orientation);
}

TEST_CASE("frames are evenly apart, one a step at most, and the last at the end") {
  CHECK(frame_times(2, 5) == std::vector<double>{0, 0.5, 1, 1.5, 2});
  CHECK(frame_times(2, 1) == std::vector<double>{0});
  CHECK(frame_times(0, 301).size() == 301);
  CHECK(frame_times(1, 0, 0.3) == std::vector<double>{0, 0.3, 0.6, 0.3 * 3});
  CHECK(frame_times(1, 0, 0.1).size() == 11);
  RunSettings run;
  run.duration = 1;
  run.step = 0.1;
  CHECK(frames_of(run, frame_times(1, 301)) == 11);
  CHECK(frames_of(run, frame_times(3, 31)) == 11);  // another run is longer
  CHECK(frames_of(run, frame_times(1, 3)) == 3);
  run.step = 0;
  run.tolerance = 1e-6;
  CHECK(frames_of(run, frame_times(1, 301)) == 301);
  run.duration = 0;
  CHECK(frames_of(run, frame_times(0, 301)) == 1);
}

TEST_CASE("touching counts neighbours and walls by geometry") {
  Scene scene;
  scene.run.duration = 1;
  scene.run.step = 0.1;
  scene.contact.kind = "impulse";
  BodyGroup balls;
  balls.name = "balls";
  balls.shape = "sphere";
  balls.radius = {0.5};
  balls.mass = {1};
  balls.position = {{0.5, 5, 0.5}, {1.5, 5, 0.5}, {2.5, 5, 0.5}, {4.5, 5, 5}, {9.5, 5, 5}};
  scene.bodies = {balls};
  Boundary ground;
  ground.shape = "plane";
  Boundary repeating;
  repeating.shape = "periodic";
  repeating.size = {10, 0, 0};
  repeating.point = {5, 0, 0};
  scene.boundaries = {ground, repeating};
  Options copies;
  copies.copies = 2;
  const std::vector<std::uint8_t> wanted{2, 3, 2, 0, 0, 2, 3, 2, 0, 0};
  CHECK(touching(scene, World(scene, copies), 2) == wanted);
  scene.bodies[0].position[4] = {9.5, 5, 0.5};  // beyond the seam it touches the first, and the ground
  CHECK(touching(scene, World(scene), 1) == std::vector<std::uint8_t>{3, 3, 2, 0, 2});
  scene.bodies[0].position[3] = {4.5, 5, 0.52};
  CHECK(touching(scene, World(scene), 1)[3] == 0);  // 2 cm are not near enough
  Boundary box;
  box.shape = "box";
  box.point = {5, 5, 5};
  box.size = {10, 1, 10};
  box.open = {"+y"};
  scene.boundaries = {box};
  CHECK(touching(scene, World(scene), 1) == std::vector<std::uint8_t>{4, 4, 3, 1, 3});
  scene.contact.kind = "";
  scene.boundaries = {};
  CHECK(touching(scene, World(scene), 1) == std::vector<std::uint8_t>(5, 0));
}
