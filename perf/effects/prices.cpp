#include "perf/effects/prices.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "ballpark/catalogue.h"
#include "perf/effects/ablation.h"
#include "perf/machine.h"
#include "perf/timing.h"

namespace ballpark::cost {

namespace {

using perf::seconds_now;

constexpr int rounds = 7;
constexpr std::uint64_t fewest_steps = 2;
constexpr double long_step = 0.05;           ///< effects between bodies: so many bodies that a step takes no longer [s]
constexpr std::size_t fewest_pairing = 256;  ///< where the search for them begins

/// Seconds that a scene's run takes for a simulated second, from a part of it that the clock sees well.
double pace_of(const Scene& scene, const Options& options) {
  constexpr double long_enough = 0.01;
  World world(scene, options);
  const double begin = seconds_now();
  for (std::uint64_t steps = 1; world.time() < scene.run.duration * (1 - 1e-9); steps *= 2) {
    const double before = world.time();
    world.advance_to(scene.run.duration, steps);
    if (seconds_now() - begin > long_enough || world.time() == before) break;
  }
  return (seconds_now() - begin) / std::max(world.time(), 1e-300);
}

struct Size {
  std::size_t bodies = 0;
  std::uint64_t steps = 0;  ///< of a run
};

/// Effects that share their base.
struct Batch {
  Size size;
  Scene base;
  std::vector<std::size_t> effects;  ///< indices of their prices
  std::vector<Scene> scenes;         ///< with each
};

class Study {
 public:
  Study(const PricesRequest& request, const Progress& progress) : request_(request), progress_(progress) {
    options_ = request.options;
    options_.precision.reset();
    if (options_.threads == 0) options_.threads = 1;
    precisions_ = {Precision::double_, Precision::single_};
    if (request.options.precision) precisions_ = {*request.options.precision};
    prices_.machine = perf::machine().processor;
    prices_.threads = options_.threads;
    prices_.integrator = "rk4";
    list_effects();
  }

  std::optional<Prices> result() {
    for (const Precision precision : precisions_) {
      for (const std::size_t bodies : sizes()) {
        if (!price_alone(precision, bodies)) return std::nullopt;
      }
      if (request_.scene && !price_in_scene(precision)) return std::nullopt;
    }
    std::erase_if(prices_.alone, [](const EffectPrice& price) { return price.prices.empty(); });
    return std::move(prices_);
  }

 private:
  bool on() {
    const double taken = seconds_now() - begin_;
    return progress_("timing", std::min(1.0, taken / request_.seconds));
  }
  std::uint64_t steps_for(std::size_t bodies) const {
    const double steps = std::ceil(request_.body_steps / static_cast<double>(std::max<std::size_t>(bodies, 1)));
    return std::max(fewest_steps, static_cast<std::uint64_t>(steps));
  }
  /// Many before few.
  std::vector<std::size_t> sizes() const {
    if (request_.bodies <= few_bodies) return {request_.bodies};
    return {request_.bodies, few_bodies};
  }
  /// For one of the parts that the time is shared among.
  SweepTime share_of_time() const {
    const double parts = static_cast<double>(precisions_.size() * (sizes().size() + (request_.scene ? 1 : 0)));
    return {request_.seconds / parts, rounds};
  }

  /// Those of the scene, each kind once, or all.
  void list_effects() {
    for (const EffectDescription& description : effects()) {
      const auto listed = [&](const Effect& effect) { return effect.kind == description.name; };
      if (request_.scene && std::none_of(request_.scene->effects.begin(), request_.scene->effects.end(), listed)) {
        continue;
      }
      descriptions_.push_back(&description);
      prices_.alone.push_back({.label = description.name, .beside = "", .flops = description.flops});
    }
  }

  bool price_alone(Precision precision, std::size_t bodies) {
    std::map<std::string, Batch> batches;
    for (std::size_t i = 0; i < descriptions_.size(); ++i) {
      const bool pairs = descriptions_[i]->between_bodies;
      const Size size = pairs ? pairing(*descriptions_[i], bodies) : Size{bodies, steps_for(bodies)};
      if (is_priced(prices_.alone[i], precision, size.bodies)) continue;
      std::string why;
      auto scenes = plain_scenes(*descriptions_[i], size.bodies, size.steps, why);
      if (!scenes) {
        leave_out(*descriptions_[i], why);
        continue;
      }
      if (prices_.alone[i].beside.empty()) describe(*descriptions_[i], prices_.alone[i]);
      Batch& batch = batches[fmt::format("{} {} {}", scenes->bodies, size.bodies, size.steps)];
      batch.size = size;
      batch.base = scenes->without;
      batch.effects.push_back(i);
      batch.scenes.push_back(scenes->with);
    }
    for (auto& [name, batch] : batches) {
      const double share = static_cast<double>(batch.effects.size()) / static_cast<double>(descriptions_.size());
      if (!time_batch(precision, batch, share)) return false;
    }
    return true;
  }

  static bool is_priced(const EffectPrice& effect, Precision precision, std::size_t bodies) {
    return std::any_of(effect.prices.begin(), effect.prices.end(),
                       [&](const Price& p) { return p.precision == precision && p.bodies == bodies; });
  }

  /// What a body-step moves and computes more, among few bodies.
  void describe(const EffectDescription& effect, EffectPrice& price) const {
    std::string why;
    const auto scenes = plain_scenes(effect, fewest_pairing, 1, why);
    if (!scenes) return;
    price.beside = scenes->bodies;
    take_more(World(scenes->without, options_).explain(), World(scenes->with, options_).explain(), price);
  }

  static void take_more(const Explanation& without, const Explanation& with, EffectPrice& price) {
    price.bytes = with.bytes_per_body_step - without.bytes_per_body_step;
    price.flops_of_step = with.flops_per_body_step - without.flops_per_body_step;
  }

  void leave_out(const EffectDescription& effect, const std::string& why) {
    const std::string sentence = fmt::format("{}, alone: {}", effect.name, why);
    if (std::find(prices_.left_out.begin(), prices_.left_out.end(), sentence) == prices_.left_out.end()) {
      prices_.left_out.push_back(sentence);
    }
  }

  /// As many bodies as pair up in a step that is not too long, at most so many; steps for a run of about that.
  Size pairing(const EffectDescription& effect, std::size_t most) {
    Size& known = pairing_[effect.name];
    double step = 0;
    for (std::size_t bodies = std::min(fewest_pairing, most); known.bodies == 0; bodies *= 4) {
      step = std::max(seconds_of_step(effect, bodies), 1e-9);
      if (4 * bodies <= most && 16 * step < long_step) continue;  // as if all met all
      known = {bodies, std::clamp<std::uint64_t>(static_cast<std::uint64_t>(long_step / step), fewest_steps,
                                                 steps_for(bodies))};
    }
    if (known.bodies <= most) return known;
    return {most, steps_for(most)};
  }

  /// 0 if it takes none of the bodies.
  double seconds_of_step(const EffectDescription& effect, std::size_t bodies) const {
    std::string why;
    const auto scenes = plain_scenes(effect, bodies, 1, why);
    if (!scenes) return 0;
    World world(scenes->with, options_);
    world.step();  // the first one sets up
    const double begin = seconds_now();
    world.step();
    return seconds_now() - begin;
  }

  bool time_batch(Precision precision, const Batch& batch, double share) {
    const SweepTime effort{share * share_of_time().seconds, rounds};
    const auto run_of = [&](const Scene& scene) {
      Setting setting = setting_of(scene);
      setting.precision = precision;
      return TimedRun{&scene, setting};
    };
    std::vector<TimedRun> runs;
    for (const Scene& scene : batch.scenes) runs.push_back(run_of(scene));
    const auto times = time_beside(run_of(batch.base), runs, options_, effort, [&] { return on(); });
    if (!times) return false;
    const double body_steps = static_cast<double>(batch.size.steps * batch.size.bodies);
    for (std::size_t i = 0; i < runs.size(); ++i) {
      const std::size_t effect = batch.effects[i];
      if ((*times)[i].trouble.empty()) {
        const Beside& time = (*times)[i];
        prices_.alone[effect].prices.push_back(
            price_of(time.seconds, time.base, precision, body_steps, batch.size.bodies));
        prices_.alone[effect].prices.back().shows = time.shows();
      } else {
        leave_out(*descriptions_[effect], (*times)[i].trouble);
      }
    }
    return true;
  }

  /// Of runs with and without.
  static Price price_of(const Seconds& with, const Seconds& without, Precision precision, double body_steps,
                        std::size_t bodies) {
    const double each = 1e9 / body_steps;
    return {precision, bodies, (with.minimum - without.minimum) * each, (with.median - without.median) * each,
            without.minimum * each};
  }

  /// What the scene takes less without each.
  bool price_in_scene(Precision precision) {
    Scene scene = *request_.scene;
    scene.run.precision = precision;
    const double slice = share_of_time().seconds / (rounds * static_cast<double>(scene.effects.size() + 3));
    const double pace = pace_of(scene, options_), whole = scene.run.duration;
    scene.run.duration = std::min(whole, slice / pace);
    if (scene.run.step > 0) {
      const double steps = std::floor(scene.run.duration / scene.run.step + 1e-9);
      scene.run.duration = scene.run.step * std::max(1.0, steps);
    }
    prices_.duration = scene.run.duration;
    prices_.whole = whole;
    std::vector<Scene> scenes;
    for (std::size_t i = 0; i < scene.effects.size(); ++i) scenes.push_back(without_effect(scene, i));
    return time_in_scene(precision, scene, scenes);
  }

  bool time_in_scene(Precision precision, const Scene& scene, const std::vector<Scene>& scenes) {
    std::vector<TimedRun> runs;
    std::vector<std::size_t> effects;
    for (std::size_t i = 0; i < scenes.size(); ++i) {
      if (const auto problems = check(scenes[i]); !problems.empty()) {
        prices_.left_out.push_back(
            fmt::format("{} without {}: {}", scene.name, label_of(scene, i), problems.front().message));
        continue;
      }
      runs.push_back({&scenes[i], setting_of(scenes[i])});
      effects.push_back(i);
    }
    const auto times = time_beside({&scene, setting_of(scene)}, runs, options_, share_of_time(), [&] { return on(); });
    if (!times) return false;
    const World full(scene, options_);
    for (std::size_t k = 0; k < effects.size(); ++k) {
      EffectPrice& price = entry_in_scene(scene, effects[k], full, scenes[effects[k]]);
      const Beside& time = (*times)[k];
      if (time.trouble.empty()) {
        const std::size_t bodies = full.body_count();
        const double steps = steps_of(scene) * static_cast<double>(bodies);
        price.prices.push_back(price_of(time.base, time.seconds, precision, steps, bodies));
        price.prices.back().shows = time.shows();
      } else {
        prices_.left_out.push_back(fmt::format("{} without {}: {}", scene.name, price.label, time.trouble));
      }
    }
    return true;
  }

  /// With a tolerance as many as the full scene takes.
  double steps_of(const Scene& scene) const {
    if (scene.run.tolerance == 0) return std::round(scene.run.duration / scene.run.step);
    World world(scene, options_);
    world.advance_to(scene.run.duration);
    return static_cast<double>(std::max<std::uint64_t>(1, world.steps()));
  }

  EffectPrice& entry_in_scene(const Scene& scene, std::size_t index, const World& full, const Scene& without) {
    const std::string label = label_of(scene, index);
    for (EffectPrice& price : prices_.in_scene) {
      if (price.label == label) return price;
    }
    const auto& list = effects();
    const auto description =
        std::find_if(list.begin(), list.end(), [&](auto& d) { return d.name == scene.effects[index].kind; });
    prices_.in_scene.push_back({.label = label, .beside = scene.name, .flops = description->flops});
    take_more(World(without, options_).explain(), full.explain(), prices_.in_scene.back());
    return prices_.in_scene.back();
  }

  const PricesRequest& request_;
  const Progress& progress_;
  const double begin_ = seconds_now();
  Options options_;
  std::vector<Precision> precisions_;
  std::vector<const EffectDescription*> descriptions_;
  std::map<std::string, Size> pairing_;
  Prices prices_;
};

}  // namespace

std::optional<Prices> prices(const PricesRequest& request, const Progress& progress) {
  return Study(request, progress).result();
}

}  // namespace ballpark::cost
