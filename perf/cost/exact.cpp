#include "perf/cost/exact.h"

#include <limits>

#include "ballpark/catalogue.h"

namespace ballpark::cost {

namespace {

/// nullptr if neither the scene nor the catalogue has it, which a checked scene rules out.
const Value* find_value(const Effect& effect, const std::string& parameter) {
  const auto given = effect.parameters.find(parameter);
  if (given != effect.parameters.end()) return &given->second;
  for (const EffectDescription& description : effects()) {
    if (description.name != effect.kind) continue;
    for (const ParameterInfo& info : description.parameters) {
      if (info.name == parameter && info.fallback) return &*info.fallback;
    }
  }
  return nullptr;
}

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

}  // namespace

double number(const Effect& effect, const std::string& parameter) {
  const Value* value = find_value(effect, parameter);
  const double* found = value ? std::get_if<double>(value) : nullptr;
  return found ? *found : nothing;
}

std::string word(const Effect& effect, const std::string& parameter) {
  const Value* value = find_value(effect, parameter);
  const std::string* found = value ? std::get_if<std::string>(value) : nullptr;
  return found ? *found : "";
}

Vector3d vector(const Effect& effect, const std::string& parameter, std::size_t index) {
  const Value* value = find_value(effect, parameter);
  if (const auto* one = value ? std::get_if<Vector3d>(value) : nullptr) return *one;
  if (const auto* rows = value ? std::get_if<std::vector<Vector3d>>(value) : nullptr) {
    if (rows->size() == 1) return rows->front();
    if (index < rows->size()) return (*rows)[index];
  }
  return Vector3d::Constant(nothing);
}

std::optional<ExactMotion> exact_motion(const LoneBody& body) {
  for (ClosedForm* form : {ballistic, vertical_drag, oscillator, kepler, pendulum, torque_free, symmetric_top,
                           constant_spin_lift, charged_particle, foucault}) {
    if (std::optional<ExactMotion> motion = form(body)) return motion;
  }
  return std::nullopt;
}

std::optional<ExactMotion> exact_motion(const TouchingBodies& all, std::size_t id) {
  return bouncing_ball(all, id);
}

}  // namespace ballpark::cost
