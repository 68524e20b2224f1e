// What this build of Ballpark can do: each list describes itself, and help texts, checks and schemas come from it.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "ballpark/scene.h"

namespace ballpark {

/// number: double. vector: Vector3d. vectors: one Vector3d, or one per body of the group. word: one of `choices`.
/// pairs: a list of two ids each. numbers: one double, or one per pair.
enum class ParameterKind { number, vector, vectors, word, numbers, pairs };

struct ParameterInfo {
  std::string name;
  ParameterKind kind = ParameterKind::number;
  std::string unit;
  std::optional<Value> fallback;                              ///< the default; none: must be given
  double minimum = -std::numeric_limits<double>::infinity();  ///< number and numbers only, inclusive
  double maximum = std::numeric_limits<double>::infinity();
  std::vector<std::string> choices = {};  ///< word only: what it may be
  std::string doc;
};

struct EffectDescription {
  std::string name;
  std::string doc;  ///< one sentence with the formula
  std::string source;
  std::vector<ParameterInfo> parameters;
  std::vector<std::string> reads;  ///< columns beside mass that the force needs
  std::vector<std::string>
      exerts;  ///< "force", "torque", "constraint", "flow" of a fluid, "inertia"; what it sets between steps
  bool has_energy = false;
  bool has_force_derivative = false;  ///< usable with taylor2
  bool turns_velocity = false;        ///< reads velocity only to turn it, at a rate that it tells: usable with boris
  int flops = 0;                      ///< per evaluation and body (between bodies: and pair)
  bool between_bodies = false;        ///< takes the staged path
  bool between_steps = false;         ///< exerts no force: changes bodies at once when a step has ended
};

struct IntegratorDescription {
  std::string name;
  std::string doc;
  std::string source;
  std::string family;
  int order = 0;
  int evaluations = 0;          ///< of all forces, per step (implicit: per iteration)
  bool adaptive = false;        ///< has an embedded estimate of its error: takes run.tolerance in place of run.step
  int start_steps = 0;          ///< multistep: first steps, which rk4 takes
  bool symplectic = false;      ///< for forces that do not read velocity
  bool turns_velocity = false;  ///< takes forces that read velocity only to turn it, and keeps the speed in them
  double real_limit = 0;        ///< stability: h |lambda| for y' = lambda y, lambda < 0; 0: takes no such force;
                                ///< infinite (null in JSON): at any step
  double imaginary_limit = 0;   ///< stability: h omega for x'' = -omega^2 x; 0: always grows
  bool implicit = false;        ///< solves for its stages, with the forces' derivatives if they have them
};

struct NamedDescription {
  std::string name;
  std::string doc;
  bool available = true;  ///< targets: this machine can run it
};

const std::vector<EffectDescription>& effects();
const std::vector<IntegratorDescription>& integrators();
const std::vector<NamedDescription>& shapes();
const std::vector<NamedDescription>& boundary_shapes();
const std::vector<NamedDescription>& contacts();  ///< contact formulations
const std::vector<NamedDescription>& rotations();
const std::vector<NamedDescription>& targets();  ///< instruction sets, slowest first

std::string version();

/// The entry of `names` that `word` most likely meant, or "" if none is near.
std::string nearest(const std::string& word, const std::vector<std::string>& names);

}  // namespace ballpark
