// Errors of the times of events: they fall as the method's order says, and are told where the closed form is withheld.
#include <cmath>

#include "ballpark/scenes.h"
#include "perf/cost/ground.h"
#include "perf/cost/sweep.h"
#include "tests/catch.h"

using namespace ballpark;
using namespace ballpark::cost;

namespace {

const GoOn always = [] { return true; };

Scene pendulum() {
  return scenes::load(std::string(BALLPARK_SCENARIOS_FOLDER) + "/pendulum.toml").scene;
}

/// The pendulum hangs straight down.
const scenes::BodyEvent passage{"passage", 0, [](const BodyState& bob) { return bob.position.x(); }};
constexpr double period = 2.36784194757623745;

std::optional<Ground> ground_of(const Scene& scene, const std::string& reference) {
  GroundRequest request;
  request.reference = reference;
  request.events = {passage};
  return ground_for(scene, request, always);
}

Setting with_steps(const std::string& integrator, const Scene& scene, double steps) {
  return {integrator, scene.run.duration / steps, 0, Precision::double_};
}

double event_error(const Ground& ground, const Setting& setting) {
  const Point point = measured_point(ground, setting, always);
  INFO(setting.integrator << " " << setting.step << " " << setting.tolerance);
  CHECK(point.trouble.empty());
  CHECK(point.errors.events.different.empty());
  return point.errors.events.time;
}

}  // namespace

TEST_CASE("event times: of an exact trajectory, to rounding", "[cost]") {
  const auto ground = ground_of(pendulum(), "best");
  REQUIRE(ground);
  CHECK(ground->about.reference.kind == "closed form");
  REQUIRE(ground->about.events.size() == 1);
  const std::vector<double>& times = ground->about.events[0].times;
  REQUIRE(times.size() == 8);
  for (std::size_t k = 0; k < times.size(); ++k) {
    CHECK(std::abs(times[k] - (2 * static_cast<double>(k) + 1) * period / 4) < 4e-15 * (1 + times[k]));
  }
  CHECK(ground->about.reference.event_bar < 1e-13);
}

TEST_CASE("event times: their errors fall by the method's order", "[cost]") {
  const Scene scene = pendulum();
  const auto ground = ground_of(scene, "best");
  REQUIRE(ground);
  const std::pair<const char*, double> methods[] = {{"velocity_verlet", 2}, {"ruth3", 2}, {"midpoint", 2}, {"rk4", 4}};
  for (const auto& [method, order] : methods) {
    const double coarse = event_error(*ground, with_steps(method, scene, 1000));
    const double fine = event_error(*ground, with_steps(method, scene, 2000));
    INFO(method << ": " << coarse << ", " << fine);
    CHECK(std::abs(std::log2(coarse / fine) - order) < 0.3);
  }
  const auto adaptive = [&](double tolerance) {
    return event_error(*ground, {"dormand_prince5", 0, tolerance, Precision::double_});
  };
  const double loose = adaptive(1e-6), tight = adaptive(1e-9);
  INFO(loose << ", " << tight);
  CHECK(std::abs(std::log10(loose / tight) / 3 - 1) < 0.25);
  CHECK(tight < 1e-6);
}

TEST_CASE("event times: with the closed form withheld the error is told within a factor of 3", "[cost]") {
  const Scene scene = pendulum();
  const auto known = ground_of(scene, "best");
  REQUIRE(known);
  for (const char* reference : {"numerical", "runs"}) {
    const auto unknown = ground_of(scene, reference);
    REQUIRE(unknown);
    CHECK(unknown->about.reference.event_bar < 1e-8);
    for (const char* integrator : {"rk4", "velocity_verlet"}) {
      const Setting setting = with_steps(integrator, scene, 500);
      const double truth = event_error(*known, setting), told = event_error(*unknown, setting);
      INFO(reference << ", " << integrator << ": " << told << " for " << truth);
      CHECK(told > unknown->about.event_floor());
      CHECK(std::abs(std::log(told / truth)) < std::log(3.0));
    }
  }
}

TEST_CASE("event times: another count is no number", "[cost]") {
  const scenes::EventTimes one{"a", 1, {0.5}, 0.5}, two{"a", 2, {0.5, 1}, 1}, late{"b", 1, {0.75}, 0.75};
  const EventErrors same = event_errors({one, late}, {one, {"b", 1, {0.5}, 0.5}});
  CHECK(same.time == 0.25);
  CHECK(same.different.empty());
  const EventErrors other = event_errors({two, late}, {one, late});
  CHECK(std::isinf(other.time));
  CHECK(other.different == "a: 2 times instead of 1");
}
