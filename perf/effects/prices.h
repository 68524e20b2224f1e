// What each effect adds to the time of a step: alone, beside bodies that no force acts on, and in a scene.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ballpark/catalogue.h"
#include "perf/cost/cost.h"
#include "perf/effects/beside.h"

namespace ballpark::cost {

struct PricesRequest {
  std::optional<Scene> scene = {};  ///< none: all effects of the catalogue, alone
  std::size_t bodies = 1'000'000;   ///< of the large scenes
  double seconds = 60;              ///< for all of it, about
  double body_steps = 1e6;          ///< of each timed run, about
  Options options = {};             ///< its precision: only this one
};

/// What a body-step takes more with the effect.
struct Price {
  Precision precision = Precision::double_;
  std::size_t bodies = 0;
  double nanoseconds_of_minima = 0, nanoseconds_of_medians = 0;
  double base = 0;     ///< of a body-step without it, by minima [ns]
  bool shows = false;  ///< is it more than noise?
};

/// Of an effect among a kind of bodies.
struct EffectPrice {
  std::string label;
  std::string beside;              ///< what it is added to: "particles", "balls", ..., or the scene's name
  int flops = 0;                   ///< of an evaluation, as its descriptor says
  double bytes = 0;                ///< that a body-step moves more, in double precision
  double flops_of_step = 0;        ///< that it computes more
  std::vector<Price> prices = {};  ///< by precision, of many bodies before those of few
};

struct Prices {
  std::string machine, integrator;  ///< the latter of effects alone
  int threads = 1;
  std::vector<EffectPrice> alone, in_scene;
  double duration = 0, whole = 0;  ///< of the scene: what was timed of it, and all of it [s]
  std::vector<std::string> left_out;
};

/// The few that stay in cache: one block.
inline constexpr std::size_t few_bodies = 4096;

/// nullopt if it was stopped. Throws SceneError of the scene.
std::optional<Prices> prices(const PricesRequest& request, const Progress& progress);

/// As many bodies as the effect takes, of the plainest kind that it takes: without it, and with it. nullopt, and why,
/// if it takes none.
struct PlainScenes {
  std::string bodies;  ///< "particles"
  Scene without = {}, with = {};
};
std::optional<PlainScenes> plain_scenes(const EffectDescription& effect, std::size_t bodies, std::uint64_t steps,
                                        std::string& why);

}  // namespace ballpark::cost
