// Contacts of a world: state columns to slots and back, around what a formulation does with the slots.
#pragma once

#include "ballpark/report.h"
#include "engine/contact/impulse_solver.h"
#include "engine/contact/penalty.h"
#include "engine/world/kernel_table.h"
#include "engine/world/slots.h"

namespace ballpark::BALLPARK_PRECISION {

/// What all formulations have.
class ContactStep {
 public:
  std::vector<SlotRange> ranges;
  double lower[3] = {};  ///< corner of the periodic box [m]
  ContactReport report;  ///< what does not change after build

  virtual ~ContactStep() = default;
  virtual ContactScene& scene() = 0;
  virtual const ContactScene& scene() const = 0;
  /// Counters of the contact passes: into those of the run, and back.
  virtual void add_counters(Counters& all) const = 0;
  virtual void set_counters(const Counters& all) = 0;
  /// What the next step needs of the last one beside the bodies' state; false if the bytes do not fit this scene.
  virtual std::vector<std::byte> save() const = 0;
  virtual bool restore(const std::vector<std::byte>& bytes) = 0;
  /// Adds the passes around those of smooth motion, and what contacts there are.
  virtual void explain(const std::vector<Group>& groups, Explanation& all) const = 0;
  bool holds(std::size_t group) const;
  /// What contacts do to each body that may touch, in the order of ids.
  virtual std::vector<BodyLoad> loads(const std::vector<Group>& groups, double time, Workers& workers) = 0;
  /// Bodies whose centre has passed a wall.
  std::size_t count_outside(const std::vector<Group>& groups, double time) const;

 protected:
  /// Calls act(group, row, slot, surface speed per angular momentum) for all bodies that may touch.
  template <class Act>
  void for_bodies(const std::vector<Group>& groups, Workers& workers, Act act) const;
  /// The columns as they are now, into these of the slots.
  void read(const std::vector<Group>& groups, StateColumns StepGroup::*columns, Workers& workers,
            VectorColumn& position, VectorColumn& velocity, VectorColumn& surface) const;
  /// Into the periodic box.
  Vector3<Real> wrapped(const Vector3<Real>& x) const;
};

/// `impulse`: what contacts make of each substep's trial.
class ImpulseStep : public ContactStep {
 public:
  ImpulseSolver solver;
  int substeps = 1;

  ContactScene& scene() override { return solver; }
  const ContactScene& scene() const override { return solver; }
  void add_counters(Counters& all) const override;
  void set_counters(const Counters& all) override;
  std::vector<std::byte> save() const override { return solver.save(); }
  bool restore(const std::vector<std::byte>& bytes) override { return solver.restore(bytes); }
  void explain(const std::vector<Group>& groups, Explanation& all) const override;
  std::vector<BodyLoad> loads(const std::vector<Group>&, double, Workers&) override { return solver.loads(); }

  /// The state at the start of a substep, and what smooth motion has made of it.
  void read_start(const std::vector<Group>& groups, Workers& workers);
  void read_trial(const std::vector<Group>& groups, Workers& workers);
  /// What contacts have made of the trial.
  void write(const std::vector<Group>& groups, Workers& workers) const;
};

/// `penalty`: forces in every phase of the integrator.
class PenaltyStep : public ContactStep {
 public:
  Penalty penalty;
  int phases = 1;  ///< of the integrator

  ContactScene& scene() override { return penalty; }
  const ContactScene& scene() const override { return penalty; }
  void add_counters(Counters& all) const override;
  void set_counters(const Counters& all) override;
  std::vector<std::byte> save() const override { return penalty.save(); }
  bool restore(const std::vector<std::byte>& bytes) override { return penalty.restore(bytes); }
  void explain(const std::vector<Group>& groups, Explanation& all) const override;
  std::vector<BodyLoad> loads(const std::vector<Group>& groups, double time, Workers& workers) override;

  /// Neighbours of the bodies as they stand, for one evaluation that take_back() undoes.
  void look(const std::vector<Group>& groups, double time, Workers& workers) { begin(groups, time, 0, workers); }
  /// Neighbours for a step of length h.
  void begin(const std::vector<Group>& groups, double time, Real h, Workers& workers);
  /// Adds the forces on the trial state to the sums of the groups.
  void add_forces(const std::vector<Group>& groups, const Method& method, int phase, double time, Workers& workers);
  /// After the step: springs moved, bodies back in the periodic box.
  void finish(const std::vector<Group>& groups, const Method& method, Workers& workers);
  double energy(const std::vector<Group>& groups, double time, Workers& workers);
  /// Of the forces in the state [W], but for what the energy keeps, unless they depend on what was.
  double power(const std::vector<Group>& groups, double time, Workers& workers);
  bool remembers() const { return penalty.bodies.spins; }  ///< friction: how far surfaces have slid
  /// How far the try of length h took a body, or would have at its speed, in radii: the most of all. A wall likewise,
  /// in radii of the smallest body.
  Real stride(const std::vector<Group>& groups, Real h, Workers& workers);

 private:
  void read_state(const std::vector<Group>& groups, StateColumns StepGroup::*columns, Workers& workers);
  void drift(const std::vector<Group>& groups, Real h, Workers& workers);

  std::vector<Real> strides_;  ///< by slot
};

}  // namespace ballpark::BALLPARK_PRECISION
