// Contacts of a world: state columns to slots and back, around the solver's substeps.
#pragma once

#include "ballpark/report.h"
#include "engine/contact/impulse_solver.h"
#include "engine/world/kernel_table.h"

namespace ballpark::BALLPARK_PRECISION {

struct Group;

/// Rows [first_row, first_row + count) of a group are the slots from first_slot on: some of one copy's bodies.
struct SlotRange {
  std::size_t group = 0, first_row = 0, first_slot = 0, count = 0;
};

class ContactStep {
 public:
  ImpulseSolver solver;
  std::vector<SlotRange> ranges;
  int substeps = 1;
  double lower[3] = {};  ///< corner of the periodic box [m]

  /// The state at the start of a substep, and what smooth motion has made of it.
  void read_start(const std::vector<Group>& groups, Workers& workers);
  void read_trial(const std::vector<Group>& groups, Workers& workers);
  /// Adds the passes around those of smooth motion, and what contacts there are.
  void explain(const std::vector<Group>& groups, Explanation& all) const;
  ContactReport report;  ///< what does not change after build
  /// Counters of the contact passes: into those of the run, and back.
  void add_counters(Counters& all) const;
  void set_counters(const Counters& all);
  /// Bodies whose centre has passed a wall.
  std::size_t count_outside(const std::vector<Group>& groups, double time) const;
  /// What contacts have made of the trial.
  void write(const std::vector<Group>& groups, Workers& workers) const;

 private:
  void read(const std::vector<Group>& groups, Workers& workers, VectorColumn& position, VectorColumn& velocity,
            VectorColumn& surface);
  template <class Act>
  void for_ranges(const std::vector<Group>& groups, Workers& workers, Act act) const;
};

}  // namespace ballpark::BALLPARK_PRECISION
