#include "perf/effects/ablation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "perf/effects/ensembles.h"
#include "perf/effects/gauge.h"
#include "perf/timing.h"

namespace ballpark::cost {

namespace {

using perf::seconds_now;

constexpr double reference_share = 0.25, timing_share = 0.45;  ///< of the time
constexpr int many_rounds = 9, few_rounds = 3;
constexpr double long_run = 0.02;      ///< [s]
constexpr double worth_losing = 0.01;  ///< of how far things go
constexpr double first_order = 2;      ///< the error of a step that, halved, changes a number by less than half of it

/// A run of the scene, or of it without an effect.
struct Seen {
  Track path, end;
  Totals start = {};
  std::vector<Observation> own = {};
  std::string state_hash = {};
  double seconds = 0;  ///< that it took
  double bytes = 0, flops = 0;
  std::string trouble = {};
};

/// The whole of a request, step by step.
class Study {
 public:
  Study(const Ground& ground, const scenes::SceneFile& file, const Request& request, const Progress& progress)
      : ground_(ground),
        file_(file),
        request_(request),
        progress_(progress),
        setting_(setting_of(ground.scene)),
        whole_(file),
        gauge_(ground.scene, ground.options),
        ablation_{.about = ground.about} {
    if (ground.goes_beyond_horizon()) file_.expectations.clear();  // they are about the end
  }

  std::optional<Ablation> result() {
    if (!run_full()) return std::nullopt;
    if (!ablation_.trouble.empty()) return std::move(ablation_);
    for (std::size_t i = 0; i < ground_.scene.effects.size(); ++i) scenes_.push_back(without_effect(ground_.scene, i));
    for (std::size_t i = 0; i < scenes_.size(); ++i) {
      if (!drop(i)) return std::nullopt;
    }
    if (!time_all() || !look_beyond_horizon()) return std::nullopt;
    judge(ablation_);
    return std::move(ablation_);
  }

 private:
  bool on(const char* what, double fraction) { return progress_(what, fraction); }

  /// nullopt if it was stopped.
  std::optional<Seen> seen(const Scene& scene, const Setting& setting, const Samples& samples) {
    const GoOn go_on = [&] { return on("sweep", fraction_); };
    Seen run{.path = Track(samples), .end = Track(gauge_.at_end())};
    try {
      Subject subject(scene, setting, ground_.options);
      if (!subject.follow(samples, run.path, go_on) || !subject.follow(gauge_.at_end(), run.end, go_on)) {
        return std::nullopt;
      }
      run.start = subject.start();
      run.seconds = subject.run();
      run.trouble = subject.trouble();
      if (run.trouble.empty() && !(run.path.known.back() && run.end.known.back()))
        run.trouble = "it does not get there";
      run.state_hash = fmt::format("{:016x}", subject.world().state_hash());
      const Explanation explanation = subject.world().explain();
      run.bytes = explanation.bytes_per_body_step;
      run.flops = explanation.flops_per_body_step;
      auto own = observe(file_, scene_with(scene, setting), options_for(setting), go_on);
      if (!own) return std::nullopt;
      run.own = std::move(*own);
    } catch (const SceneError& error) {
      run.trouble = error.problems().front().message;
    }
    return run;
  }

  Options options_for(const Setting& setting) const {
    Options options = ground_.options;
    options.precision = setting.precision;
    return options;
  }

  /// The full scene, and how wrong it is: its path beside the reference, numbers beside those of steps half as long.
  bool run_full() {
    auto full = seen(ground_.scene, setting_, ground_.samples);
    if (!full) return false;
    full_ = std::move(*full);
    ablation_.trouble = full_.trouble;
    if (!full_.trouble.empty()) return true;
    Setting finer = setting_;
    finer.step /= 2;
    finer.tolerance /= 10;
    auto fine = seen(ground_.scene, finer, ground_.samples);
    if (!fine) return false;
    fine_ = std::move(*fine);
    ablation_.errors = errors_of(full_.path, ground_.reference.track, full_.start);
    ablation_.own_error = std::max(ground_.error_of(ablation_.errors), ground_.about.floor);
    const double scale = ground_.about.reference.scale[static_cast<std::size_t>(ground_.measure.quantity)];
    ablation_.most = request_.tolerance.value_or(worth_losing * scale);
    return true;
  }

  bool drop(std::size_t i) {
    fraction_ = static_cast<double>(i) / static_cast<double>(scenes_.size());
    Loss loss{.index = i, .kind = ground_.scene.effects[i].kind, .label = label_of(ground_.scene, i)};
    auto run = seen(scenes_[i], setting_, ground_.samples);
    if (!run) return false;
    loss.trouble = run->trouble;
    if (loss.trouble.empty()) compare(*run, loss);
    ablation_.losses.push_back(std::move(loss));
    runs_.push_back({&scenes_[i], setting_, run->state_hash});
    return true;
  }

  void compare(const Seen& run, Loss& loss) {
    loss.errors = errors_of(run.path, full_.path, full_.start);
    loss.moved = ground_.error_of(loss.errors);
    loss.same_bits = run.state_hash == full_.state_hash;
    loss.bytes = full_.bytes - run.bytes;
    loss.flops = full_.flops - run.flops;
    const auto energy = [&](const Seen& of) {
      const double value = gauge_.energy(of.end);
      return Observation{"energy at the end", "J", Vector3d(value, 0, 0), std::isfinite(value)};
    };
    loss.energy = change(energy(full_), energy(run), energy(fine_));
    for (std::size_t k = 0; k < full_.own.size(); ++k) {
      loss.own.push_back(change(full_.own[k], run.own[k], k < fine_.own.size() ? fine_.own[k] : Observation{}));
    }
  }

  static Change change(const Observation& full, const Observation& without, const Observation& fine) {
    const bool neither = !full.there && !without.there;
    return {full.name, full.unit, full, without, neither ? 0 : apart(full, without), first_order * apart(full, fine)};
  }

  bool time_all() {
    std::vector<TimedRun> others;
    std::vector<Loss*> timed;
    for (Loss& loss : ablation_.losses) {
      if (!loss.trouble.empty()) continue;
      others.push_back(runs_[loss.index]);
      timed.push_back(&loss);
    }
    if (others.empty()) return true;
    const int rounds = full_.seconds > long_run ? few_rounds : many_rounds;
    const SweepTime time{timing_share * request_.seconds, rounds};
    const double begin = seconds_now(), expected = std::max(time.seconds, 1e-3);
    const auto list = time_beside({&ground_.scene, setting_, full_.state_hash}, others, ground_.options, time,
                                  [&] { return on("timing", std::min(1.0, (seconds_now() - begin) / expected)); });
    if (!list) return false;
    for (std::size_t i = 0; i < timed.size(); ++i) {
      timed[i]->time = (*list)[i];
      timed[i]->trouble = (*list)[i].trouble;
    }
    return true;
  }

  bool look_beyond_horizon() {
    if (!ground_.goes_beyond_horizon() || scenes_.empty()) return true;
    const GoOn go_on = [&] { return on("ensembles", 0.5); };
    return add_means(ground_, whole_, request_, full_.seconds, ablation_, go_on);
  }

  const Ground& ground_;
  scenes::SceneFile file_;
  const Request& request_;
  const Progress& progress_;
  Setting setting_;
  const scenes::SceneFile& whole_;
  Gauge gauge_;
  Ablation ablation_;
  Seen full_, fine_;
  std::vector<Scene> scenes_;   ///< without an effect, one after the other
  std::vector<TimedRun> runs_;  ///< of these
  double fraction_ = 0;
};

}  // namespace

Scene without_effect(const Scene& scene, std::size_t index) {
  Scene changed = scene;
  changed.effects.erase(changed.effects.begin() + static_cast<std::ptrdiff_t>(index));
  return changed;
}

std::string label_of(const Scene& scene, std::size_t index) {
  const std::string& kind = scene.effects[index].kind;
  const auto alike =
      std::count_if(scene.effects.begin(), scene.effects.end(), [&](const Effect& e) { return e.kind == kind; });
  return alike > 1 ? fmt::format("{} (effects.{})", kind, index) : kind;
}

std::optional<Ablation> ablate(const scenes::SceneFile& file, const Request& request, const Progress& progress) {
  const double begin = seconds_now();
  GroundRequest wanted{request.measure, request.reference, reference_share * request.seconds, {}, request.options};
  wanted.which = "end";
  const GoOn go_on = [&] { return progress("reference", std::min(1.0, (seconds_now() - begin) / wanted.seconds)); };
  const std::optional<Ground> ground = ground_for(file.scene, wanted, go_on);
  if (!ground) return std::nullopt;
  return Study(*ground, file, request, progress).result();
}

}  // namespace ballpark::cost
