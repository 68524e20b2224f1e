// Steps of implicit methods: the bodies as systems to solve, each on its own. What a body does depends on no other but
// those that pull at it, nor on how many there are.
#pragma once

#include <optional>

#include "engine/integrators/rows.h"
#include "engine/world/pair_system.h"
#include "engine/world/stage_system.h"

namespace ballpark::BALLPARK_PRECISION {

/// How iterations fared over several systems.
struct StageTally {
  std::uint64_t iterations = 0;       ///< of all
  int most = 0;                       ///< of one
  double residual = 0;                ///< the largest
  bool finite = true;                 ///< is every value of the bodies' states?
  std::optional<StageResult> failed;  ///< of the body of least id, if one has not converged
  std::size_t failed_id = 0;

  void add(const StageResult& result, std::size_t id);
  void add(const StageTally& other);
};

class ImplicitStep {
 public:
  using IdOf = FunctionRef<std::size_t(const Group&, std::size_t row)>;

  ImplicitStep(const Row& row, const std::vector<Group>& groups, const std::vector<PairSystem>& pairs,
               std::size_t block_rows, IdOf id_of);
  StageTally step(const std::vector<Group>& groups, const Method& method, Workers& workers, IdOf id_of);

 private:
  /// Bodies [first, last) of a group one after the other, but for those of other systems; or those of one system.
  struct Task {
    StageSystem system;
    std::size_t group, first, last;
    bool joined;
    StageTally tally;
  };
  void join(const std::vector<Group>& groups, const std::vector<PairSystem>& pairs, IdOf id_of);
  void run(Task& task, const std::vector<Group>& groups, const Method& method, IdOf id_of) const;

  int stages_;
  std::vector<Real> weights_;              ///< d of StageSystem
  std::vector<std::vector<bool>> joined_;  ///< of each group's rows: do others pull at it?
  std::vector<Task> tasks_;
};

}  // namespace ballpark::BALLPARK_PRECISION
