// Errors that are measured: of tracks made for it, and of scenes whose closed form is known and withheld.
#include <cmath>

#include "ballpark/scenes.h"
#include "perf/cost/cost.h"
#include "perf/cost/horizon.h"
#include "perf/cost/order.h"
#include "tests/catch.h"

using namespace ballpark;
using namespace ballpark::cost;

namespace {

const GoOn always = [] { return true; };

Scene scenario(const std::string& name) {
  return scenes::load(std::string(BALLPARK_SCENARIOS_FOLDER) + "/" + name + ".toml").scene;
}

BodyState turned(double angle) {
  BodyState state;
  state.has_orientation = true;
  state.orientation = {std::cos(angle / 2), 0, std::sin(angle / 2), 0};
  return state;
}

Setting fixed(const std::string& integrator, const Scene& scene, double steps) {
  return {integrator, scene.run.duration / steps, 0, Precision::double_};
}

}  // namespace

TEST_CASE("errors: largest and last distances, and their root of mean square", "[cost]") {
  const Samples samples = samples_of(3, 2, 3, 10);
  CHECK(samples.times == std::vector<double>{1, 2, 3});
  Track track(samples), reference(samples);
  track.known = reference.known = {1, 1, 1};
  track.states[1].position = {3, 0, 0};
  track.states[2].position = {0, 4, 0};
  track.states[5].position = {0, 0, 1};
  const Errors errors = errors_of(track, reference, {});
  CHECK(errors[Quantity::position].maximum == 4);
  CHECK(errors[Quantity::position].end == 1);
  CHECK(std::abs(errors[Quantity::position].rms - std::sqrt(26.0 / 6)) < 1e-15);
  CHECK(value_of(errors, Quantity::position, "end") == 1);
  track.known = {1, 0, 1};  // what was not looked at does not count
  CHECK(errors_of(track, reference, {})[Quantity::position].maximum == 3);
}

TEST_CASE("errors: an orientation's is the angle, small ones to rounding, and either sign of q is the same", "[cost]") {
  const Samples samples = samples_of(1, 1, 1, 1);
  Track track(samples), reference(samples);
  track.known = reference.known = {1};
  reference.states[0] = turned(0.3);
  for (const double angle : {1e-9, 0.5, 3.0}) {
    track.states[0] = turned(0.3 + angle);
    const double told = errors_of(track, reference, {})[Quantity::orientation].maximum;
    CHECK(std::abs(told - angle) < 1e-15 + 1e-14 * angle);
    const Quaternion q = track.states[0].orientation;
    track.states[0].orientation = {-q.w, -q.x, -q.y, -q.z};
    CHECK(std::abs(errors_of(track, reference, {})[Quantity::orientation].maximum - told) < 1e-15);
  }
}

TEST_CASE("references: with the closed form withheld the error is told within a factor of 3", "[cost]") {
  for (const char* name : {"pendulum", "kepler", "oscillator", "spinning_top", "tumbling"}) {
    Scene scene = scenario(name);
    scene.run.compensated = false;
    const auto known = ground_for(scene, {}, always);
    GroundRequest withheld;
    withheld.reference = "numerical";
    const auto unknown = ground_for(scene, withheld, always);
    REQUIRE(known);
    REQUIRE(unknown);
    CHECK(known->about.reference.kind == "closed form");
    CHECK(unknown->about.reference.kind == "extrapolation in extended precision");
    int compared = 0;
    for (const char* integrator : {"midpoint", "rk4", "dormand_prince8", "velocity_verlet"}) {
      for (const double steps : {200, 1000, 10000}) {
        const Point truth = measured_point(*known, fixed(integrator, scene, steps), always);
        const Point told = measured_point(*unknown, fixed(integrator, scene, steps), always);
        if (!truth.claimed || !told.claimed) continue;
        INFO(name << ", " << integrator << ", " << steps << ": " << told.error << " for " << truth.error);
        CHECK(told.error < 3 * truth.error);
        CHECK(truth.error < 3 * told.error);
        CHECK(told.state_hash == truth.state_hash);
        ++compared;
      }
    }
    CHECK(compared >= 8);
  }
}

TEST_CASE("references: the two finest runs tell the error within a factor of 3 where they claim one", "[cost]") {
  const Scene scene = scenario("kepler");
  GroundRequest withheld;
  withheld.reference = "runs";
  withheld.seconds = 1;
  const auto known = ground_for(scene, {}, always), unknown = ground_for(scene, withheld, always);
  REQUIRE(known);
  REQUIRE(unknown);
  CHECK(unknown->about.reference.kind == "two finest runs");
  for (const double steps : {500, 2000}) {
    const Point truth = measured_point(*known, fixed("rk4", scene, steps), always);
    const Point told = measured_point(*unknown, fixed("rk4", scene, steps), always);
    CHECK(told.claimed);
    CHECK(std::abs(std::log(told.error / truth.error)) < std::log(3.0));
  }
}

TEST_CASE("a point beyond its stability limit is in trouble, with the limit", "[cost]") {
  const Scene scene = scenario("oscillator");
  const auto ground = ground_for(scene, {}, always);
  REQUIRE(ground);
  const Point point = measured_point(*ground, fixed("rk4", scene, 1), always);
  CHECK(point.trouble.find("exceeds") != std::string::npos);
}

TEST_CASE("sweep: finer points of a curve are more accurate until rounding, and all end as they were looked at",
          "[cost]") {
  const Scene scene = scenario("pendulum");
  Request request;
  request.seconds = 10;
  request.axes.integrators = {"euler", "rk4", "dormand_prince5"};
  request.axes.rotations = {"renormalise"};
  request.tolerance = 1e-6;
  const auto result = cost::cost(scene, request, [](const std::string&, double) { return true; });
  REQUIRE(result);
  CHECK(result->curves.size() == 8);  // in two precisions, dormand_prince5 with a step and with a tolerance
  for (const Curve& curve : result->curves) {
    double best = 1e300;
    for (const std::size_t i : curve.points) {
      const Point& point = result->points[i];
      if (!point.trouble.empty() || point.error > 0.01) continue;
      INFO(curve.label << ", step " << point.setting.step << ", tolerance " << point.setting.tolerance);
      if (curve.precision == Precision::double_ && best > 1e-10) CHECK(point.error < best * 1.01);
      best = std::min(best, point.error);
      CHECK(point.seconds.runs >= 3);
      CHECK(point.seconds.minimum <= point.seconds.median);
    }
  }
  REQUIRE(result->recommended);
  CHECK(result->points[result->recommended->point].error * 2 <= 1e-6);
  CHECK(result->recommended->confirmed_error == result->points[result->recommended->point].error);
  REQUIRE(result->paths.size() == 3);
  CHECK(result->paths[0].points.size() > 100);
}

TEST_CASE("sweep: how bodies turn is an axis, where they do", "[cost]") {
  Axes axes;
  axes.integrators = {"rk4", "velocity_verlet"};
  axes.precisions = {Precision::double_};
  const auto labels = [&](const char* name) {
    std::vector<std::string> refused, found;
    Scene scene = scenario(name);
    scene.run.compensated = false;
    for (const Candidate& candidate : candidates(scene, axes, 20, refused)) {
      found.push_back(candidate.curve.label);
      CHECK(candidate.settings.front().rotation.empty() == (std::string(name) == "oscillator"));
    }
    CHECK(refused.empty() == axes.rotations.empty());
    return found;
  };
  using Labels = std::vector<std::string>;
  CHECK(labels("oscillator") == Labels{"rk4", "velocity_verlet"});
  CHECK(labels("pendulum") == Labels{"rk4", "velocity_verlet", "rk4, exponential", "velocity_verlet, exponential",
                                     "velocity_verlet, splitting"});
  CHECK(labels("tumbling") == Labels{"rk4", "velocity_verlet", "rk4, exponential", "velocity_verlet, exponential",
                                     "velocity_verlet, splitting", "rk4, body"});
  axes.rotations = {"splitting"};
  CHECK(labels("free_top") == Labels{"velocity_verlet, splitting"});
}

TEST_CASE("a scene that turns by splitting has a reference of another family", "[cost]") {
  Scene scene = scenario("tumbling");
  scene.run.compensated = false;
  scene.run.rotation = "splitting";
  scene.run.integrator = "velocity_verlet";
  scene.run.tolerance = 0;
  scene.run.absolute_tolerance = 0;
  scene.run.step = scene.run.duration / 1000;
  GroundRequest request;
  request.reference = "numerical";
  const auto ground = ground_for(scene, request, always);
  REQUIRE(ground);
  CHECK(ground->about.reference.kind == "extrapolation in extended precision");
  CHECK(ground->about.reference.setting->rotation == "renormalise");
}

TEST_CASE("scales: how far bodies go from their start, wherever that is", "[cost]") {
  Samples samples = samples_of(2, 1, 2, 1);
  samples.start.resize(1);
  samples.start[0].position = {1e4, 0, 0};
  Track track(samples);
  for (BodyState& state : track.states) state.position = {1e4 + 3, 4, 0};
  CHECK(scale_of(track, samples)[0] == 5);
  CHECK(size_of(track)[0] > 1e4);
  for (BodyState& state : track.states) state.position = {1e4, 0, 0};  // back at each look, but not at rest
  for (BodyState& state : track.states) state.velocity = {0, 50, 0};
  CHECK(scale_of(track, samples)[0] == 5);
  for (BodyState& state : track.states) state.velocity = {0, 0, 0};
  CHECK(scale_of(track, samples)[0] == 1e4);
}

TEST_CASE("looks: at whole steps of the scene, and as well between those of others", "[cost]") {
  Scene scene = scenario("oscillator");
  scene.run.duration = 1;
  scene.run.step = 1.0 / 64;
  const auto ground = ground_for(scene, {}, always);
  REQUIRE(ground);
  CHECK(ground->samples.times.size() == 16);
  const Point whole = measured_point(*ground, fixed("rk4", scene, 64), always),
              between = measured_point(*ground, fixed("rk4", scene, 71), always);
  CHECK(whole.trouble.empty());
  CHECK(between.trouble.empty());
  CHECK(between.error < whole.error);  // (64 / 71)^4 of it
  CHECK(between.error > whole.error / 2);
}

TEST_CASE("bodies that only turn: the two finest runs go on until the angle has settled", "[cost]") {
  Scene scene = scenario("free_top");
  GroundRequest request;
  request.reference = "runs";
  request.seconds = 8;
  const auto ground = ground_for(scene, request, always);
  REQUIRE(ground);
  CHECK(ground->measure.quantity == Quantity::orientation);
  CHECK(ground->about.reference.error_bar[2] < 1e-10);
}

TEST_CASE("horizon: random starts and steps too long are no chaos", "[cost]") {
  Scene gas = scenario("gas");
  gas.run.duration = 0.05;  // before spheres meet often
  CHECK_FALSE(find_horizon(gas, {}, always));
  Scene growing = scenario("oscillator");
  growing.run.integrator = "euler";
  growing.run.step = 0.5;
  CHECK_FALSE(find_horizon(growing, {}, always));
}

TEST_CASE("horizon: runs of a break part, those of an orbit do not", "[cost]") {
  CHECK_FALSE(find_horizon(scenario("kepler"), {}, always));
  const auto horizon = find_horizon(scenario("break"), {}, always);
  REQUIRE(horizon);
  CHECK(horizon->time > 0.1);
  CHECK(horizon->time < 2);
  CHECK(horizon->lyapunov_time > 0.01);
  CHECK(horizon->uncertainty > 0);
}

TEST_CASE("observed orders: each method's own on an orbit, less on bodies that turn for splittings", "[cost]") {
  Request request;
  request.seconds = 8;
  request.axes.integrators = {"euler", "velocity_verlet", "rk4", "forest_ruth"};
  Scene orbit = scenario("kepler");
  orbit.run.duration = 2;
  const auto on_orbit = observed_orders(orbit, request, [](const std::string&, double) { return true; });
  REQUIRE(on_orbit);
  for (const ObservedOrder& row : on_orbit->rows) {
    INFO(row.integrator);
    REQUIRE(row.observed);
    CHECK(std::abs(*row.observed - row.order) < 0.2);
  }
  const auto turning = observed_orders(scenario("pendulum"), request, [](const std::string&, double) { return true; });
  REQUIRE(turning);
  REQUIRE(turning->rows.back().observed);
  CHECK(std::abs(*turning->rows.back().observed - 2) < 0.2);
}
