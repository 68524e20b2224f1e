#include "perf/cost/cost.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "perf/cost/choice.h"
#include "perf/cost/contacts.h"
#include "perf/cost/ensemble.h"
#include "perf/timing.h"

namespace ballpark::cost {

namespace {

using perf::seconds_now;

constexpr double reference_share = 0.25, timing_share = 0.55;  ///< of the time
constexpr int many_rounds = 9, few_rounds = 3;
constexpr double long_run = 0.02;  ///< of the coarsest setting [s]

/// The whole of a request, step by step.
class Study {
 public:
  Study(const Ground& ground, const Request& request, const Progress& progress, double begin)
      : ground_(ground), request_(request), progress_(progress), begin_(begin), result_(ground.about) {
    if (ground.goes_beyond_horizon()) seconds_ *= 1 - share_of_ensembles();
  }

  std::optional<Result> result() {
    if (!run_sweep() || !time_all()) return std::nullopt;
    if (!recommend()) return std::nullopt;
    mark_front(result_);
    result_.crossovers = crossovers(result_);
    const std::string lecture = comparison(result_, "rk4", "euler");
    if (!lecture.empty()) result_.crossovers.push_back(lecture);
    for (const std::string& nearest : formulations(result_)) result_.crossovers.push_back(nearest);
    add_paths(ground_, result_, [&] { return on("confirming", 1); });
    if (!look_beyond_horizon()) return std::nullopt;
    return std::move(result_);
  }

 private:
  bool on(const char* what, double fraction) { return progress_(what, fraction); }
  double taken() const { return seconds_now() - begin_; }

  bool run_sweep() {
    Axes axes = request_.axes;
    axes.contacts = contacts_to_try(ground_, axes.contacts, result_);
    if (axes.contacts.empty()) return true;
    std::vector<Candidate> list = candidates(ground_.scene, axes, ground_.samples.times.size(), result_.left_out);
    if (list.empty()) return true;
    add_own(list);
    const Point probe = measured_point(ground_, list.front().settings.front(), [&] { return on("sweep", 0); });
    if (probe.seconds.minimum > long_run) rounds_ = few_rounds;
    const double left = (1 - reference_share / 2) * seconds_ - taken();
    return sweep(ground_, list, {left, rounds_}, result_, [&](double fraction) { return on("sweep", fraction); });
  }

  /// The scene as it is, if it is one of the settings that can be compared.
  void add_own(std::vector<Candidate>& list) const {
    const Setting setting = *result_.scene_setting;
    const Axes& axes = request_.axes;
    if (!axes.integrators.empty() || !axes.steps.empty() || !axes.tolerances.empty()) return;
    if (setting.precision == Precision::extended) return;
    const std::uint64_t steps = steps_in(ground_.scene.run.duration, setting.step);
    if (setting.tolerance == 0 && (steps == 0 || steps % ground_.samples.times.size() != 0)) return;
    for (Candidate& candidate : list) {
      const Setting& first = candidate.settings.front();
      if (!same_curve(first, setting)) continue;
      const auto finer = [](const Setting& a, const Setting& b) {
        return a.step != b.step ? a.step > b.step : a.tolerance > b.tolerance;
      };
      const auto place = std::lower_bound(candidate.settings.begin(), candidate.settings.end(), setting, finer);
      const bool there = place != candidate.settings.end() &&
                         std::abs(place->step - setting.step) <= 1e-9 * setting.step &&
                         std::abs(place->tolerance - setting.tolerance) <= 1e-9 * setting.tolerance;
      if (!there) candidate.settings.insert(place, setting);
      return;
    }
  }

  bool time_all() {
    std::vector<std::size_t> all;
    for (std::size_t i = 0; i < result_.points.size(); ++i) all.push_back(i);
    const double left = std::min(timing_share * seconds_, 0.92 * seconds_ - taken());
    return time_points(ground_, all, {std::max(0.0, left), rounds_}, result_,
                       [&](double fraction) { return on("timing", fraction); });
  }

  /// The fastest settings are timed once more beside each other; what is named proves itself in a run of its own.
  bool recommend() {
    if (!request_.tolerance && !request_.budget) return true;
    const std::size_t swept = result_.points.size();
    if (request_.tolerance && !(refine_near(limit()) && time_again(swept))) return false;
    const std::vector<std::size_t> list = ranked();
    if (!list.empty()) name(list.front());
    return true;
  }

  /// The error asked for, or the seconds that a run may take.
  double limit() const {
    return request_.tolerance ? *request_.tolerance : *request_.budget * ground_.scene.run.duration;
  }
  std::vector<std::size_t> ranked() const {
    return request_.tolerance ? accurate_enough(result_, limit(), request_.margin) : cheap_enough(result_, limit());
  }

  bool refine_near(double tolerance) {
    for (int i = 0; i < 2; ++i) {
      if (!refine(ground_, tolerance / request_.margin, result_, [&] { return on("confirming", 0); })) return false;
    }
    return true;
  }

  /// Those about as fast as the fastest, and the new ones since the sweep: timed in turns like the others.
  bool time_again(std::size_t swept) {
    std::vector<std::size_t> list = ranked();
    if (list.empty()) return true;
    const double near = 2 * result_.points[list.front()].seconds.minimum;
    std::erase_if(list, [&](std::size_t i) { return result_.points[i].seconds.minimum > near; });
    for (std::size_t i = swept; i < result_.points.size(); ++i) {
      if (std::find(list.begin(), list.end(), i) == list.end()) list.push_back(i);
    }
    return time_points(ground_, list, {0, rounds_for(list)}, result_, [&](double f) { return on("confirming", f); });
  }

  void name(std::size_t index) {
    const Point& best = result_.points[index];
    const Point again = measured_point(ground_, best.setting, [&] { return on("confirming", 1); });
    Recommendation named{index, request_.tolerance ? *request_.tolerance : *request_.budget,
                         request_.tolerance ? request_.margin : 1, again.error, ""};
    const double each = best.seconds.minimum / ground_.scene.run.duration;
    const auto told = [&](double error) {
      return fmt::format("{}{:.2g} {}", error < result_.floor ? "below " : "", std::max(error, result_.floor),
                         result_.measure_unit);
    };
    named.sentence =
        fmt::format("{}: error {} in {}, or {} a simulated second; a fresh run confirms {}", text(best.setting),
                    told(best.error), time_text(best.seconds.minimum), time_text(each), told(again.error));
    result_.recommended = named;
  }

  double share_of_ensembles() const { return request_.copies ? asked_share : unasked_share; }

  bool look_beyond_horizon() {
    EnsembleRequest request{request_.copies.value_or(fewest_copies), request_.perturb.value_or(0),
                            share_of_ensembles() * request_.seconds, request_.copies.has_value()};
    return add_ensemble(ground_, request, result_, [&](double fraction) { return on("ensembles", fraction); });
  }

  /// As many as a tenth of the time has room for.
  int rounds_for(const std::vector<std::size_t>& list) const {
    double each = 0;
    for (const std::size_t i : list) each += std::max(1e-4, result_.points[i].seconds.minimum);
    return std::clamp(static_cast<int>(0.1 * request_.seconds / each), few_rounds, 5 * many_rounds);
  }

  const Ground& ground_;
  const Request& request_;
  const Progress& progress_;
  double begin_;
  double seconds_ = request_.seconds;  ///< for all inside the horizon
  Result result_;
  int rounds_ = many_rounds;
};

}  // namespace

std::optional<Result> cost(const Scene& scene, const Request& request, const Progress& progress) {
  const double begin = seconds_now();
  const GroundRequest wanted{request.measure,    request.reference, reference_share * request.seconds,
                             request.axes.steps, request.options,   request.events};
  const GoOn go_on = [&] { return progress("reference", std::min(1.0, (seconds_now() - begin) / wanted.seconds)); };
  const std::optional<Ground> ground = ground_for(scene, wanted, go_on);
  if (!ground) return std::nullopt;
  return Study(*ground, request, progress, begin).result();
}

}  // namespace ballpark::cost
