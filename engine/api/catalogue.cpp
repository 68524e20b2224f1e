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
  static const std::vector<NamedDescription> all = {{"sphere", "a solid ball: inertia 2/5 m R^2"}};
  return all;
}

const std::vector<NamedDescription>& rotations() {
  static const std::vector<NamedDescription> all = {
      {"renormalise", "quaternion rate in the integrator's stages, normalised after each step"}};
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
