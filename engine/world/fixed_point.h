// Stages of implicit methods whose forces give no derivatives: rates of all stages are found again and again, each time
// where the last ones put the stages, until these no longer change. (Hairer, Lubich & Wanner, Geometric Numerical
// Integration, VIII.6.2.) To kernels and forces it is an explicit method of 2 s phases:
//   0, ..., s - 1       at the state itself: the first iteration
//   s, ..., 2 s - 1     at y + sum_j h a_ij k_j by sets 0, ..., s - 1, whose place their rates then take: the others
#pragma once

#include <limits>
#include <vector>

#include "engine/effects/effect_info.h"
#include "engine/world/implicit_step.h"

namespace ballpark::BALLPARK_PRECISION {

struct Block;
struct Part;

class FixedPoint {
 public:
  /// An iteration may leave no more than this of the stages' error: what is nearer to 1 takes hundreds of them, and
  /// forces that are not linear may be stiffer where the bodies go.
  static constexpr double most_left = 0.8;
  /// The largest step at which an oscillation is iterated so [s]: infinity if nothing swings or decays.
  static double largest_step(const Row& row, const Stiffness& per_mass);
  /// The implicit method as phases of an explicit one.
  static Method phases_of(const Method& implicit);

  /// `coupled`: bodies of a copy act on each other, and go on until all of them have converged; else each on its own.
  FixedPoint(const std::vector<Group>& groups, std::size_t copies, bool coupled);
  void begin(const std::vector<Group>& groups, const Part& part);
  /// After phases s, ..., 2 s - 1 of some rows: their change, and their rates into sets 0, ..., s - 1.
  void compare(const Group& group, const Block& block, const Method& method);
  /// After all rows of the part: have all its bodies converged, or failed to?
  bool judge(const std::vector<Group>& groups, const Part& part);
  StageTally tally(const std::vector<Group>& groups, ImplicitStep::IdOf id_of) const;

 private:
  /// Bodies that go on together: a body, or a copy of the scene. Once done, their rates stay.
  struct Unit {
    StageResult result{.iterations = 1};
    Real change = 0;                                     ///< the most of its bodies, in this iteration
    Real least = std::numeric_limits<Real>::infinity();  ///< of all so far
    int stalled = 0;                                     ///< iterations since then
    std::size_t row = 0;                                 ///< that changed most, of the world's
    bool done = false;
  };
  std::size_t unit_of(const Group& group, std::size_t row) const;
  template <class Act>
  void for_rows(const std::vector<Group>& groups, const Part& part, Act act);
  template <class Act>
  void for_units(const std::vector<Group>& groups, const Part& part, Act act);
  static void judge(Unit& unit);

  bool coupled_;
  std::vector<Unit> units_;
  std::vector<Real> changes_;  ///< by row of the world
};

}  // namespace ballpark::BALLPARK_PRECISION
