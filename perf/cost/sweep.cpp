#include "perf/cost/sweep.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

#include "perf/cost/contacts.h"
#include "perf/timing.h"

namespace ballpark::cost {

namespace {

using perf::seconds_now;

/// A curve that gained less than this over two points has met its rounding.
constexpr double gain = 0.8;
/// Points that gain nothing are kept: one shows where rounding begins.
constexpr int idle_points = 1;
/// And before a curve is given up that solves other equations than the scene, whose difference it has met.
constexpr int most_idle = 3;
/// Of each setting, before it is timed: one is looked at, one is not.
constexpr double runs_to_check = 3;
/// Curves that a sentence names.
constexpr std::size_t most_named = 5;

class Walk {
 public:
  Walk(const Ground& ground, Result& result, const GoOn& go_on) : ground_(ground), result_(result), go_on_(go_on) {}

  /// From coarse to fine within so many seconds of run time. False: stopped.
  bool along(const Candidate& candidate, double seconds) {
    Curve curve = candidate.curve;
    double best = std::numeric_limits<double>::infinity(), last = 0, before = 0;
    int idle = 0;
    spent_ = 0;
    why_it_ended_.clear();
    for (const Setting& setting : candidate.settings) {
      const double growth = before > 0 ? std::clamp(last / before, 1.1, 4.0) : 2.5;
      if (spent_ + last * growth > seconds) {
        why_it_ended_ = fmt::format("{} of {}", pace(&setting), curve.label);
        break;
      }
      const double begin = seconds_now(), deadline = begin + 4 * seconds + 0.5;
      Point point = measured_point(ground_, setting, [&] { return go_on_() && seconds_now() < deadline; });
      if (!go_on_()) return false;
      before = std::exchange(last, point.seconds.minimum);
      spent_ += std::max(last, (seconds_now() - begin) / runs_to_check);
      point.curve = result_.curves.size();
      const bool counts = point.trouble.empty();
      const double error = point.error;
      curve.points.push_back(result_.points.size());
      result_.points.push_back(std::move(point));
      if (!counts && last == 0) break;  // finer ones take longer still
      if (counts && error < ground_.about.floor) break;
      if (counts) idle = error < gain * best ? 0 : idle + 1;
      if (counts) best = std::min(best, error);
      if (best < small_ && idle > idle_points) break;
      if (idle > most_idle && (setting.opening_angle > 0 || !same_equations(ground_.scene, setting.contact))) break;
    }
    result_.curves.push_back(std::move(curve));
    return true;
  }

  double spent() const { return spent_; }
  const std::string& why_it_ended() const { return why_it_ended_; }

 private:
  static std::string pace(const Setting* next) {
    const Setting& finest = *(next - 1);
    return finest.tolerance > 0 ? fmt::format("{:.3g}", finest.tolerance) : fmt::format("{:.3g} s", finest.step);
  }

  const Ground& ground_;
  Result& result_;
  const GoOn& go_on_;
  /// Errors larger than this are no rounding, though they may not fall yet.
  const double small_ = 1e-3 * ground_.reference.about.scale[static_cast<std::size_t>(ground_.measure.quantity)];
  double spent_ = 0;
  std::string why_it_ended_;
};

/// What was tried and does not count, a sentence for each kind of trouble.
void add_troubles(Result& result) {
  constexpr const char* kinds[] = {"stability", "as large as the path", "takes too long", ""};
  std::array<std::size_t, std::size(kinds)> counts{};
  std::array<const Point*, std::size(kinds)> first{};
  for (const Point& point : result.points) {
    if (point.trouble.empty()) continue;
    std::size_t kind = 0;
    while (point.trouble.find(kinds[kind]) == std::string::npos) ++kind;
    if (counts[kind]++ == 0) first[kind] = &point;
  }
  for (std::size_t kind = 0; kind < std::size(kinds); ++kind) {
    if (counts[kind] == 0) continue;
    result.left_out.push_back(fmt::format("{} setting{}; the first: {}: {}", counts[kind], counts[kind] == 1 ? "" : "s",
                                          text(first[kind]->setting), first[kind]->trouble));
  }
}

}  // namespace

namespace {

/// nullptr, and why, if the world cannot be built: some limits of steps are known only then.
std::unique_ptr<Subject> subject_of(const Ground& ground, const Setting& setting, std::string& why) {
  try {
    return std::make_unique<Subject>(ground.scene, setting, ground.options);
  } catch (const SceneError& error) {
    why = error.problems().front().message;
    return nullptr;
  }
}

}  // namespace

Point measured_point(const Ground& ground, const Setting& setting, const GoOn& go_on) {
  Point point;
  point.setting = setting;
  const std::unique_ptr<Subject> made = subject_of(ground, setting, point.trouble);
  if (!made) return point;
  Subject& subject = *made;
  Track track(ground.samples);
  if (!subject.follow(ground.samples, track, go_on)) {
    point.trouble = "takes too long";
    return point;
  }
  point.trouble = subject.trouble();
  const bool everywhere = std::all_of(track.known.begin(), track.known.end(), [](char known) { return known; });
  if (point.trouble.empty() && !everywhere) point.trouble = "its steps do not meet the times that are looked at";
  const std::uint64_t looked_at = subject.world().state_hash();
  if (!subject.find_events(ground.samples, track, go_on)) {
    point.trouble = "takes too long";
    return point;
  }
  const std::uint64_t watched = subject.world().state_hash();
  point.errors = errors_of(track, ground.reference.track, subject.start());
  point.seconds = {subject.run(), 0, 0, 1};
  const Counters counters = subject.world().counters();
  point.steps = counters.steps;
  point.rejected_steps = counters.rejected_steps;
  point.force_evaluations = counters.force_evaluations;
  point.state_hash = fmt::format("{:016x}", subject.world().state_hash());
  const std::uint64_t timed = subject.world().state_hash();
  if (point.trouble.empty() && (looked_at != timed || watched != timed)) {
    point.trouble = "the run ended in other bits than the one looked at";
  }
  point.error = ground.error_of(point.errors);
  point.claimed = point.error >= ground.about.floor;
  const double scale = ground.about.reference.scale[static_cast<std::size_t>(ground.measure.quantity)];
  if (point.trouble.empty() && !(point.error <= std::max(scale, ground.about.floor))) {
    point.trouble = "it ends nowhere: its error is as large as the path";
  }
  return point;
}

bool sweep(const Ground& ground, const std::vector<Candidate>& list, const SweepTime& time, Result& result,
           const std::function<bool(double)>& go_on) {
  double fraction = 0;
  const GoOn asked = [&] { return go_on(fraction); };
  Walk walk(ground, result, asked);
  const double end = seconds_now() + time.seconds;
  // Each run is checked twice and timed `rounds` times.
  const double runs = time.rounds + 3;
  double left = time.seconds / runs;
  std::size_t skipped = 0;
  std::string ended;
  std::size_t unfinished = 0;
  for (std::size_t i = 0; i < list.size(); ++i) {
    fraction = static_cast<double>(i) / static_cast<double>(list.size());
    const double share = 2 * left / static_cast<double>(list.size() - i + 1);
    if (seconds_now() > end || left <= 0) {
      ++skipped;
      continue;
    }
    if (!walk.along(list[i], share)) return false;
    left -= walk.spent();
    if (!walk.why_it_ended().empty() && ++unfinished <= most_named) {
      ended += (ended.empty() ? "" : ", ") + walk.why_it_ended();
    }
  }
  if (unfinished > most_named) ended += fmt::format(" and {} more", unfinished - most_named);
  if (unfinished > 0) {
    result.left_out.push_back("finer steps and tolerances, for want of time (more: --seconds): below " + ended);
  }
  add_troubles(result);
  if (skipped > 0) result.left_out.push_back(fmt::format("{} more curves: there was no time for them", skipped));
  return true;
}

}  // namespace ballpark::cost
