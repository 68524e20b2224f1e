// What acts on a body, as closed forms ask for it.
#pragma once

#include <algorithm>
#include <initializer_list>
#include <string_view>
#include <vector>

#include "perf/cost/closed_forms/frame.h"

namespace ballpark::cost {

inline std::vector<const Effect*> of_kind(const LoneBody& body, std::string_view kind) {
  std::vector<const Effect*> found;
  std::copy_if(body.effects.begin(), body.effects.end(), std::back_inserter(found),
               [kind](const Effect* effect) { return effect->kind == kind; });
  return found;
}

inline bool only_these_act(const LoneBody& body, std::initializer_list<std::string_view> kinds) {
  return std::all_of(body.effects.begin(), body.effects.end(), [kinds](const Effect* effect) {
    return std::find(kinds.begin(), kinds.end(), effect->kind) != kinds.end();
  });
}

/// Several effects of a kind act together.
template <class R>
R sum(const LoneBody& body, std::string_view kind, const std::string& parameter) {
  R total = 0;
  for (const Effect* effect : of_kind(body, kind)) total += R(number(*effect, parameter));
  return total;
}

template <class R>
Vector<R> gravity(const LoneBody& body) {
  Vector<R> total = Vector<R>::Zero();
  for (const Effect* effect : of_kind(body, "gravity")) total += vector(*effect, "acceleration").cast<R>();
  return total;
}

/// Acceleration by all uniform forces.
template <class R>
Vector<R> uniform_push(const LoneBody& body) {
  Vector<R> force = Vector<R>::Zero();
  for (const Effect* effect : of_kind(body, "electric_field")) {
    force += R(number(*effect, "charge")) * vector(*effect, "field").cast<R>();
  }
  return gravity<R>(body) + force / R(body.mass);
}

/// The rate W at which magnetic fields and Coriolis forces turn the velocity, v' = W x v.
template <class R>
Vector<R> turning(const LoneBody& body) {
  Vector<R> total = Vector<R>::Zero();
  for (const Effect* effect : of_kind(body, "magnetic_field")) {
    total -= R(number(*effect, "charge")) / R(body.mass) * vector(*effect, "field").cast<R>();
  }
  for (const Effect* effect : of_kind(body, "rotating_frame")) {
    total -= 2 * vector(*effect, "angular_velocity").cast<R>();
  }
  return total;
}

}  // namespace ballpark::cost
