#include "ballpark/catalogue.h"

#include "engine/core/nearest.h"
#include "engine/core/targets.h"
#include "engine/world/interface.h"

namespace ballpark {

const std::vector<EffectDescription>& effects() {
  static const std::vector<EffectDescription> all = f64::describe_effects();
  return all;
}

const std::vector<IntegratorDescription>& integrators() {
  static const std::vector<IntegratorDescription> all = f64::describe_integrators();
  return all;
}

const std::vector<NamedDescription>& shapes() {
  static const std::vector<NamedDescription> all = {{"sphere", "of bodies: a solid ball, inertia 2/5 m R^2"}};
  return all;
}

const std::vector<NamedDescription>& boundary_shapes() {
  static const std::vector<NamedDescription> all = {
      {"plane", "of boundaries: an infinite plane through a point, with bodies on the side of its normal"},
      {"box", "of boundaries: six faces along the axes, with bodies inside (faces may be left open) or outside"},
      {"tube", "of boundaries: a round surface about an axis, with bodies inside; its ends are open"},
      {"periodic", "of boundaries: no surface: space repeats after these lengths"}};
  return all;
}

const std::vector<NamedDescription>& contacts() {
  static const std::vector<NamedDescription> all = {
      {"impulse",
       "hard contact with restitution and Coulomb friction: generalised "
       "reflections, then a velocity-level solver; large "
       "steps, first order whatever the integrator"},
      {"penalty",
       "soft contact by springs and dashpots with Coulomb friction: "
       "forces in the integrator's own stages; small steps, converges "
       "with the integrator up to the kink where contacts begin and end"}};
  return all;
}

const std::vector<NamedDescription>& rotations() {
  static const std::vector<NamedDescription> all = {
      {"renormalise", "quaternion rate in the integrator's stages, normalised after each step; every integrator"},
      {"exponential",
       "the exponential map inside the stages (Munthe-Kaas): keeps the quaternion's length, exact for a steady spin; "
       "explicit Runge-Kutta and splitting integrators"},
      {"splitting",
       "free rotation between kicks by Strang splitting about the principal axes, composed to the integrator's order: "
       "exact for balls and bodies with an axis of symmetry; splitting integrators"},
      {"body",
       "angular momentum in the body's axes, for needles, whose small spins are lost in space; explicit Runge-Kutta "
       "integrators, without contacts"}};
  return all;
}

const std::vector<NamedDescription>& targets() {
  static const std::vector<NamedDescription> all = [] {
    std::vector<NamedDescription> list;
    for (const Target& target : known_targets()) list.push_back({target.name, target.doc, target.available});
    return list;
  }();
  return all;
}

std::string version() {
  return BALLPARK_VERSION;
}

}  // namespace ballpark
