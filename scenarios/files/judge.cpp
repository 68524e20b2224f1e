#include "scenarios/files/judge.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "scenarios/files/findings.h"

namespace ballpark::scenes {

namespace {

bool is_met(const Expectation& wanted, double measured) {
  if (!std::isfinite(measured)) return false;
  if (wanted.minimum && !(measured >= *wanted.minimum)) return false;
  if (wanted.maximum && !(measured <= *wanted.maximum)) return false;
  return !wanted.value || std::abs(measured - *wanted.value) <= wanted.tolerance.value_or(0);
}

std::string wanted_text(const Expectation& wanted) {
  if (wanted.value) return fmt::format("{} within {}", *wanted.value, wanted.tolerance.value_or(0));
  if (wanted.minimum && wanted.maximum) return fmt::format("{} to {}", *wanted.minimum, *wanted.maximum);
  return wanted.minimum ? fmt::format("at least {}", *wanted.minimum)
                        : fmt::format("at most {}", wanted.maximum.value_or(0));
}

}  // namespace

Verdict judged(const Expectation& expectation, double measured, double time) {
  Verdict verdict{expectation, measured, time, is_met(expectation, measured), {}};
  std::string miss;
  if (expectation.value && std::isfinite(measured)) {
    miss = fmt::format(", off by {:.3g}", std::abs(measured - *expectation.value));
  }
  verdict.sentence = fmt::format("{} = {} at {:.9g} s, expected {}{}: {}", expectation.quantity, measured, time,
                                 wanted_text(expectation), miss, verdict.met ? "met" : "not met");
  return verdict;
}

Verdict not_reached(const Expectation& expectation) {
  Verdict verdict{
      expectation, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN(), false, {}};
  verdict.sentence =
      fmt::format("{}, expected {}: not met, the run ended before", expectation.quantity, wanted_text(expectation));
  return verdict;
}

bool is_compared(const Expectation& expectation) {
  return expectation.quantity.starts_with(stress_prefix);
}

Verdict not_compared(const Expectation& expectation) {
  Verdict verdict = not_reached(expectation);
  verdict.sentence = fmt::format("{}, expected {}: not met, only `ballpark stress` measures it", expectation.quantity,
                                 wanted_text(expectation));
  return verdict;
}

Judge::Judge(const SceneFile& file, const World& world, const RunReport& at_start) {
  const Json report = json_of(at_start);
  std::vector<LocatedProblem> problems;
  for (std::size_t i = 0; i < file.expectations.size(); ++i) {
    const Expectation& expectation = file.expectations[i];
    quantities_.emplace_back(expectation.quantity);
    verdicts_.push_back(is_compared(expectation) ? not_compared(expectation) : not_reached(expectation));
    if (is_compared(expectation)) continue;
    const std::string problem = quantities_.back().problem(world, report);
    if (problem.empty()) continue;
    const std::string path = fmt::format("expect[{}].quantity", i);
    problems.push_back({locate(file, path), path, "\"" + printable(expectation.quantity) + "\": " + problem});
  }
  if (!problems.empty()) throw SceneFileError(std::move(problems));
}

void Judge::measure(std::size_t i, const World& world, const std::function<RunReport()>& report) {
  if (is_compared(verdicts_[i].expectation)) return;
  const double measured =
      quantities_[i].reads_report() ? quantities_[i].measured(json_of(report())) : quantities_[i].measured(world);
  verdicts_[i] = judged(verdicts_[i].expectation, measured, world.time());
}

}  // namespace ballpark::scenes
