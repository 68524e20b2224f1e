// What a world says of itself: status, conserved quantities, structure, cost. Plain values, all in double and SI.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "ballpark/scene.h"

namespace ballpark {

/// How a run stands: the gravest thing that went wrong, when it first did. The sentence names the lesser ones before
/// it.
struct Status {
  enum class Code { ok, full, stability, accuracy, unconverged, non_finite };
  Code code = Code::ok;
  std::string sentence = "ok";
  std::size_t body = 0;  ///< id of the first offender, where there is one
  std::uint64_t step = 0;
  double time = 0;  ///< [s]
};
const char* name(Status::Code code);

struct Counters {
  std::uint64_t steps = 0;
  std::uint64_t rejected_steps = 0;                 ///< tried with a tolerance, and taken back
  std::uint64_t force_evaluations = 0;              ///< of all forces (not per body; implicit: the most of any body)
  std::uint64_t pairs = 0;                          ///< candidates of the broad phase, over all steps
  std::uint64_t contacts = 0;                       ///< contacts that bore a load, over all substeps
  std::uint64_t peak_pairs = 0, peak_contacts = 0;  ///< the most at one time
  std::uint64_t impacts = 0;                        ///< contacts that were reflected
  std::uint64_t impact_rounds = 0;                  ///< generalised reflections of one substep, the most
  std::uint64_t unfinished_impacts = 0;             ///< left to the solver, without restitution, after the last round
  std::uint64_t held_back = 0;  ///< motions cut short so that no contact is missed: those bodies lag behind
  std::uint64_t missed = 0;     ///< impulse: substeps in which an overlap could not be prevented; penalty: body-steps
                                ///< longer than the radius, beside a neighbour
  int colours = 0;              ///< of the contact graph, the most
  double max_penetration = 0;   ///< deepest overlap at the start of a substep [m]
  std::uint64_t neighbour_lists = 0;  ///< penalty: how often neighbours were searched anew
  /// penalty: stiffness and damping per mass of the contact network, bounds, the most of the run [1/s^2, 1/s]
  double contact_spring = 0, contact_damping = 0;
  double residual = 0;  ///< largest error in a normal speed that the last sweep of the run so far found [m/s]
  /// implicit: iterations of Newton's method, or fixed-point ones, over all bodies (sets of bodies that are solved for
  /// together); and the largest last change of a state by them, relative to the state
  std::uint64_t newton_iterations = 0;
  double newton_residual = 0;
  std::uint64_t entered = 0, left = 0;  ///< bodies: through emitters after the start; through outlets and walls
};

/// Sums over all bodies, in double whatever the world's precision.
struct Totals {
  double kinetic = 0;                            ///< [J]
  double potential = 0;                          ///< [J], of the effects that have one
  Vector3d momentum = Vector3d::Zero();          ///< [kg m/s]
  double momentum_scale = 0;                     ///< sum of |p| [kg m/s]
  Vector3d angular_momentum = Vector3d::Zero();  ///< about the origin [kg m^2/s]
  double angular_momentum_scale = 0;             ///< sum of |l| over bodies
  std::size_t non_finite_bodies = 0;             ///< left out of the sums
  std::size_t absent_bodies = 0;                 ///< likewise: not entered yet, or gone
  std::size_t bodies_outside = 0;                ///< centres beyond a boundary that should keep them
  double energy() const { return kinetic + potential; }
};

/// What one cause did to the kinetic energy.
struct LedgerLine {
  std::string name;               ///< of the effect; "contacts"; "from outside": impulses, and what set() changed
  double work = 0;                ///< [J]
  bool has_energy = false;        ///< does it keep what it takes, as potential energy?
  double initial = 0, final = 0;  ///< that energy [J]
  /// What it took for good (negative) or brought in [J].
  double gain() const { return work + final - initial; }
};

/// Where the energy went since the ledger was opened. Work is force times velocity (and torque times angular velocity),
/// integrated for itself between the steps' ends; where an effect has an energy, what that lost, and the integral of
/// the rest of the force. What is left of the change of the kinetic energy is the error of the integrator.
struct Ledger {
  struct Kinetic {
    double translation = 0, rotation = 0;  ///< [J]; translation with that of the fluid that moves along (added_mass)
    double sum() const { return translation + rotation; }
  };
  double from = 0, to = 0;  ///< [s]
  Kinetic initial, final;
  std::vector<LedgerLine> lines;
  double work() const {
    double sum = 0;
    for (const LedgerLine& line : lines) sum += line.work;
    return sum;
  }
  double integrator_error() const { return final.sum() - initial.sum() - work(); }  ///< [J]
};

struct ColumnReport {
  std::string name, unit, role, group;  ///< role: state | kept | rate | sum | constant
  int components = 1;
  double bytes_per_body = 0;
  std::string why;  ///< who asked for it
};

struct PassReport {
  std::string name, group;
  std::vector<std::string> reads, writes;
  double bytes_per_body = 0;  ///< moved in one call of the pass [B]
  double flops_per_body = 0;  ///< of one call (a square root or a division counts as one)
  int calls_per_step = 1;
  std::string why;
};

struct GroupReport {
  std::string name, motion;  ///< motion: point | spinning | oriented | rigid | pivoted
  std::size_t bodies = 0;
  std::string why;
  std::vector<std::string> effects;
  std::vector<std::string> constants;  ///< "mass = 0.17 kg": equal over the group, no column
};

/// Contacts of a scene. `kind` is "" if bodies do not touch.
struct ContactReport {
  std::string kind;
  int substeps = 0, iterations = 0, relax_iterations = 0;
  double margin = 0;                            ///< over the radii
  std::size_t bodies = 0;                       ///< that may touch
  std::size_t walls = 0;                        ///< faces of boundaries
  bool friction = false;                        ///< some pair of materials has it
  std::vector<std::string> laws;                ///< "ball on cloth: restitution 0.5, friction 0.2"
  double stiffness = 0, sliding_stiffness = 0;  ///< penalty [N/m]
  bool pull = false;                            ///< penalty: may dashpots pull?
  double largest_step = 0;  ///< penalty: stable for the contacts so far, at least for two bodies [s]; 0: none is
  std::size_t bytes = 0;    ///< of grid, pairs and contacts as they are now [B]
};

/// The largest step at which a stiff force is stable [s]; 0: it grows at every step.
struct StepLimitReport {
  std::string of;  ///< "group balls", "bonds"
  double largest = 0;
};

/// What exists for a scene, and why: what `ballpark explain` prints.
struct Explanation {
  std::string path;  ///< "fused", "staged" or "implicit"
  std::string path_reason;
  std::string integrator, precision, target;
  std::string stages;    ///< how an implicit integrator solves for them; "" if it is explicit
  std::string rotation;  ///< how orientations follow from spins; "" if none changes
  int threads = 1;
  std::size_t block_length = 0;  ///< bodies per task
  std::vector<GroupReport> groups;
  std::vector<ColumnReport> columns;
  std::vector<PassReport> passes;     ///< in the order of the step
  std::vector<std::string> narrowed;  ///< what the scene could have had and does not need
  std::vector<std::string> off;       ///< what does not exist here
  double bytes_per_body_step = 0;     ///< mean over bodies
  double flops_per_body_step = 0;
  std::size_t column_bytes = 0;  ///< allocated in all [B]
  ContactReport contact;
  std::vector<StepLimitReport> step_limits;  ///< of springs, dampers and what turns velocities
};

/// Time spent in one pass since profiling was switched on.
struct PassTime {
  std::string name;
  std::uint64_t calls = 0;
  double seconds = 0;
  double bytes = 0;  ///< moved, by the pass's own account [B]
};

}  // namespace ballpark
