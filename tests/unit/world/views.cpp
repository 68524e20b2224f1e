// Reading a world: views in place, rows and ids, constants, single bodies.
#include <limits>
#include <type_traits>

#include "tests/catch.h"
#include "tests/unit/world/made_scenes.h"

using namespace made_scenes;
using ballpark::Precision;
using ballpark::View;
using ballpark::World;

namespace {

Scene three_groups() {
  BodyGroup turned = bricks("b", 5);
  turned.orientation = {{0.5, 0.5, -0.5, 0.5}};
  return scene_of({turned, particles("p", 20), spinning(balls("s", 3))}, {effect("gravity")});
}

/// Every view of every body says what body() says.
template <class Real>
void check_views(const World& world) {
  const View<Real> x = world.view<Real>("position"), v = world.view<Real>("velocity");
  const View<Real> q = world.view<Real>("orientation");
  REQUIRE(x.components.size() == 3);
  REQUIRE(q.components.size() == 4);
  for (std::size_t id = 0; id < world.body_count(); ++id) {
    const ballpark::BodyState body = world.body(id);
    const std::size_t row = world.row_of(id);
    CAPTURE(id, row);
    for (std::size_t c = 0; c < 3; ++c) {
      CHECK(static_cast<double>(x[c][row - x.first_row]) == body.position[static_cast<Eigen::Index>(c)]);
      CHECK(static_cast<double>(v[c][row - v.first_row]) == body.velocity[static_cast<Eigen::Index>(c)]);
    }
    if (!body.has_orientation) continue;
    CHECK(static_cast<double>(q[0][row - q.first_row]) == body.orientation.w);
    CHECK(static_cast<double>(q[3][row - q.first_row]) == body.orientation.z);
  }
}

}  // namespace

TEST_CASE("Views: say what body() says, before and after steps, in all copies", "[views]") {
  for (const int copies : {1, 3}) {
    World wide(three_groups(), {.copies = copies});
    World narrow(three_groups(), {.precision = Precision::single_, .copies = copies});
    World widest(three_groups(), {.precision = Precision::extended, .copies = copies});
    for (int i = 0; i < 2; ++i) {
      check_views<double>(wide);
      check_views<float>(narrow);
      check_views<long double>(widest);
      wide.step(3);
      narrow.step(3);
      widest.step(3);
    }
  }
}

TEST_CASE("Views: are the live columns, in place from step to step", "[views]") {
  World world(three_groups());
  const View<double> x = world.view<double>("position"), again = world.view<double>("position");
  CHECK(x[0].data() == again[0].data());
  static_assert(std::is_same_v<decltype(x[0]), std::span<const double>>);
  const std::size_t row = world.row_of(7) - x.first_row;
  const double before = x[2][row];
  const double* place = &x[2][row];
  world.step(4);
  CHECK(world.view<double>("position")[2].data() == x[2].data());
  CHECK(*place != before);
  CHECK(*place == world.body(7).position.z());
}

TEST_CASE("Views: end with the last body", "[views]") {
  const World one(scene_of({particles("p", 5)}, {}));
  CHECK(one.view<double>("position")[0].size() == 5);
  const World none(scene_of({particles("p", 0)}, {}));
  CHECK(none.view<double>("position")[0].empty());
  const World several(three_groups());
  const View<double> x = several.view<double>("position"), q = several.view<double>("orientation");
  std::size_t last = 0;
  for (std::size_t id = 0; id < several.body_count(); ++id) last = std::max(last, several.row_of(id));
  CHECK(x.first_row + x[0].size() == last + 1);
  CHECK(q.first_row + q[0].size() == last + 1);
}

TEST_CASE("Views: ids are in the order of the scene, rows each body's own", "[views]") {
  const World world(three_groups(), {.copies = 2});
  REQUIRE(world.body_count() == 56);
  std::vector<std::size_t> rows;
  for (std::size_t id = 0; id < 56; ++id) rows.push_back(world.row_of(id));
  std::sort(rows.begin(), rows.end());
  CHECK(std::adjacent_find(rows.begin(), rows.end()) == rows.end());
  CHECK(world.body(0).position == Vector3d(1, 0.3, 2));
  CHECK(world.body(4).position == particles("", 5).position[4]);
  CHECK(world.body(5 + 19).position == particles("", 20).position[19]);
  CHECK(world.body(28 + 5 + 20 + 2).position == particles("", 3).position[2]);
  CHECK(world.body(0).has_orientation);
  CHECK_FALSE(world.body(5).has_angular_velocity);
  CHECK(world.body(25).has_angular_velocity);
  CHECK_FALSE(world.body(25).has_orientation);
}

TEST_CASE("Views: what a body was given is what it has", "[views]") {
  const World world(three_groups());
  const BodyGroup bricks_given = bricks("b", 5), balls_given = spinning(balls("s", 3));
  for (std::size_t i = 0; i < 5; ++i) {
    CHECK(close(world.body(i).angular_velocity, bricks_given.angular_velocity[i]));
    CHECK(world.body(i).orientation.y == -0.5);
  }
  CHECK(close(world.body(26).angular_velocity, balls_given.angular_velocity[1]));
  CHECK(world.body(26).velocity == balls_given.velocity[1]);
}

TEST_CASE("Views: wrong names and precisions are refused with the nearest choice", "[views]") {
  const World world(three_groups()), particles_only(scene_of({particles("p", 2)}));
  const Problem typo = refusal([&] { world.view<double>("positon"); });
  CHECK(typo.path == "view");
  CHECK(contains(typo.message, "\"positon\""));
  CHECK(contains(typo.message, "\"position\"?"));
  CHECK(contains(refusal([&] { particles_only.view<double>("orientation"); }).message, "position, velocity"));
  CHECK(contains(refusal([&] { particles_only.view<double>("angular_momentum"); }).message, "no column"));
  CHECK(contains(refusal([&] { world.view<float>("position"); }).message, "view<double>"));
  CHECK(contains(refusal([&] { world.view<long double>("position"); }).message, "precision"));
  const World narrow(three_groups(), {.precision = Precision::single_});
  CHECK(contains(refusal([&] { narrow.view<double>("position"); }).message, "view<float>"));
}

TEST_CASE("Views: constants by group, refused where they are columns or absent", "[views]") {
  BodyGroup dense = balls("dense", 2), mixed = particles("mixed", 2);
  dense.mass.clear();
  dense.density = {1000};
  mixed.mass = {1, 2};
  const World world(scene_of({particles("p", 2), balls("s", 2), dense, mixed}));
  CHECK(world.constant("mass", "p") == 2);
  CHECK(world.constant("radius", "s") == 0.1);
  CHECK(world.constant("density", "dense") == 1000);
  CHECK(close(world.constant("mass", "dense"), 1000 * 4.0 / 3 * 3.141592653589793 * 1e-3));
  CHECK(refusal([&] { world.constant("mass", "mixed"); }).path == "constant");
  CHECK(contains(refusal([&] { world.constant("radius", "p"); }).message, "\"radius\" is no constant of group p"));
  CHECK(contains(refusal([&] { world.constant("raduis", "s"); }).message, "\"radius\"?"));
  CHECK(contains(refusal([&] { world.constant("mass", "mixd"); }).message, "\"mixed\"?"));
}

TEST_CASE("Views: an unknown id is out of range", "[views]") {
  const World world(three_groups()), empty(scene_of({}));
  CHECK_THROWS_AS(world.row_of(28), std::out_of_range);
  CHECK_THROWS_AS(world.row_of(std::numeric_limits<std::size_t>::max()), std::out_of_range);
  CHECK_THROWS_AS(empty.row_of(0), std::out_of_range);
  CHECK(contains(refusal([&] { world.body(28); }).message, "below 28"));
}
