#include "perf/peers/orbits_curves.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ballpark::perf {

std::optional<double> Curve::time_at(double error, Time time) const {
  std::vector<Point> best = points;  // by time; each with less error than all before
  std::sort(best.begin(), best.end(), [&](const Point& a, const Point& b) { return a.*time < b.*time; });
  double least = std::numeric_limits<double>::infinity();
  std::erase_if(best, [&](const Point& p) {
    const bool worse = !(p.error < least);
    if (!worse) least = p.error;
    return worse;
  });
  for (std::size_t i = 1; i < best.size(); ++i) {
    const Point &a = best[i - 1], &b = best[i];
    if (error > a.error || error < b.error) continue;
    const double share = std::log(a.error / error) / std::log(a.error / b.error);
    return a.*time * std::pow(b.*time / a.*time, share);
  }
  return std::nullopt;
}

void time_curves(std::vector<Curve>& curves, const Effort& effort) {
  std::vector<Task> tasks;
  for (const Curve& curve : curves) {
    for (const Point& point : curve.points) tasks.push_back(point.solve);
  }
  const std::vector<Samples> samples = time_interleaved(tasks, effort);
  std::size_t i = 0;
  for (Curve& curve : curves) {
    for (Point& point : curve.points) {
      point.minimum = samples[i].minimum();
      point.median = samples[i++].median();
    }
  }
}

std::vector<EqualError> compare(const Curve& over, const Curve& under, const std::vector<double>& errors) {
  std::vector<EqualError> all;
  for (const double error : errors) {
    const auto ratio = [&](Curve::Time time) -> std::optional<double> {
      const auto a = over.time_at(error, time), b = under.time_at(error, time);
      return a && b ? std::optional(*a / *b) : std::nullopt;
    };
    const auto minima = ratio(&Point::minimum), medians = ratio(&Point::median);
    if (minima && medians) all.push_back({error, *minima, *medians});
  }
  return all;
}

EqualError mean(const std::vector<EqualError>& all) {
  EqualError sum{0, 0, 0};
  for (const EqualError& one : all) {
    sum.error += std::log(one.error);
    sum.of_minima += std::log(one.of_minima);
    sum.of_medians += std::log(one.of_medians);
  }
  const double n = static_cast<double>(all.size());
  return {std::exp(sum.error / n), std::exp(sum.of_minima / n), std::exp(sum.of_medians / n)};
}

}  // namespace ballpark::perf
