// The opening angle of attraction's tree as a way to run a scene: what it gets wrong is held against every pair.
#include <algorithm>
#include <cmath>

#include "perf/cost/cost.h"
#include "perf/cost/result_json.h"
#include "perf/cost/subject.h"
#include "tests/catch.h"

using namespace ballpark;
using namespace ballpark::cost;

namespace {

Scene stars(std::size_t count, double opening_angle) {
  Scene scene;
  scene.run = {.duration = 0.5, .step = 0.05, .integrator = "velocity_verlet"};
  BodyGroup group{.name = "stars", .mass = {1 / static_cast<double>(count)}};
  group.generate = Generate{.kind = "plummer", .count = {count}, .scale = 1, .strength = 1};
  scene.bodies = {group};
  scene.effects = {{"mutual_gravity", {}, {{"strength", 1.0}, {"softening", 0.2}, {"opening_angle", opening_angle}}}};
  return scene;
}

const Point& point_of(const Result& result, double opening_angle) {
  return *std::find_if(result.points.begin(), result.points.end(),
                       [&](const Point& p) { return p.setting.opening_angle == opening_angle; });
}

}  // namespace

TEST_CASE("openings: an angle belongs to scenes in which enough bodies attract each other", "[cost]") {
  CHECK(setting_of(stars(255, 0.5)).opening_angle == -1);
  const Scene scene = stars(256, 0.7);
  Setting setting = setting_of(scene);
  CHECK(setting.opening_angle == 0.7);
  CHECK(text(setting) == "velocity_verlet, step 0.05 s, opening 0.7");
  setting.opening_angle = 0;
  CHECK(text(setting) == "velocity_verlet, step 0.05 s, every pair");
  CHECK(setting_of(scene_with(scene, setting)) == setting);
  CHECK_FALSE(same_curve(setting, setting_of(scene)));
}

TEST_CASE("openings: the reference sums every pair, and a tree's error does not fall with the step", "[cost]") {
  Request request;
  request.seconds = 4;
  request.reference = "runs";
  request.axes.integrators = {"velocity_verlet"};
  request.axes.steps = {0.025};
  request.axes.precisions = {Precision::double_};
  request.axes.openings = {0.5, 1, 0};
  const auto result = ballpark::cost::cost(stars(300, 0.5), request, [](const std::string&, double) { return true; });
  REQUIRE(result);
  REQUIRE(result->points.size() == 3);
  CHECK(result->curves[0].label == "velocity_verlet, opening 0.5");
  CHECK(result->curves[2].label == "velocity_verlet, every pair");
  const double wide = point_of(*result, 1).error, usual = point_of(*result, 0.5).error,
               none = point_of(*result, 0).error;
  CHECK(wide > 2 * usual);
  CHECK(usual > 0);
  CHECK(none > 0);
  CHECK(to_json(*result)["points"][1]["opening_angle"] == 1.0);
  CHECK(to_csv(*result).find(",opening_angle,") != std::string::npos);
}
