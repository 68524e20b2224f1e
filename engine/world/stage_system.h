// The stages of one implicit step: of a body that nothing else acts on, or of bodies that pull at each other.
//   z_i = sum_j h a_ij f(y + z_j),  y' = y + sum_i d_i z_i,  d = A^-T b  (Hairer & Wanner, Solving ODEs II, IV.8)
// by Newton's method, with the derivatives of f at every stage and renewed in every iteration.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "engine/effects/pair_effect.h"
#include "engine/integrators/method.h"
#include "engine/world/linear_solver.h"
#include "engine/world/motion_calls.h"

namespace ballpark::BALLPARK_PRECISION {

struct Group;

inline constexpr int max_stages = 3;  ///< of implicit methods

/// How an iteration for the stages fared.
struct StageResult {
  int iterations = 0;
  Real residual = 0;  ///< its last change of the stages, relative to the terms that make them up
  bool converged = false;
};

class StageSystem {
 public:
  struct Member {
    std::size_t group, row;
  };
  /// Between the members a and b.
  struct Bond {
    const PairEffect* effect;
    std::size_t copy;
    Link link;
    std::uint32_t a, b;
  };

  StageSystem(const std::vector<Group>& groups, std::vector<Member> members, std::vector<Bond> bonds, int stages);

  /// The same system for another body of the group: of a system of one.
  void look_at(std::size_t row) { bodies_[0].member.row = row; }
  /// Solves for the stages.
  StageResult solve(const std::vector<Group>& groups, const Method& method);
  /// Then moves the bodies: is every value finite? `weights`: d.
  bool move(const Real* weights);

 private:
  struct StageBody {
    Member member;
    MotionKind motion;
    const StepGroup* group;
    const MotionCalls* calls;
    int first;        ///< unknown: z_i of this body begin at first + i size
    int entries = 0;  ///< of each of its columns in the matrix
    Real y[max_state_size], unit[max_state_size];
    std::unique_ptr<BodyRates[]> at;  ///< by stage
    Real place[6];
    Vector3<Real> pull;

    int size() const { return calls->size; }
  };
  /// What a bond tells of one stage, and where its parts of the matrix begin: rows of a or b by columns of a or b.
  struct StageBond {
    Bond bond;
    LinkForce force[max_stages];
    std::size_t begin[2][2];
  };

  void arrange(const std::vector<Group>& groups);
  void begin_step(const std::vector<Group>& groups, const Method& method);
  Real improve(const Method& method);
  void find_rates(int stage, double after);
  void pull_at(int stage);
  void assemble(const Method& method);
  void add_bond(const Method& method, const StageBond& bond);
  void find_right_side(const Method& method);
  void find_scales();
  Real change_stages();
  void stage_of(const StageBody& body, int stage, Real* y) const;

  int stages_;
  std::vector<StageBody> bodies_;
  std::vector<StageBond> bonds_;
  std::vector<int> starts_, rows_;  ///< of the matrix
  std::vector<std::size_t> own_;    ///< where each body's own part of it begins
  LinearSolver solver_;
  std::vector<Real> z_, right_, scale_;
};

}  // namespace ballpark::BALLPARK_PRECISION
