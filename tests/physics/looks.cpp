// The world between the steps of a run: as accurate as the run, and the times at which something happens.
#include <cmath>

#include "tests/catch.h"
#include "tests/integrators.h"
#include "tests/physics/problems.h"

using namespace ballpark;
using namespace ballpark::tests;

namespace {

/// A particle on a spring: x = cos t.
Scene swing(const std::string& integrator, double step, double tolerance = 0) {
  Scene made = scene(particle({1, 0, 0}), {spring(1)}, 6, 1, integrator);
  made.run.step = step;
  made.run.tolerance = tolerance;
  return made;
}

/// Largest error of x over many times, which no step meets.
double error_between_steps(const Scene& made) {
  World world(made);
  double worst = 0;
  constexpr int looks = 97;
  for (int k = 1; k <= looks; ++k) {
    const double t = made.run.duration * k / (looks + 0.37);
    REQUIRE(world.approach(t, made.run.duration));
    world.look_ahead(t, [&] {
      REQUIRE(std::abs(world.time() - t) < 1e-12);
      worst = std::max(worst, std::abs(world.body(0).position.x() - std::cos(t)));
    });
  }
  return worst;
}

Watch zero_of(std::function<double()> value, std::vector<double>& times) {
  return {std::move(value), [&times](double t, bool) { times.push_back(t); }};
}

}  // namespace

TEST_CASE("looks between steps are of the order of the method", "[physics]") {
  for (const IntegratorDescription& row : integrators()) {
    if (!accepts(swing("rk4", 0.1), row.name) || row.order > 6) continue;  // those are at rounding
    const double coarse = error_between_steps(swing(row.name, 6.0 / 60)),
                 fine = error_between_steps(swing(row.name, 6.0 / 120));
    INFO(row.name << ": " << coarse << ", " << fine);
    CHECK(std::log2(coarse / fine) > row.order - 0.3);
  }
}

TEST_CASE("looks between the steps of a tolerance are as accurate as its steps", "[physics]") {
  for (const IntegratorDescription& row : integrators()) {
    if (!row.adaptive) continue;
    for (const double tolerance : {1e-5, 1e-8, 1e-11}) {
      const Scene made = swing(row.name, 0, tolerance);
      World world(made);
      world.advance_to(6);
      const double at_end =
          std::abs(world.body(0).position.x() - std::cos(6.0)) + std::abs(world.body(0).velocity.x() + std::sin(6.0));
      const double between = error_between_steps(made);
      INFO(row.name << " at " << tolerance << ": " << between << ", at the end " << at_end);
      CHECK(between < 100 * tolerance);
      CHECK(between < 3 * at_end + 1e-14);
    }
  }
}

TEST_CASE("the time of an event is found to rounding where steps are exact", "[physics]") {
  // Free fall: of second order in t, so that rk4's steps make no error. 0 = 2 + 3 t - g t^2 / 2.
  const double g = 9.81, landing = (3 + std::sqrt(9 + 4 * g)) / g, apex = 3 / g;
  World world(scene(particle({0, 0, 2}, {0, 0, 3}), {gravity(g)}, 2, 1.0 / 16));
  std::vector<double> landings, tops;
  std::vector<bool> rising;
  const std::vector<Watch> watches{{[&] { return world.body(0).position.z(); },
                                    [&](double t, bool up) {
                                      landings.push_back(t);
                                      rising.push_back(up);
                                      CHECK(std::abs(world.time() - t) < 1e-15);
                                      CHECK(std::abs(world.body(0).position.z()) < 1e-14);
                                    }},
                                   zero_of([&] { return world.body(0).velocity.z(); }, tops)};
  advance_watching(world, 2, watches);
  CHECK(world.steps() == 32);
  REQUIRE(landings.size() == 1);
  REQUIRE(tops.size() == 1);
  CHECK(rising == std::vector{false});
  CHECK(std::abs(landings[0] - landing) < 4e-16 * 4);
  CHECK(std::abs(tops[0] - apex) < 4e-16);
}

TEST_CASE("an event just beside the end of a step is told to rounding", "[physics]") {
  for (const double off : {-1e-13, -1e-15, 0.0, 1e-15, 1e-13}) {
    World world(scene(particle({off, 0, 0}, {1, 0, 0}), {}, 4, 0.5));
    std::vector<double> times;
    const std::vector<Watch> watches{zero_of([&] { return world.body(0).position.x() - 1.5; }, times)};
    advance_watching(world, 4, watches);
    REQUIRE(times.size() == 1);
    CHECK(std::abs(times[0] - (1.5 - off)) < 2e-15);
  }
}

TEST_CASE("the times of a swing's passages follow the tolerance", "[physics]") {
  for (const double tolerance : {1e-6, 1e-9, 1e-12}) {
    World world(swing("dormand_prince8", 0, tolerance));
    std::vector<double> passages;
    const std::vector<Watch> watches{zero_of([&] { return world.body(0).position.x(); }, passages)};
    advance_watching(world, 6, watches);
    REQUIRE(passages.size() == 2);
    CHECK(std::abs(passages[0] - pi / 2) < 20 * tolerance);
    CHECK(std::abs(passages[1] - 3 * pi / 2) < 60 * tolerance);
  }
}

TEST_CASE("events of one step are seen in the order of their times, one of 0 at a step's end once", "[physics]") {
  World world(scene(particle({0, 0, 0}, {1, 0, 0}), {}, 4, 1));
  std::vector<int> order;
  const auto at = [&](double x, int name) {
    return Watch{[&world, x] { return world.body(0).position.x() - x; },
                 [&order, name](double, bool) { order.push_back(name); }};
  };
  const std::vector<Watch> watches{at(2.75, 3), at(2.25, 1), at(2.5, 2), at(3, 4), at(0, 0)};
  advance_watching(world, 4, watches);
  CHECK(order == std::vector{1, 2, 3, 4});
}

TEST_CASE("a watch with a limit of steps goes on where it ended", "[physics]") {
  World world(swing("rk4", 0.05));
  std::vector<double> passages;
  const std::vector<Watch> watches{zero_of([&] { return world.body(0).position.x(); }, passages)};
  while (world.steps() < 120) {
    const std::uint64_t before = world.steps();
    advance_watching(world, 6, watches, 7);
    REQUIRE(world.steps() > before);
  }
  CHECK(passages.size() == 2);
}

TEST_CASE("a look backwards is refused, and one that throws leaves the world as it was", "[physics]") {
  for (const double tolerance : {0.0, 1e-6}) {
    World world(swing("dormand_prince5", tolerance > 0 ? 0 : 0.1, tolerance));
    world.approach(3.03, 6);
    const std::uint64_t hash = world.state_hash();
    const double now = world.time();
    CHECK_THROWS_AS(world.look_ahead(1, [] {}), SceneError);
    CHECK_THROWS_AS(world.look_ahead(std::nan(""), [] {}), SceneError);
    CHECK_THROWS_AS(world.look_ahead(3.03, [] { throw std::runtime_error("looked away"); }), std::runtime_error);
    CHECK(world.state_hash() == hash);
    CHECK(world.time() == now);
    double inner = 0;
    world.look_ahead(3.23, [&] {
      world.look_ahead(3.41, [&] { inner = world.time(); });
      CHECK(std::abs(world.time() - 3.23) < 1e-12);
    });
    CHECK(std::abs(inner - 3.41) < 1e-12);
    CHECK(world.time() == now);
  }
}

TEST_CASE("a look at the end of many tiny steps is at the last of them", "[physics]") {
  std::uint64_t steps = 6'000'000;
  while (static_cast<double>(steps) * (1.2 / static_cast<double>(steps)) <= 1.2) ++steps;
  World world(swing("euler", 1.2 / static_cast<double>(steps)));
  world.step(steps);
  REQUIRE(world.time() > 1.2);  // by rounding
  REQUIRE(world.approach(1.2, 6));
  bool seen = false;
  world.look_ahead(1.2, [&] { seen = true; });
  CHECK(seen);
}

TEST_CASE("a snapshot taken in a look is of its time, and a run goes on from there", "[physics]") {
  for (const double tolerance : {0.0, 1e-9}) {
    World world(swing("dormand_prince5", tolerance > 0 ? 0 : 0.01, tolerance));
    Snapshot then;
    world.look_ahead(1.2345, [&] { then = world.snapshot(); });
    world.restore(then);
    CHECK(std::abs(world.time() - 1.2345) < 1e-12);
    CHECK(std::abs(world.body(0).position.x() - std::cos(1.2345)) < 1e-7);
    world.advance_to(2.5);
    CHECK(world.time() <= 2.5);
    CHECK(world.time() > 2.48);
    CHECK(std::abs(world.body(0).position.x() - std::cos(world.time())) < 1e-7);
  }
}

TEST_CASE("what changes the world is refused in a look, and times without end", "[physics]") {
  World world(swing("rk4", 0.1));
  world.look_ahead(0.33, [&] {
    CHECK_THROWS_AS(world.set(0, world.body(0)), SceneError);
    CHECK_THROWS_AS(world.apply_impulse(0, {1, 0, 0}), SceneError);
    CHECK_THROWS_AS(world.apply_impulse_at(0.5, 0, {1, 0, 0}), SceneError);
    CHECK_THROWS_AS(world.apply_force(0, {1, 0, 0}, 0.5, 0.6), SceneError);
  });
  CHECK_THROWS_AS(world.look_ahead(std::numeric_limits<double>::infinity(), [] {}), SceneError);
  world.apply_impulse(0, {1, 0, 0});
}

TEST_CASE("an impulse at the start acts once, whatever is looked at and restored", "[physics]") {
  Scene made = swing("dormand_prince5", 0, 1e-8);
  made.impulses = {{0, 0, {0.5, 0, 0}, Vector3d::Zero()}};
  World world(made), twin(made);
  world.approach(1e-9, 6);
  world.restore(world.snapshot());
  world.advance_to(1);
  twin.advance_to(1);
  CHECK(world.state_hash() == twin.state_hash());
}

TEST_CASE("a value that stays at 0 has its first moment of it", "[physics]") {
  World world(scene(particle({0, 0, 0}, {1, 0, 0}), {}, 4, 0.5));
  std::vector<double> times;
  const std::vector<Watch> watches{zero_of([&] { return std::max(0.0, 1.3 - world.body(0).position.x()); }, times)};
  advance_watching(world, 4, watches);
  REQUIRE(times.size() == 1);
  CHECK(std::abs(times[0] - 1.3) < 2e-15);
}

TEST_CASE("a look beyond where no step is small enough sees where the run ends", "[physics]") {
  Scene made = scene(particle({1, 0, 0}), {attraction()}, 10, 1, "dormand_prince5");
  made.run.step = 0;
  made.run.tolerance = 1e-10;
  World world(made);
  Status then;
  world.look_ahead(5, [&] { then = world.status(); });
  CHECK(then.code != Status::Code::ok);
  CHECK(world.status().code == Status::Code::ok);
  CHECK(world.time() == 0);
  CHECK_FALSE(world.approach(5, 10));
  CHECK(world.status().sentence == then.sentence);
}
