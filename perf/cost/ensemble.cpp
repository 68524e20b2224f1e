#include "perf/cost/ensemble.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "ballpark/catalogue.h"
#include "perf/cost/choice.h"
#include "perf/timing.h"

namespace ballpark::cost {

namespace {

using perf::seconds_now;

constexpr double for_reference = 0.4;         ///< of the time, at most
constexpr double patience = 2, moment = 0.5;  ///< times what was expected, and a moment [s], before a run is stopped
constexpr double rounding = 1e-12;            ///< relative: means that differ by less do not differ

bool same(const Setting& a, const Setting& b) {
  const auto near = [](double x, double y) { return std::abs(x - y) <= 1e-9 * std::abs(x); };
  return same_curve(a, b) && near(a.step, b.step) && near(a.tolerance, b.tolerance);
}

/// Steps of the finest of two runs so many times longer err by less than is claimed, which is ten times their
/// difference: longer^p e <= 10 (2^p - 1) e at order p.
double within_floor(const std::string& integrator) {
  const auto row = std::find_if(integrators().begin(), integrators().end(),
                                [&](const IntegratorDescription& each) { return each.name == integrator; });
  return std::pow(10 * (std::pow(2, row->order) - 1), 1.0 / row->order);
}

/// Means that differ by less differ by rounding.
double least_difference(const Ensemble& ensemble, std::size_t o) {
  return rounding * (ensemble.observables[o].unit.empty() ? 1 : std::abs(ensemble.reference.means[o].value));
}

/// What is the same in all runs tells nothing.
bool tells(const Ensemble& ensemble, std::size_t o) {
  const double least = least_difference(ensemble, o), like = ensemble.reference.means[o].value;
  const auto differs = [&](const EnsembleRuns& runs) {
    return runs.means[o].error > least || std::abs(runs.means[o].value - like) > least;
  };
  return differs(ensemble.reference) || std::any_of(ensemble.settings.begin(), ensemble.settings.end(), differs);
}

template <class T>
void keep(std::vector<T>& list, const std::vector<std::size_t>& which) {
  std::vector<T> kept;
  for (const std::size_t i : which) kept.push_back(std::move(list[i]));
  list = std::move(kept);
}

/// With the reference, in all that tells something.
void compare(Ensemble& ensemble) {
  std::vector<std::size_t> telling;
  for (std::size_t o = 0; o < ensemble.observables.size(); ++o) {
    if (tells(ensemble, o)) telling.push_back(o);
  }
  keep(ensemble.observables, telling);
  keep(ensemble.reference.means, telling);
  for (EnsembleRuns& runs : ensemble.settings) {
    keep(runs.means, telling);
    for (std::size_t o = 0; o < telling.size(); ++o) {
      const Difference difference = difference_of(runs.means[o], ensemble.reference.means[o]);
      const bool rounded = std::abs(difference.value) <= least_difference(ensemble, o);
      runs.from_reference.push_back(rounded ? Difference{} : difference);
    }
  }
}

/// A setting whose ensemble is to be run.
struct Choice {
  Setting setting;
  double seconds = 0;  ///< that all copies should take; 0: unknown
  std::string why;
};

class Ensembles {
 public:
  Ensembles(const Ground& ground, const EnsembleRequest& request, Result& result,
            const std::function<bool(double)>& go_on)
      : ground_(ground), request_(request), result_(result), go_on_(go_on), scene_(ground.scene) {
    scene_.run.duration = ground.whole;
    if (request_.perturb == 0) request_.perturb = 1 / ground.about.horizon->growth;
  }

  /// False: stopped.
  bool run() {
    if (!run_reference()) return false;
    result_.horizon->sentence += result_.ensemble
                                     ? fmt::format(" Beyond that, statistics of {} runs are.", request_.copies)
                                     : " Beyond that, nothing is.";
    if (result_.ensemble && !run_settings()) return false;
    if (!failed_.empty()) {
      result_.left_out.push_back(fmt::format("the ensemble{} of {} setting{}; the first: {}",
                                             failed_.size() == 1 ? "" : "s", failed_.size(),
                                             failed_.size() == 1 ? "" : "s", first_failure_));
    }
    return true;
  }

 private:
  double end() const { return begin_ + request_.seconds; }
  bool asked() const { return go_on_(std::min(1.0, (seconds_now() - begin_) / request_.seconds)); }
  /// Of all copies to the end, from that of one run to the horizon.
  double stretched(double seconds) const {
    return seconds * request_.copies * ground_.whole / ground_.scene.run.duration;
  }

  bool run_settings() {
    std::string skipped;
    for (const Choice& choice : settings()) {
      const auto runs = seconds_now() + choice.seconds < end() ? runs_of(choice) : std::nullopt;
      if (!asked()) return false;
      if (runs && !runs->means.empty()) result_.ensemble->settings.push_back(*runs);
      if (!runs) skipped += (skipped.empty() ? "" : "; ") + text(choice.setting);
    }
    if (!skipped.empty()) {
      result_.left_out.push_back("ensembles of more settings, for want of time (more: --seconds): " + skipped);
    }
    compare(*result_.ensemble);
    return true;
  }

  /// nullopt: stopped, or it took too long. No means: it failed.
  std::optional<EnsembleRuns> runs_of(const Choice& choice) {
    const double begin = seconds_now(), most = choice.seconds > 0 ? patience * choice.seconds + moment : end() - begin;
    const double latest = std::min(begin + most, begin_ + patience * request_.seconds);
    const auto copies = run_copies(scene_, choice.setting, request_, ground_.options,
                                   [&] { return asked() && seconds_now() < latest; });
    if (!copies) return std::nullopt;
    EnsembleRuns runs{choice.setting, (seconds_now() - begin) / request_.copies};
    if (!copies->trouble.empty()) {
      if (failed_.empty()) first_failure_ = text(choice.setting) + ", " + copies->trouble;
      failed_.push_back(choice.setting);
      return runs;
    }
    for (const std::vector<double>& values : copies->values) runs.means.push_back(mean_of(values));
    return runs;
  }

  /// Those that count inside the horizon, as sorted.
  template <class Before>
  std::vector<const Point*> points(bool on_front, const Before& before) const {
    std::vector<const Point*> list;
    for (const Point& point : result_.points) {
      if (counts(point) && point.error <= result_.ceiling && (point.front || !on_front)) list.push_back(&point);
    }
    std::sort(list.begin(), list.end(), before);
    return list;
  }

  /// The best first; those that are far from it can't judge others.
  std::vector<Choice> references() const {
    std::vector<Choice> list;
    const Reference& own = result_.reference;
    for (double longer = 1; own.setting && longer <= within_floor(own.setting->integrator); longer *= 2) {
      Choice choice{*own.setting, stretched(own.seconds) / longer, "the reference inside the horizon"};
      choice.setting.step *= longer;
      if (longer == 1 || steps_in(scene_.run.duration, choice.setting.step) > 0) list.push_back(choice);
    }
    const auto accurate = points(false, [](auto* a, auto* b) { return a->error < b->error; });
    const double enough = accurate.empty() ? 0 : std::max(result_.floor, 10 * accurate.front()->error);
    for (const Point* point : accurate) {
      if (point->error > enough) break;
      list.push_back({point->setting, stretched(point->seconds.minimum), "the most accurate inside the horizon"});
    }
    return list;
  }

  bool run_reference() {
    const std::vector<Choice> list = references();
    double least = 0;
    for (const Choice& choice : list) {
      if (least == 0 || choice.seconds < least) least = choice.seconds;
      if (choice.seconds > for_reference * request_.seconds) continue;
      const auto runs = runs_of(choice);
      if (!asked()) return false;
      if (!runs || runs->means.empty()) continue;
      const bool best = &choice == &list.front();
      result_.ensemble = Ensemble{request_.copies,
                                  request_.perturb,
                                  ground_.whole,
                                  observables(),
                                  *runs,
                                  choice.why + (best ? "" : ", as fine as there was time for"),
                                  {}};
      return true;
    }
    std::string why = "statistics beyond the horizon: no setting counts that could be their reference";
    if (least > for_reference * request_.seconds) {
      why = fmt::format("statistics beyond the horizon: {} runs take {} at least (--copies {} --seconds {:.0f})",
                        request_.copies, time_text(least), request_.copies,
                        10 * std::ceil(1.2 * least / for_reference / asked_share / 10));
    }
    result_.left_out.push_back(why);
    return true;
  }

  /// The scene's own, then the front, the faster first.
  std::vector<Choice> settings() const {
    std::vector<Choice> list;
    const Setting& own = *result_.scene_setting;
    const bool runs = own.tolerance > 0 || steps_in(scene_.run.duration, own.step) > 0;
    if (runs && own.precision != Precision::extended) list.push_back({own, stretched(seconds_of(own)), ""});
    for (const Point* point : points(true, [](auto*a, auto*b) { return a->seconds.minimum < b->seconds.minimum; })) {
      if (!same(point->setting, own)) list.push_back({point->setting, stretched(point->seconds.minimum), ""});
    }
    std::vector<Setting> done = failed_;
    done.push_back(result_.ensemble->reference.setting);
    std::erase_if(list, [&](const Choice& choice) {
      return std::any_of(done.begin(), done.end(), [&](auto& setting) { return same(setting, choice.setting); });
    });
    return list;
  }

  /// As measured, or from another step; 0: unknown.
  double seconds_of(const Setting& setting) const {
    double seconds = 0;
    for (const Point& point : result_.points) {
      Setting paced = point.setting;
      paced.step = setting.step;
      if (counts(point) && setting.step > 0 && same(paced, setting)) {
        seconds = point.seconds.minimum * point.setting.step / setting.step;
      }
      if (counts(point) && same(point.setting, setting)) return point.seconds.minimum;
    }
    return seconds;
  }

  const Ground& ground_;
  EnsembleRequest request_;
  Result& result_;
  const std::function<bool(double)>& go_on_;
  const double begin_ = seconds_now();
  Scene scene_;
  std::vector<Setting> failed_;
  std::string first_failure_;
};

}  // namespace

bool add_ensemble(const Ground& ground, const EnsembleRequest& request, Result& result,
                  const std::function<bool(double)>& go_on) {
  if (ground.goes_beyond_horizon()) return Ensembles(ground, request, result, go_on).run();
  if (request.asked) {
    result.left_out.push_back(
        "statistics of ensembles (--copies): paths stay together to the end, and their errors say more");
  }
  return true;
}

}  // namespace ballpark::cost
