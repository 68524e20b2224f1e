#include "perf/cost/cost.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "perf/cost/choice.h"

namespace ballpark::cost {

namespace {

double seconds_now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

constexpr double reference_share = 0.25, timing_share = 0.55;  ///< of the time
constexpr int many_rounds = 9, few_rounds = 3;
constexpr double long_run = 0.02;  ///< of the coarsest setting [s]

/// The whole of a request, step by step.
class Study {
 public:
  Study(const Ground& ground, const Request& request, const Progress& progress, double begin)
      : ground_(ground), request_(request), progress_(progress), begin_(begin), result_(ground.about) {}

  std::optional<Result> result() {
    if (!run_sweep() || !time_all()) return std::nullopt;
    mark_front(result_);
    result_.crossovers = crossovers(result_);
    const std::string lecture = comparison(result_, "rk4", "euler");
    if (!lecture.empty()) result_.crossovers.push_back(lecture);
    if (!recommend()) return std::nullopt;
    add_paths(ground_, result_, [&] { return on("confirming", 1); });
    return std::move(result_);
  }

 private:
  bool on(const char* what, double fraction) { return progress_(what, fraction); }
  double taken() const { return seconds_now() - begin_; }

  bool run_sweep() {
    std::vector<Candidate> list =
        candidates(ground_.scene, request_.axes, ground_.samples.times.size(), result_.left_out);
    if (list.empty()) return true;
    add_own(list);
    const Point probe = measured_point(ground_, list.front().settings.front(), [&] { return on("sweep", 0); });
    if (probe.seconds.minimum > long_run) rounds_ = few_rounds;
    const double left = (1 - reference_share / 2) * request_.seconds - taken();
    return sweep(ground_, list, {left, rounds_}, result_, [&](double fraction) { return on("sweep", fraction); });
  }

  /// The scene as it is, if it is one of the settings that can be compared.
  void add_own(std::vector<Candidate>& list) const {
    const Setting setting = *result_.scene_setting;
    if (!request_.axes.integrators.empty() || setting.precision == Precision::extended) return;
    if (setting.tolerance == 0 && steps_in(ground_.scene.run.duration, setting.step) == 0) return;
    for (Candidate& candidate : list) {
      const Setting& first = candidate.settings.front();
      const bool alike = first.integrator == setting.integrator && first.precision == setting.precision &&
                         (first.tolerance > 0) == (setting.tolerance > 0) && first.iterations == setting.iterations &&
                         first.substeps == setting.substeps;
      if (!alike) continue;
      const auto finer = [](const Setting& a, const Setting& b) {
        return a.step != b.step ? a.step > b.step : a.tolerance > b.tolerance;
      };
      const auto place = std::lower_bound(candidate.settings.begin(), candidate.settings.end(), setting, finer);
      const bool there =
          place != candidate.settings.end() && std::abs(place->step - setting.step) < 1e-9 * setting.step;
      if (!there) candidate.settings.insert(place, setting);
      return;
    }
  }

  bool time_all() {
    std::vector<std::size_t> all;
    for (std::size_t i = 0; i < result_.points.size(); ++i) all.push_back(i);
    const double left = std::min(timing_share * request_.seconds, 0.92 * request_.seconds - taken());
    return time_points(ground_, all, {std::max(0.0, left), rounds_}, result_,
                       [&](double fraction) { return on("timing", fraction); });
  }

  /// The fastest settings are timed once more beside each other; what is named proves itself in a run of its own.
  bool recommend() {
    if (!request_.tolerance && !request_.budget) return true;
    const double limit = request_.tolerance ? *request_.tolerance : *request_.budget * ground_.scene.run.duration;
    const auto ranked = [&] {
      return request_.tolerance ? accurate_enough(result_, limit, request_.margin) : cheap_enough(result_, limit);
    };
    for (int i = 0; request_.tolerance && i < 2; ++i) {
      if (!refine(ground_, limit / request_.margin, result_, [&] { return on("confirming", 0); })) return false;
    }
    std::vector<std::size_t> list = ranked();
    if (list.empty()) return true;
    if (request_.tolerance) {
      const double near = 2 * result_.points[list.front()].seconds.minimum;
      std::erase_if(list, [&](std::size_t i) { return result_.points[i].seconds.minimum > near; });
      if (!time_points(ground_, list, {0, 5 * many_rounds}, result_, [&](double f) { return on("confirming", f); })) {
        return false;
      }
      list = ranked();
      mark_front(result_);
    }
    const Point& best = result_.points[list.front()];
    const Point again = measured_point(ground_, best.setting, [&] { return on("confirming", 1); });
    Recommendation named{list.front(), request_.tolerance ? *request_.tolerance : *request_.budget,
                         request_.tolerance ? request_.margin : 1, again.error, ""};
    const double each = best.seconds.minimum / ground_.scene.run.duration;
    named.sentence = fmt::format(
        "{}: error {:.2g} {} in {:.3g} s, {:.3g} s a simulated second; a fresh run confirms "
        "{:.2g} {}",
        text(best.setting), best.error, result_.measure_unit, best.seconds.minimum, each, again.error,
        result_.measure_unit);
    result_.recommended = named;
    return true;
  }

  const Ground& ground_;
  const Request& request_;
  const Progress& progress_;
  double begin_;
  Result result_;
  int rounds_ = many_rounds;
};

}  // namespace

std::optional<Result> cost(const Scene& scene, const Request& request, const Progress& progress) {
  const double begin = seconds_now();
  const GroundRequest wanted{request.measure, request.reference, reference_share * request.seconds, request.options};
  const GoOn go_on = [&] { return progress("reference", std::min(1.0, (seconds_now() - begin) / wanted.seconds)); };
  const std::optional<Ground> ground = ground_for(scene, wanted, go_on);
  if (!ground) return std::nullopt;
  return Study(*ground, request, progress, begin).result();
}

}  // namespace ballpark::cost
