// What an effect between steps tells of itself: it changes bodies at once when a step has ended, and exerts no force.
// Bodies are told apart by their copy and their id in it, so that no order of rows reaches a bit.
#pragma once

#include <cstdint>
#include <memory>

#include "engine/core/function_ref.h"
#include "engine/effects/effect_info.h"

namespace ballpark::BALLPARK_PRECISION {

struct BodyName {
  std::uint64_t copy, id;
};

/// Rows [first, last) of a group.
struct StepBodies {
  std::size_t first, last;
  Real* const* position;
  Real* const* velocity;
  const PerBody& mass;
  FunctionRef<BodyName(std::size_t row)> name_of;
};

/// The step that ended.
struct EndedStep {
  double length;         ///< [s]
  std::uint64_t number;  ///< from 1
};

class StepEffect {
 public:
  virtual ~StepEffect() = default;
  virtual void act(const StepBodies& bodies, const EndedStep& step) const = 0;
};

/// A scene's effect as its own code reads it. Parameters are checked and defaults filled in.
struct StepInput {
  const EffectInput& effect;
  std::uint64_t seed;     ///< of the scene's first copy
  std::uint64_t ordinal;  ///< which of the scene's effects between steps
};

struct StepEffectInfo {
  EffectDescription description;
  std::unique_ptr<StepEffect> (*make)(const StepInput&) = nullptr;
  int values = 0;  ///< of state that it reads and writes, for one body
};

template <class E>
StepEffectInfo step_effect_info() {
  return {E::description(),
          [](const StepInput& input) -> std::unique_ptr<StepEffect> { return std::make_unique<E>(input); }, E::values};
}

/// To add one: write its file, and name it in the list of step_effects.cpp. They act in its order.
const std::vector<StepEffectInfo>& step_effects();
/// Position in step_effects() by name; -1 for other effects.
int step_effect_index(const std::string& name);

}  // namespace ballpark::BALLPARK_PRECISION
