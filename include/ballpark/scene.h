// What to simulate, as a plain value. Units are SI, axes right-handed with z up, quaternions map body to world.
// Nothing here computes: `World` (world.h) checks the values and runs them.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

namespace ballpark {

using Eigen::Vector3d;

/// Rotation (w, x, y, z), body to world, unit length. Plain doubles: its alignment never depends on compiler flags.
struct Quaternion {
  double w = 1, x = 0, y = 0, z = 0;
};

/// Arithmetic of a run. `extended` is long double on the base target: for references, slow.
enum class Precision { single_, double_, extended };

/// Fills a group's rows at build. Deterministic: row i of copy k depends on (seed + k, group, i) alone.
struct Generate {
  /// "lattice": count rows, x fastest; "random": uniform in the box [lower, upper]; "rack": a triangle in a plane of
  /// constant z, row k of k bodies along y, rows along x; "plummer": a cluster of stars about the origin, the inner 99
  /// % of its mass (Aarseth, Henon and Wielen 1974)
  std::string kind = {};
  std::vector<std::size_t> count = {};  ///< lattice: [nx, ny, nz]; random, plummer: [n]; rack: [rows]
  Vector3d origin = Vector3d::Zero();   ///< lattice, rack: position of the first body; plummer: centre [m]
  double spacing = 0;                   ///< lattice, rack: distance between neighbours [m], > 0
  Vector3d lower = Vector3d::Zero();    ///< random: lowest corner [m]
  Vector3d upper = Vector3d::Zero();    ///< random: highest corner [m]
  double scale = 0;                     ///< plummer: a, of a density as (1 + r^2 / a^2)^(-5/2) [m], > 0
  double strength =
      0;  ///< plummer: G times the mass of all, with which velocities are in balance; 0: at rest [m^3/s^2]
  Vector3d velocity_spread = Vector3d::Zero();  ///< adds a uniform value in [-s, s] to each velocity component [m/s]
  Vector3d angular_velocity_spread = Vector3d::Zero();  ///< likewise for the angular velocity [rad/s]
  bool random_orientation = false;                      ///< orientations uniform over all rotations
};

/// Bodies of one kind. Each list has no row (default), one row (all bodies alike) or n rows; n is the longest list.
struct BodyGroup {
  std::string name = {};             ///< unique; how `--set` and effects address the group
  std::string shape = {};            ///< "" for particles or bodies with a given inertia; "sphere"
  std::string material = {};         ///< a name of `Scene::materials`; none: restitution 1, friction 0
  std::vector<double> radius = {};   ///< [m], > 0; needed by a shape
  std::vector<double> mass = {};     ///< [kg], > 0; or density
  std::vector<double> density = {};  ///< [kg/m^3], > 0, with a shape
  std::vector<Vector3d> inertia =
      {};  ///< principal moments about the centre of mass [kg m^2]; each at most the sum of the others
  std::vector<Vector3d> position = {};           ///< centre of mass, world frame [m]
  std::vector<Vector3d> velocity = {};           ///< world frame [m/s]
  std::vector<Vector3d> angular_velocity = {};   ///< [rad/s], in `angular_velocity_frame`
  std::string angular_velocity_frame = "world";  ///< "world" or "body"
  std::vector<Quaternion> orientation = {};      ///< unit to 1e-6 (then normalised); identity if none
  std::optional<Generate> generate = {};         ///< positions and spreads, instead of a `position` list
};

/// Two bodies by their ids in one copy of the scene.
using IdPair = std::array<std::size_t, 2>;

/// A parameter of an effect: a number, a vector, one vector per body, a word, one number per pair, or pairs.
using Value =
    std::variant<double, Vector3d, std::vector<Vector3d>, std::string, std::vector<double>, std::vector<IdPair>>;

/// One effect on some groups. Kinds and their parameters: `effects()` in catalogue.h.
struct Effect {
  std::string kind = {};
  std::vector<std::string> groups = {};          ///< names; all groups if empty
  std::map<std::string, Value> parameters = {};  ///< what is left out takes the catalogue's default
};

/// A sudden change of momentum of one body.
struct Impulse {
  double at = 0;  ///< [s]; the step that holds this time is split there
  std::size_t id = 0;
  Vector3d J = Vector3d::Zero();       ///< [N s], world frame
  Vector3d offset = Vector3d::Zero();  ///< point of application minus centre of mass [m], world axes
};

/// What two surfaces do when they touch. Of two different materials: the geometric mean of each value, unless a
/// `MaterialPair` says otherwise.
struct Material {
  double restitution = 1;  ///< e in [0, 1]: speed of parting over speed of approach, along the normal
  double friction = 0;     ///< Coulomb's mu >= 0
  /// Impulse contacts: the speed of approach v0 at which e is that, where it depends on speed v: slower impacts are
  /// more elastic, 1 - (1 - e) (v / v0)^(1/5), faster ones less, e (v0 / v)^(1/4); 0: e at every speed [m/s]. (McNamara
  /// and Falcon 2005, Phys. Rev. E 71, 031302)
  double restitution_speed = 0;
  /// Penalty contacts: work of adhesion w; surfaces that touch pull with 2 pi w R1 R2 / (R1 + R2), a wall's R infinite,
  /// and friction grows with what presses them so. [J/m^2] (Derjaguin, Muller and Toporov 1975)
  double cohesion = 0;
};

/// The law of two materials, instead of their mean.
struct MaterialPair {
  std::vector<std::string> between = {};  ///< two names of materials
  double restitution = 1;
  double friction = 0;
  double restitution_speed = 0;  ///< [m/s]
  double cohesion = 0;           ///< [J/m^2]
};

/// Displacement of a boundary: V t + A (sin(2 pi f t + phase) - sin(phase)).
struct Motion {
  Vector3d velocity = Vector3d::Zero();   ///< V [m/s]
  Vector3d amplitude = Vector3d::Zero();  ///< A [m]
  double frequency = 0;                   ///< f [Hz]
  double phase = 0;                       ///< [rad]
};

/// What bodies bounce off or lie on, of infinite mass. Shapes: `boundary_shapes()` in catalogue.h.
struct Boundary {
  std::string name = {};               ///< how `--set` addresses it; may be empty
  std::string shape = {};              ///< "plane", "box", "tube", "periodic"
  Vector3d point = Vector3d::Zero();   ///< plane: on it; tube: on its axis; box, periodic: centre [m]
  Vector3d normal = {0, 0, 1};         ///< plane: towards the bodies; tube: along its axis. Of any length > 0
  Vector3d size = Vector3d::Zero();    ///< box: its edges; periodic: lengths after which space repeats, 0: open [m]
  double radius = 0;                   ///< tube, whose ends are open [m]
  std::string side = "inside";         ///< box: where the bodies are, "inside" or "outside"
  std::vector<std::string> open = {};  ///< box from inside: faces left out, of "-x", "+x", "-y", "+y", "-z", "+z"
  std::string material = {};
  std::optional<Motion> motion = {};
  Vector3d surface_velocity = Vector3d::Zero();  ///< of a conveyor: how the surface runs over the boundary [m/s]
};

/// How bodies with a shape touch.
struct ContactSettings {
  std::string kind = {};     ///< "": they do not; else a name of `contacts()`
  int substeps = 1;          ///< of a step, each with its own contact solve
  int iterations = 12;       ///< Gauss-Seidel sweeps over all contacts that keep surfaces apart
  int relax_iterations = 3;  ///< and that settle velocities
  double margin = 0.2;  ///< contacts: surfaces that will pass each other at less than this share of both radii together
  double restitution_threshold = 0;  ///< slower approaches end at restitution 0 [m/s]
  // Of `penalty`, which takes no other of these than the margin, the skin of its list of neighbours:
  double stiffness = 0;                   ///< of the spring along the normal [N/m], > 0
  double tangential_stiffness = 2.0 / 7;  ///< of the spring across it, over `stiffness`
  bool pull = false;                      ///< may the dashpot hold parting surfaces together?
};

struct RunSettings {
  double duration = 0;          ///< [s], >= 0
  double step = 0;              ///< [s], > 0; or a tolerance, and no step
  bool automatic_step = false;  ///< and no step: see automatic_step() in world.h
  /// Of an embedded pair: error of a step over the size of each body's position, velocity, spin and orientation
  double tolerance = 0;
  double absolute_tolerance = 0;   ///< beside which, where those are small [m, m/s, rad/s, rad]; 0: as `tolerance`
  std::string integrator = "rk4";  ///< a name of `integrators()`
  std::string rotation = "renormalise";  ///< how orientations follow from spins: a name of `rotations()`
  std::vector<std::string> accept = {};  ///< limits that may be exceeded: "stability", "accuracy"; still reported
  bool compensated = false;  ///< compensated summation of the state: long runs lose less to rounding, for a column more
  Precision precision = Precision::double_;
  std::uint64_t seed = 1;
};

struct Scene {
  std::string name = {};
  std::string doc = {};
  RunSettings run;
  std::vector<BodyGroup> bodies = {};
  std::vector<Effect> effects = {};
  std::vector<Impulse> impulses = {};
  std::map<std::string, Material> materials = {};
  std::vector<MaterialPair> material_pairs = {};
  std::vector<Boundary> boundaries = {};
  ContactSettings contact;
};

/// One thing wrong with a scene: `path` names the value ("bodies[0].mass", "run.step"), `message` says what it is,
/// what was expected and the nearest valid choice.
struct Problem {
  std::string path = {};
  std::string message = {};
};

/// Thrown by `World`'s constructor and by misuse of its calls, never out of a step. Holds every problem found.
class SceneError : public std::runtime_error {
 public:
  explicit SceneError(std::vector<Problem> problems);
  SceneError(const std::string& path, const std::string& message);
  const std::vector<Problem>& problems() const { return problems_; }

 private:
  std::vector<Problem> problems_;
};

/// Every problem of the scene's values; empty if `World` will accept it. Cheap next to building it.
std::vector<Problem> check(const Scene& scene);

}  // namespace ballpark
