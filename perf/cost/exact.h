// Closed forms: exact motions of single bodies, which errors are held against. One file a form, one line in exact.cpp.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "ballpark/scene.h"
#include "ballpark/state.h"

namespace ballpark::cost {

/// A body and all that acts on it, as a closed form sees it. Nothing else acts: no kicks, windows or other bodies, and
/// contacts only on `TouchingBodies`.
struct LoneBody {
  const BodyGroup& group;
  std::size_t index = 0;               ///< in the group
  std::vector<const Effect*> effects;  ///< on its group
  BodyState start;                     ///< what the world holds at the start, taken as exact
  double mass = 0;                     ///< [kg]
  std::optional<Vector3d> inertia;     ///< principal moments [kg m^2]; none for a particle
};

/// State at a time [s] from the start.
template <class R>
struct ExactState {
  std::array<R, 3> position{}, velocity{};
  std::array<R, 4> orientation{1, 0, 0, 0};  ///< w, x, y, z, of either sign; identity if the body carries none
  std::array<R, 3> angular_velocity{};       ///< world frame
};

/// The same formulas in two precisions: their difference tells the rounding of either.
struct ExactMotion {
  std::string what;  ///< the form and its source
  std::function<ExactState<double>(double)> in_double;
  std::function<ExactState<long double>(long double)> in_extended;
};

/// nullopt if the form is not this body's.
using ClosedForm = std::optional<ExactMotion>(const LoneBody&);
ClosedForm ballistic, vertical_drag, oscillator, kepler, pendulum, torque_free, symmetric_top, constant_spin_lift,
    charged_particle, foucault;

/// The first form that fits.
std::optional<ExactMotion> exact_motion(const LoneBody& body);

/// All bodies of a scene with contacts, by id.
struct TouchingBodies {
  const Scene& scene;
  std::vector<LoneBody> bodies;
};

/// nullopt if the form is not this body's.
using ContactForm = std::optional<ExactMotion>(const TouchingBodies&, std::size_t id);
ContactForm bouncing_ball;

/// The first form that fits.
std::optional<ExactMotion> exact_motion(const TouchingBodies& all, std::size_t id);

/// A parameter of an effect, or the catalogue's default. Not a number if it has neither, which a checked scene
/// excludes.
double number(const Effect& effect, const std::string& parameter);
/// Empty if it has neither.
std::string word(const Effect& effect, const std::string& parameter);
/// The row of body `index`, where it may be one for all or one for each.
Vector3d vector(const Effect& effect, const std::string& parameter, std::size_t index = 0);

}  // namespace ballpark::cost
