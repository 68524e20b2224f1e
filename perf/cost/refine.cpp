// Between the steps of a sweep: settings that just meet a tolerance.
#include <algorithm>
#include <cmath>

#include "perf/cost/choice.h"
#include "perf/cost/cost.h"

namespace ballpark::cost {

namespace {

constexpr double safely = 0.8;      ///< of the error aimed at
constexpr double promising = 1.15;  ///< curves that may come so near to the fastest
constexpr std::size_t most_curves = 8;

/// A setting between two of a curve, which should have the error `target`.
struct Guess {
  std::size_t curve, behind;  ///< the point of the curve that it follows
  Setting setting;
  double seconds;
};

/// Paces change by powers, errors with them.
double between(double coarse, double fine, double share) {
  return coarse * std::pow(fine / coarse, share);
}

std::optional<Guess> guess_for(const Ground& ground, const Result& result, std::size_t c, double target) {
  const std::vector<std::size_t>& points = result.curves[c].points;
  for (std::size_t k = 1; k < points.size(); ++k) {
    const Point &coarse = result.points[points[k - 1]], &fine = result.points[points[k]];
    if (!counts(coarse) || !counts(fine) || coarse.error <= target || fine.error > target) continue;
    const double share =
        std::log(coarse.error / (safely * target)) / std::log(coarse.error / std::max(fine.error, 1e-300));
    if (!(share > 0 && share < 1)) return std::nullopt;
    Guess guess{c, k, fine.setting, between(coarse.seconds.minimum, fine.seconds.minimum, share)};
    if (fine.setting.tolerance > 0) {
      guess.setting.tolerance = between(coarse.setting.tolerance, fine.setting.tolerance, share);
      const double digits = std::pow(10, std::floor(std::log10(guess.setting.tolerance)) - 1);
      guess.setting.tolerance = digits * std::floor(guess.setting.tolerance / digits);
    } else {
      const double looks = static_cast<double>(ground.samples.times.size());  // whole steps between them
      const double steps = ground.scene.run.duration / between(coarse.setting.step, fine.setting.step, share);
      guess.setting.step = ground.scene.run.duration / (looks * std::ceil(steps / looks));
    }
    const bool new_pace =
        guess.setting.tolerance > fine.setting.tolerance * 1.02 || guess.setting.step > fine.setting.step * 1.02;
    return new_pace ? std::optional(guess) : std::nullopt;
  }
  return std::nullopt;
}

}  // namespace

bool refine(const Ground& ground, double target, Result& result, const GoOn& go_on) {
  const std::vector<std::size_t> enough = accurate_enough(result, target, 1);
  const double best = enough.empty() ? 1e300 : result.points[enough.front()].seconds.minimum;
  std::vector<Guess> guesses;
  for (std::size_t c = 0; c < result.curves.size(); ++c) {
    const std::optional<Guess> guess = guess_for(ground, result, c, target);
    if (guess && guess->seconds < promising * best) guesses.push_back(*guess);
  }
  std::sort(guesses.begin(), guesses.end(), [](auto& a, auto& b) { return a.seconds < b.seconds; });
  if (guesses.size() > most_curves) guesses.resize(most_curves);
  for (const Guess& guess : guesses) {
    if (!check(scene_with(ground.scene, guess.setting)).empty()) continue;
    Point point = measured_point(ground, guess.setting, go_on);
    if (!go_on()) return false;
    point.curve = guess.curve;
    std::vector<std::size_t>& points = result.curves[guess.curve].points;
    points.insert(points.begin() + static_cast<std::ptrdiff_t>(guess.behind), result.points.size());
    result.points.push_back(std::move(point));
  }
  return true;
}

}  // namespace ballpark::cost
