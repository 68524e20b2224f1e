// The front, the crossovers and the settings to take, from points made for it.
#include "perf/cost/choice.h"

#include <cmath>
#include <cstdint>
#include <limits>

#include "tests/catch.h"

using namespace ballpark::cost;

namespace {

Point point(std::size_t curve, double error, double seconds) {
  Point made;
  made.setting.integrator = curve == 0 ? "slow start" : "fast end";
  made.curve = curve;
  made.error = error;
  made.claimed = true;
  made.seconds = {seconds, seconds, seconds, 9};
  return made;
}

/// Time ~ error^-(1/order): one curve of order 2, one of order 4 that costs more to begin with. They cross at 1e-4.
Result two_curves() {
  Result result;
  result.measure_unit = "m";
  result.floor = 1e-12;
  result.ceiling = 1;
  for (std::size_t c = 0; c < 2; ++c) {
    Curve curve;
    curve.label = c == 0 ? "second" : "fourth";
    for (int exponent = 1; exponent <= 8; ++exponent) {
      const double error = std::pow(10.0, -exponent), order = c == 0 ? 2 : 4;
      curve.points.push_back(result.points.size());
      result.points.push_back(point(c, error, 1e-6 * (c == 0 ? 1 : 10) * std::pow(error, -1 / order)));
    }
    result.curves.push_back(curve);
  }
  return result;
}

}  // namespace

TEST_CASE("front: nothing on it is beaten in both, nothing off it is unbeaten", "[cost]") {
  Result result = two_curves();
  result.points[11].seconds.minimum *= 1.01;   // as good as another one, but for this
  result.points.push_back(point(0, 1e-3, 1));  // slow
  const auto front = mark_front(result);
  REQUIRE(front.size() == 8);
  for (std::size_t i = 0; i < result.points.size(); ++i) {
    bool beaten = false;
    for (const Point& other : result.points) {
      const Point& mine = result.points[i];
      beaten = beaten || (other.error <= mine.error && other.seconds.minimum < mine.seconds.minimum) ||
               (other.error < mine.error && other.seconds.minimum <= mine.seconds.minimum);
    }
    CHECK(result.points[i].front == !beaten);
  }
}

TEST_CASE("front: what is in trouble, not finite, or below the floor once more is not on it", "[cost]") {
  Result result = two_curves();
  result.points[0].trouble = "exceeds its limit";
  result.points[1].error = std::numeric_limits<double>::quiet_NaN();
  result.floor = 1e-6;  // both 1e-7 and 1e-8 can't be told from 1e-6
  const auto front = mark_front(result);
  CHECK_FALSE(result.points[0].front);
  CHECK_FALSE(result.points[1].front);
  CHECK(result.points[front.back()].error == 1e-6);
  result.ceiling = 1e-3;
  for (const std::size_t i : mark_front(result)) CHECK(result.points[i].error <= 1e-3);
}

TEST_CASE("crossovers: told where they are, with the gain where both end", "[cost]") {
  const std::vector<std::string> sentences = crossovers(two_curves());
  REQUIRE(sentences.size() == 1);
  // Worth telling where the gain is a quarter: a little below 1e-4; at 1e-8 it is 10 times.
  CHECK(sentences[0] == "below 4e-05 m fourth is cheaper than second, by up to 10.0 times, at 1e-08 m");
}

TEST_CASE("crossovers: none is claimed outside what both were measured at", "[cost]") {
  Result result = two_curves();
  result.curves[0].points.resize(3);       // ends at 1e-3
  result.curves[1].points = {13, 14, 15};  // begins at 1e-6
  const auto sentences = crossovers(result);
  REQUIRE(sentences.size() == 1);
  CHECK(sentences[0].find("times") == std::string::npos);
  CHECK(sentences[0].find("second does not come so far") != std::string::npos);
  CHECK(comparison(result, "fourth", "third").empty());
  CHECK(comparison(two_curves(), "fourth", "second") == "at 1e-08 m second takes 10 times as long as fourth");
}

TEST_CASE("crossovers: the cheapest at every error is what the front says, and a floor of 0 ends too", "[cost]") {
  Result result = two_curves();
  result.curves[1].points.erase(result.curves[1].points.begin(), result.curves[1].points.begin() + 4);   // from 1e-5 on
  for (const std::size_t i : result.curves[1].points) result.points[i].seconds = {1e-6, 1e-6, 1e-6, 9};  // cheap
  result.floor = 0;
  const auto sentences = crossovers(result);  // nothing is cheaper than the second curve, however coarse
  CHECK(sentences.empty());
}

TEST_CASE("settings accurate enough keep the margin, and the fastest comes first", "[cost]") {
  Result result = two_curves();
  const auto list = accurate_enough(result, 1e-5, 2);  // at most 5e-6
  REQUIRE(!list.empty());
  CHECK(result.points[list.front()].error == 1e-6);
  CHECK(result.points[list.front()].curve == 1);
  for (std::size_t k = 1; k < list.size(); ++k) {
    CHECK(result.points[list[k]].error <= 5e-6);
    CHECK(result.points[list[k]].seconds.minimum >= result.points[list[k - 1]].seconds.minimum);
  }
  CHECK(accurate_enough(result, 1e-9, 2).empty());
  result.floor = 1e-5;  // the reference can't vouch for less
  CHECK(accurate_enough(result, 1e-5, 2).empty());
}

TEST_CASE("settings cheap enough stay in the budget, and the most accurate comes first", "[cost]") {
  const Result result = two_curves();
  const auto list = cheap_enough(result, 0.9e-3);
  REQUIRE(!list.empty());
  CHECK(result.points[list.front()].error == 1e-7);  // 10 us * 1e7^(1/4) = 562 us
  for (const std::size_t i : list) CHECK(result.points[i].seconds.median <= 0.9e-3);
  CHECK(cheap_enough(result, 1e-9).empty());
}
