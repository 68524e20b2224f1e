#include "perf/effects/ensembles.h"

#include <fmt/format.h>

#include <cmath>

#include "perf/cost/ensemble.h"

namespace ballpark::cost {

namespace {

constexpr double share = 0.3;         ///< of the time
constexpr double runs_of_a_copy = 4;  ///< once for what every scene shows, the rest for its own quantities
constexpr double by_chance = 0.05;    ///< how often an effect without any influence may be taken for one that has
constexpr double rounding = 1e-12;    ///< relative: means that differ by less do not differ

struct Means {
  std::vector<Observable> observables;
  std::vector<Mean> of;
  std::string trouble = {};
};

/// What the scene itself is judged by, as more observables; those that some copy does not have are left out.
bool add_own(const scenes::SceneFile& file, const Scene& scene, const EnsembleRequest& request, Options options,
             const GoOn& go_on, Means& means) {
  options.perturb = request.perturb;
  std::vector<std::vector<Observation>> copies;
  Scene copy = scene;
  for (int k = 0; k < request.copies; ++k) {
    copy.run.seed = scene.run.seed + static_cast<std::uint64_t>(k);
    auto own = observe(file, copy, options, go_on);
    if (!own) return false;
    copies.push_back(std::move(*own));
  }
  for (std::size_t o = 0; o < copies.front().size(); ++o) {
    std::vector<double> values;
    for (const auto& own : copies) {
      if (own[o].there && !own[o].name.starts_with("place of ")) values.push_back(own[o].value.x());
    }
    means.observables.push_back({copies.front()[o].name, copies.front()[o].unit});
    const bool all = values.size() == copies.size();
    means.of.push_back(all ? mean_of(values) : Mean{});
  }
  return true;
}

/// nullopt: stopped.
std::optional<Means> means_of(const scenes::SceneFile& file, const Scene& scene, const EnsembleRequest& request,
                              const Options& options, const GoOn& go_on) {
  Means means{observables(), {}};
  try {
    const auto copies = run_copies(scene, setting_of(scene), request, options, go_on);
    if (!copies) return std::nullopt;
    means.trouble = copies->trouble;
    if (!means.trouble.empty()) return means;
    for (const std::vector<double>& values : copies->values) means.of.push_back(mean_of(values));
    if (!add_own(file, scene, request, options, go_on, means)) return std::nullopt;
  } catch (const SceneError& error) {
    means.trouble = error.problems().front().message;
  }
  return means;
}

/// Those that both ensembles have and that are not the same in all runs.
std::vector<MeanChange> changes(const Means& full, const Means& without) {
  std::vector<MeanChange> list;
  for (std::size_t o = 0; o < full.of.size(); ++o) {
    const Mean &a = without.of[o], &b = full.of[o];
    if (a.count == 0 || b.count == 0) continue;
    const double size = std::max(std::abs(a.value), std::abs(b.value));
    const bool alike = std::abs(a.value - b.value) <= rounding * size;
    if (alike && std::max(a.error, b.error) <= rounding * size) continue;
    list.push_back({full.observables[o], b, a, alike ? Difference{} : difference_of(a, b)});
  }
  for (MeanChange& change : list) {
    change.seen = change.difference.chance * static_cast<double>(list.size()) < by_chance;
  }
  return list;
}

}  // namespace

bool add_means(const Ground& ground, const scenes::SceneFile& file, const Request& request, double seconds,
               Ablation& ablation, const GoOn& go_on) {
  const EnsembleRequest wanted{request.copies.value_or(fewest_copies),
                               request.perturb.value_or(1 / ground.about.horizon->growth)};
  const double scenes = static_cast<double>(ground.scene.effects.size() + 1);
  const double needed = seconds * ground.whole / ground.scene.run.duration * wanted.copies * scenes * runs_of_a_copy;
  if (needed > share * request.seconds) {
    ablation.about.left_out.push_back(
        fmt::format("statistics beyond the horizon: {} runs with and without each effect take {} (--seconds {:.0f})",
                    wanted.copies, time_text(needed), 10 * std::ceil(1.2 * needed / share / 10)));
    return true;
  }
  Scene whole = ground.scene;
  whole.run.duration = ground.whole;
  const auto full = means_of(file, whole, wanted, ground.options, go_on);
  if (!full) return false;
  if (!full->trouble.empty()) {
    ablation.about.left_out.push_back("statistics beyond the horizon: " + full->trouble);
    return true;
  }
  ablation.copies = wanted.copies;
  ablation.perturb = wanted.perturb;
  for (Loss& loss : ablation.losses) {
    if (!loss.trouble.empty()) continue;
    const auto without = means_of(file, without_effect(whole, loss.index), wanted, ground.options, go_on);
    if (!without) return false;
    loss.trouble = without->trouble;
    if (loss.trouble.empty()) loss.means = changes(*full, *without);
  }
  return true;
}

}  // namespace ballpark::cost
