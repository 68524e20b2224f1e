// What an effect between steps tells of itself: it changes bodies at once when a step has ended, and exerts no force.
// Bodies are told apart by their copy and their id in it, so that no order of rows reaches a bit.
#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>

#include "engine/core/function_ref.h"
#include "engine/effects/effect_info.h"

namespace ballpark::BALLPARK_PRECISION {

struct BodyName {
  std::uint64_t copy, id, index;  ///< id in its copy, index in its group there
};

/// Rows [first, last) of a group. Of a body that is not there, every value of the state is NaN, so that each comparison
/// passes it by.
struct StepBodies {
  std::size_t first, last;
  Real* const* position;
  Real* const* velocity;
  const PerBody& mass;
  FunctionRef<BodyName(std::size_t row)> name_of;
  FunctionRef<void(std::size_t row)> leave;  ///< for good
  /// With the state that the scene starts it with, after a free flight of so many seconds.
  FunctionRef<void(std::size_t row, double flight)> enter;
};

/// The step that ended.
struct EndedStep {
  double length;                                                       ///< [s]
  std::uint64_t number;                                                ///< from 1
  double end() const { return static_cast<double>(number) * length; }  ///< [s]
};

class StepEffect {
 public:
  virtual ~StepEffect() = default;
  virtual void act(const StepBodies& bodies, const EndedStep& step) const = 0;
  /// When the body of a group enters [s]: those that do so after the start are not there before.
  virtual double entry(std::uint64_t) const { return 0; }
  /// By this time, how many bodies of a group should have entered; more than there are is an error.
  virtual double entries(double) const { return 0; }
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

  bool opens() const { return exerts("present"); }               ///< do bodies enter or leave by it?
  bool enters() const { return opens() && exerts("position"); }  ///< do they enter?
  bool exerts(const char* what) const {
    return std::find(description.exerts.begin(), description.exerts.end(), what) != description.exerts.end();
  }
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
