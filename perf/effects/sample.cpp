#include "perf/effects/sample.h"

#include <algorithm>

namespace ballpark::perf {

namespace {

std::vector<IdPair> chain(std::size_t bodies) {
  std::vector<IdPair> pairs;
  for (std::size_t id = 1; id < bodies; ++id) pairs.push_back({id - 1, id});
  return pairs;
}

Value small_value(const ParameterInfo& parameter, std::size_t bodies) {
  constexpr double small = 1e-3;
  const Vector3d vector(small, 2 * small, 3 * small);
  switch (parameter.kind) {
    case ParameterKind::vector:
      return vector;
    case ParameterKind::vectors:
      return std::vector<Vector3d>{vector};
    case ParameterKind::pairs:
      return chain(bodies);
    case ParameterKind::word:
      return parameter.choices.front();
    case ParameterKind::numbers:
      return std::vector<double>{std::clamp(small, parameter.minimum, parameter.maximum)};
    default:
      return std::clamp(small, parameter.minimum, parameter.maximum);
  }
}

}  // namespace

Effect sample_of(const EffectDescription& description, std::size_t bodies) {
  Effect effect{.kind = description.name, .groups = {}, .parameters = {}};
  for (const ParameterInfo& parameter : description.parameters) {
    if (!parameter.fallback) effect.parameters[parameter.name] = small_value(parameter, bodies);
  }
  // bodies are there, and stay
  if (description.name == "emitter") effect.parameters["every"] = 0.0;
  if (description.name == "absorbing_wall") effect.parameters["point"] = Vector3d(0, 0, -1e6);
  if (description.name == "outlet") effect.parameters["point"] = Vector3d(0, 0, -1e6);
  return effect;
}

}  // namespace ballpark::perf
