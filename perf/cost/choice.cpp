#include "perf/cost/choice.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "perf/cost/subject.h"

namespace ballpark::cost {

namespace {

/// Points that no other of the list is as accurate and as fast as, from inaccurate to accurate.
std::vector<std::size_t> front_of(const Result& result, std::vector<std::size_t> list) {
  std::erase_if(list,
                [&](std::size_t i) { return !counts(result.points[i]) || result.points[i].error > result.ceiling; });
  std::sort(list.begin(), list.end(), [&](std::size_t a, std::size_t b) {
    const Point &p = result.points[a], &q = result.points[b];
    return p.seconds.minimum != q.seconds.minimum ? p.seconds.minimum < q.seconds.minimum : p.error < q.error;
  });
  std::vector<std::size_t> front;
  for (const std::size_t i : list) {
    if (front.empty() || result.points[i].error < result.points[front.back()].error) front.push_back(i);
    if (result.points[i].error <= result.floor) break;  // what is more accurate can't be told
  }
  return front;
}

/// The wall time at which a curve's front meets an error: between its points logarithmically, of its coarsest one where
/// that is more accurate; nullopt where it does not come so far.
std::optional<double> seconds_on(const Result& result, const std::vector<std::size_t>& front, double error) {
  for (std::size_t k = 0; k < front.size(); ++k) {
    const Point& fine = result.points[front[k]];
    if (fine.error > error) continue;
    if (fine.error == error || k == 0) return fine.seconds.minimum;
    const Point& coarse = result.points[front[k - 1]];
    if (fine.error == 0) return fine.seconds.minimum;
    const double share = std::log(coarse.error / error) / std::log(coarse.error / fine.error);
    return coarse.seconds.minimum * std::pow(fine.seconds.minimum / coarse.seconds.minimum, share);
  }
  return std::nullopt;
}

/// A curve by its own front.
struct Ladder {
  const Curve* curve;
  std::vector<std::size_t> front;
  double least_error(const Result& result) const { return std::max(result.floor, result.points[front.back()].error); }
};

std::vector<Ladder> ladders_of(const Result& result) {
  std::vector<Ladder> list;
  for (const Curve& curve : result.curves) {
    Ladder ladder{&curve, front_of(result, curve.points)};
    if (!ladder.front.empty()) list.push_back(std::move(ladder));
  }
  return list;
}

/// A curve takes over from another when it is cheaper by this: less is no difference that one would act on.
constexpr double worth_it = 1.25;
constexpr double errors_per_decade = 20;

/// Where `after` is cheaper than `before` from this error down, by the most and where that is.
std::string takeover(const Result& result, const Ladder& before, const Ladder& after, double error) {
  const double low = std::max(before.least_error(result), after.least_error(result));
  double most = 0, where = 0;
  for (double at = error; at >= low && at > 0; at *= std::pow(10.0, -1 / errors_per_decade)) {
    const auto slow = seconds_on(result, before.front, at), fast = seconds_on(result, after.front, at);
    if (!slow || !fast || *slow / *fast <= most) continue;
    most = *slow / *fast;
    where = at;
  }
  const std::string start = fmt::format("below {:.0e} {} {}", error, result.measure_unit, after.curve->label);
  if (most <= 1) return fmt::format("{} takes over: {} does not come so far", start, before.curve->label);
  return fmt::format("{} is cheaper than {}, by up to {:.1f} times, at {:.0e} {}", start, before.curve->label, most,
                     where, result.measure_unit);
}

}  // namespace

bool counts(const Point& point) {
  return point.trouble.empty() && point.seconds.minimum > 0 && std::isfinite(point.error);
}

std::vector<std::size_t> mark_front(Result& result) {
  std::vector<std::size_t> all(result.points.size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    all[i] = i;
    result.points[i].front = false;
  }
  std::vector<std::size_t> front = front_of(result, std::move(all));
  for (const std::size_t i : front) result.points[i].front = true;
  return front;
}

std::vector<std::string> crossovers(const Result& result) {
  std::vector<std::string> list;
  const std::vector<Ladder> ladders = ladders_of(result);
  const Ladder* best = nullptr;
  const double factor = std::pow(10.0, -1 / errors_per_decade);
  const double least = std::max(result.floor, 1e-300);
  for (double error = result.ceiling; error >= least; error *= factor) {
    const Ladder* cheapest = nullptr;
    double lowest = 0, now = 0;
    for (const Ladder& ladder : ladders) {
      const auto seconds = seconds_on(result, ladder.front, error);
      if (!seconds) continue;
      if (&ladder == best) now = *seconds;
      if (cheapest && *seconds >= lowest) continue;
      cheapest = &ladder;
      lowest = *seconds;
    }
    if (!cheapest || cheapest == best || (now > 0 && now < worth_it * lowest)) continue;
    if (best) list.push_back(takeover(result, *best, *cheapest, error));
    best = cheapest;
  }
  return list;
}

std::string comparison(const Result& result, const std::string& cheap, const std::string& dear) {
  const Ladder *a = nullptr, *b = nullptr;
  const std::vector<Ladder> ladders = ladders_of(result);
  for (const Ladder& ladder : ladders) {
    if (ladder.curve->label == cheap) a = &ladder;
    if (ladder.curve->label == dear) b = &ladder;
  }
  if (!a || !b) return "";
  const double low = std::max(a->least_error(result), b->least_error(result));
  const auto fast = seconds_on(result, a->front, low), slow = seconds_on(result, b->front, low);
  if (!fast || !slow) return "";
  return fmt::format("at {:.0e} {} {} takes {:.3g} times as long as {}", low, result.measure_unit, dear, *slow / *fast,
                     cheap);
}

std::vector<std::string> formulations(const Result& result) {
  std::map<std::string, const Point*> nearest;
  for (const Point& point : result.points) {
    if (!counts(point) || point.setting.contact.kind.empty()) continue;
    const Point*& best = nearest[point.setting.contact.kind];
    if (!best || point.error < best->error) best = &point;
  }
  std::vector<std::string> list;
  for (const auto& [kind, point] : nearest) {
    if (nearest.size() == 1) break;
    list.push_back(fmt::format("{} contacts come as near as {:.1e} {}: {}, in {}", kind,
                               std::max(point->error, result.floor), result.measure_unit, text(point->setting),
                               time_text(point->seconds.minimum)));
  }
  return list;
}

std::vector<std::size_t> accurate_enough(const Result& result, double tolerance, double margin) {
  std::vector<std::size_t> list;
  for (std::size_t i = 0; i < result.points.size(); ++i) {
    const Point& point = result.points[i];
    if (counts(point) && std::max(point.error, result.floor) * margin <= tolerance) list.push_back(i);
  }
  std::sort(list.begin(), list.end(), [&](std::size_t a, std::size_t b) {
    return result.points[a].seconds.minimum < result.points[b].seconds.minimum;
  });
  return list;
}

std::vector<std::size_t> cheap_enough(const Result& result, double seconds) {
  std::vector<std::size_t> list;
  for (std::size_t i = 0; i < result.points.size(); ++i) {
    if (counts(result.points[i]) && result.points[i].seconds.median <= seconds) list.push_back(i);
  }
  std::sort(list.begin(), list.end(), [&](std::size_t a, std::size_t b) {
    const Point &p = result.points[a], &q = result.points[b];
    const double e = std::max(p.error, result.floor), f = std::max(q.error, result.floor);
    return e != f ? e < f : p.seconds.minimum < q.seconds.minimum;
  });
  return list;
}

}  // namespace ballpark::cost
