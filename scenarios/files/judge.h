// The expectations of a scene file, measured while it runs.
#pragma once

#include <functional>
#include <vector>

#include "scenarios/files/quantity.h"

namespace ballpark::scenes {

/// One verdict: within [min, max], or within tolerance of value. What is not finite is never met.
Verdict judged(const Expectation& expectation, double measured, double time);
/// For a run that ended before the expectation's time.
Verdict not_reached(const Expectation& expectation);

/// Does it take more than one run? Its quantity has a name of its own then.
inline constexpr const char* stress_prefix = "stress.";
bool is_compared(const Expectation& expectation);
Verdict not_compared(const Expectation& expectation);

class Judge {
 public:
  /// Throws SceneFileError if a quantity does not exist.
  Judge(const SceneFile& file, const World& world, const RunReport& at_start);

  /// Measures expectation i now; `report` makes the report of this moment, if it is needed.
  void measure(std::size_t i, const World& world, const std::function<RunReport()>& report);
  std::vector<Verdict> verdicts() const { return verdicts_; }

 private:
  std::vector<Quantity> quantities_;
  std::vector<Verdict> verdicts_;
};

}  // namespace ballpark::scenes
