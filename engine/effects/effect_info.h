// What an effect tells of itself. An effect is a struct in a file of engine/effects with
//   Constants                                    its parameters as Real, packed once at build
//   force(constants, body, loads)                adds to the loads; a template on the vector type
//   feels_flow                                   optional: its velocity is relative to the fluid
//   reads_loads                                  optional: it answers to the loads that are summed before it
//   force_rate(constants, body, a, load_rates)   optional: adds the time derivative of its loads (Taylor-2)
//   turning(constants, body)                     optional: W [1/s] of m W x v, which then is all of its force that
//                                                reads velocity (Boris)
//   energy(constants, body)                      optional: potential energy
//   Constants::window                            optional: when it acts; steps are split at its ends
//   Constants::rows                              optional: acts on one body or all
// or in place of force
//   flow(constants, body, time), flow_rate(...)  velocity of the fluid at a body, and its rate along the body's path
//   added_mass(constants, row)                   what adds to the mass that resists forces
// and, outside kernel compilations:
//   description(), pack(input)                   catalogue entry; parameters into Constants
//   stiffness(input)                             optional: for the stability limit of the step
#pragma once

#include <limits>

#include "engine/kernels/body.h"

#ifndef BALLPARK_TARGET  // descriptors exist once, in the base compilation
#include <array>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "ballpark/catalogue.h"
#endif

namespace ballpark::BALLPARK_PRECISION {

/// Linear response of a force to its body's motion, for the largest stable step.
struct Stiffness {
  double spring = 0;    ///< -dF/dx [N/m]; negative: it pushes away
  double damping = 0;   ///< -dF/dv along v [kg/s]
  double gyration = 0;  ///< |dF/dv| across v: the force turns the velocity of a mass m at the rate gyration / m [kg/s]
  double turning = 0;   ///< -dT/dw along the spin w; set apart from what moves the body [N m s]

  bool any() const { return spring != 0 || damping != 0 || gyration != 0; }
  /// Of forces that act together: a bound, as turns about different axes are taken for turns about one.
  friend Stiffness operator+(const Stiffness& a, const Stiffness& b) {
    return {a.spring + b.spring, a.damping + b.damping, a.gyration + b.gyration, a.turning + b.turning};
  }
  friend Stiffness operator/(const Stiffness& a, double mass) {
    return {a.spring / mass, a.damping / mass, a.gyration / mass};
  }
  /// Of either.
  friend Stiffness larger(const Stiffness& a, const Stiffness& b) {
    const auto most = [](double x, double y) { return x > y ? x : y; };
    return {most(a.spring, b.spring), most(a.damping, b.damping), most(a.gyration, b.gyration)};
  }
};

/// When an effect acts: [at, until) in s. `active` is set for each step (or part of one) from its midpoint.
struct Window {
  double at = 0, until = std::numeric_limits<double>::infinity();
  bool active = true;
};

/// Which rows of a group an effect acts on: all, or one.
struct RowChoice {
  std::ptrdiff_t row = -1;  ///< in the group; negative: all

  template <class V>
  BALLPARK_INLINE bool misses(std::size_t first) const {
    const auto begin = static_cast<std::ptrdiff_t>(first);
    return row >= 0 && (row < begin || row >= begin + static_cast<std::ptrdiff_t>(lane_count<V>));
  }
  template <class V>
  BALLPARK_INLINE Vector3<V> only_here(const Vector3<V>& a, std::size_t first) const {
    if (row < 0) return a;
    const auto here = lane_numbers<V>() == V(static_cast<Real>(row - static_cast<std::ptrdiff_t>(first)));
    const V zero = V(Real(0));
    return {select(here, a.x, zero), select(here, a.y, zero), select(here, a.z, zero)};
  }
};

#ifndef BALLPARK_TARGET

inline constexpr double four_thirds_pi = 4.1887902047863905;

/// A scene's effect as its own code reads it, for one group. Parameters are checked and defaults filled in.
struct EffectInput {
  const std::map<std::string, Value>& parameters;
  double largest_speed = 0;  ///< of the group's bodies at the start, relative to what flows [m/s]
  /// Makes a per-body constant of the group from one row or one for each body.
  std::function<std::array<PerBody, 3>(const std::string& name, const std::vector<Vector3d>& rows)> per_body;
  double least_mass = 0;  ///< of the group's bodies; beside added mass, as much of what resists as is theirs [kg]
  PerBody radius = {};    ///< of the bodies, for an effect that reads it [m]
  struct Size {
    double radius, mass;  ///< the latter with added mass
  };
  std::vector<Size> sizes = {};  ///< likewise, of each body, or one if all are alike
  PerBody inverse_inertia = {};  ///< of bodies that spin, about the first axis [1/(kg m^2)]

  Real number(const std::string& name) const { return static_cast<Real>(exact(name)); }
  double exact(const std::string& name) const { return std::get<double>(parameters.at(name)); }
  const Vector3d& exact_vector(const std::string& name) const { return std::get<Vector3d>(parameters.at(name)); }
  const std::string& word(const std::string& name) const { return std::get<std::string>(parameters.at(name)); }
  const std::vector<double>& numbers(const std::string& name) const {
    return std::get<std::vector<double>>(parameters.at(name));
  }
  const std::vector<IdPair>& pairs(const std::string& name) const {
    return std::get<std::vector<IdPair>>(parameters.at(name));
  }
  Vector3<Real> vector(const std::string& name) const {
    const Vector3d& v = exact_vector(name);
    return {static_cast<Real>(v.x()), static_cast<Real>(v.y()), static_cast<Real>(v.z())};
  }
  void vectors(const std::string& name, PerBody (&out)[3]) const {
    const auto columns = per_body(name, std::get<std::vector<Vector3d>>(parameters.at(name)));
    for (int c = 0; c < 3; ++c) out[c] = columns[c];
  }
};

/// An effect without its type: what build, explain and the catalogue work with.
struct EffectInfo {
  EffectDescription description;
  std::size_t constants_size = 0;
  void (*pack)(const EffectInput&, void* constants) = nullptr;
  Real (*energy)(const void* constants, const Body<Real>&) = nullptr;    ///< null: has none
  Stiffness (*stiffness)(const EffectInput&) = nullptr;                  ///< null: sets no limit
  Window* (*window)(void* constants) = nullptr;                          ///< null: always acts
  RowChoice* (*rows)(void* constants) = nullptr;                         ///< null: acts on all rows
  Real (*added_mass)(const void* constants, std::size_t row) = nullptr;  ///< null: adds none
  bool flows = false, pushes = false;                                    ///< has a flow, a force
  bool reads_loads = false;                                              ///< of all that stand before it
  bool reads(const char* column) const { return contains(description.reads, column); }
  bool exerts(const char* load) const { return contains(description.exerts, load); }

 private:
  static bool contains(const std::vector<std::string>& words, const char* word) {
    for (const std::string& w : words) {
      if (w == word) return true;
    }
    return false;
  }
};

template <class E>
EffectInfo effect_info() {
  using Constants = typename E::Constants;
  EffectInfo info;
  info.description = E::description();
  info.constants_size = sizeof(Constants);
  info.pack = [](const EffectInput& input, void* out) { *static_cast<Constants*>(out) = E::pack(input); };
  if constexpr (requires(const Constants& c, const Body<Real>& b) { E::energy(c, b); }) {
    info.description.has_energy = true;
    info.energy = [](const void* c, const Body<Real>& b) { return E::energy(*static_cast<const Constants*>(c), b); };
  }
  if constexpr (requires(const Constants& c, const Body<Real>& b, const Acceleration<Real>& a, Loads<Real>& l) {
                  E::force_rate(c, b, a, l);
                }) {
    info.description.has_force_derivative = true;
  }
  if constexpr (requires(const Constants& c) { E::template added_mass<Real>(c, 0); }) {
    info.added_mass = [](const void* c, std::size_t row) {
      return E::template added_mass<Real>(*static_cast<const Constants*>(c), row);
    };
  }
  info.flows = requires(const Constants& c, const Body<Real>& b) {
    E::flow(c, b, 0.0);
  };
  info.pushes = requires(const Constants& c, const Body<Real>& b, Loads<Real>& l) {
    E::force(c, b, l);
  };
  info.reads_loads = requires {
    E::reads_loads;
  };
  if (info.flows) info.description.has_force_derivative = true;
  info.description.turns_velocity = requires(const Constants& c, const Body<Real>& b) {
    E::turning(c, b);
  };
  if constexpr (requires(const EffectInput& input) { E::stiffness(input); }) info.stiffness = &E::stiffness;
  if constexpr (requires(Constants & c) { c.window; }) {
    info.window = [](void* c) { return &static_cast<Constants*>(c)->window; };
  }
  if constexpr (requires(Constants & c) { c.rows; }) {
    info.rows = [](void* c) { return &static_cast<Constants*>(c)->rows; };
  }
  return info;
}

#endif

}  // namespace ballpark::BALLPARK_PRECISION
