// What each effect of a scene is worth: the time that a run without it saves, and what it changes.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "perf/cost/cost.h"
#include "perf/effects/beside.h"
#include "perf/effects/observe.h"

namespace ballpark::cost {

/// A number of the run with an effect and without it.
struct Change {
  std::string name, unit;
  Observation full, without;
  double size = 0;       ///< how far the two are apart; infinite: one run does not have it
  double own_error = 0;  ///< of the full scene, which no smaller change is told from
  bool seen() const { return size > own_error; }
  /// An expectation that is missed without the effect alone.
  bool breaks() const { return seen() && without.missed && !full.missed; }
};

/// Beyond the horizon: a mean over runs with the effect and without it.
struct MeanChange {
  Observable observable;
  Mean full, without;
  Difference difference;
  bool seen = false;  ///< chance would make one as large among all of the effect's in one of twenty cases at most
};

struct Loss {
  std::size_t index = 0;  ///< among the scene's effects
  std::string kind;
  std::string label;         ///< the kind, and the index where there are several of it
  std::string trouble = {};  ///< why there is no run without it; "" if there is
  Beside time = {};
  double bytes = 0, flops = 0;         ///< that a body-step does without
  Errors errors = {};                  ///< of the run without it, held against the full one
  double moved = 0;                    ///< the one of the measure
  bool same_bits = false;              ///< both runs end in the same state
  Change energy = {};                  ///< at the end, as the full scene counts it
  std::vector<Change> own = {};        ///< of what the scene is judged and watched by
  std::vector<MeanChange> means = {};  ///< empty: paths mean something to the end, or there was no time
  bool keep = false;
  std::string sentence = {};
};

struct Ablation {
  std::string trouble = {};       ///< why the full scene itself has no result; "" if it has
  Result about = {};              ///< scene, reference, measure and horizon; no points
  Errors errors = {};             ///< of the full scene's own run
  double own_error = 0;           ///< of them that of the measure; none below the reference's floor
  double most = 0;                ///< changes of the measure up to here are worth losing an effect
  int copies = 0;                 ///< of ensembles beyond the horizon; 0: there were none
  double perturb = 0;             ///< relative change of their starts
  std::vector<Loss> losses = {};  ///< the cheapest to lose first
};

/// Drops each effect in turn. Of the request: measure ("end" unless given), reference, seconds, tolerance (the largest
/// change that is worth it; none: a hundredth of how far things go), copies, perturb, options. nullopt if it was
/// stopped or has no reference. Throws SceneError.
std::optional<Ablation> ablate(const scenes::SceneFile& file, const Request& request, const Progress& progress);

/// The scene without one of its effects.
Scene without_effect(const Scene& scene, std::size_t index);
/// The kind, and the index where there are several of it.
std::string label_of(const Scene& scene, std::size_t index);

/// Settles what is said of the losses, and their order.
void judge(Ablation& ablation);

}  // namespace ballpark::cost
