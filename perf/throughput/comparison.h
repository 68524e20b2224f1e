// Subjects timed side by side, what their times must be to each other, and that they computed the same.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "perf/throughput/subject.h"
#include "perf/timing.h"

namespace ballpark::perf {

/// What a ratio should be: at most (or at least) `limit`; `aim` is what one would like.
struct Bar {
  bool at_most = true;
  double limit = 0;
  std::optional<double> aim;
};

/// Product of the times of `over` divided by that of `under`: names of subjects.
struct Ratio {
  std::string name;
  std::vector<std::string> over, under;
  std::optional<Bar> bar;
};

/// Two subjects end in the same state, up to `tolerance` of each column's largest value; 0: in every bit.
struct Agreement {
  std::string a, b;
  double tolerance = 0;
};

struct Comparison {
  std::string title, note;
  std::vector<Subject> subjects;
  std::vector<Ratio> ratios;
  std::vector<Agreement> agreements;
  bool by_size = false;  ///< the same subjects at several numbers of bodies
  std::string base;      ///< if not empty: show what the other subjects take more than this one
};

struct Row {
  std::string name;
  std::size_t bodies;
  double units, bytes_per_unit;
  Samples samples;
  double nanoseconds(double seconds) const { return 1e9 * seconds / units; }  ///< per body-step
};

struct RatioResult {
  Ratio ratio;
  double of_minima, of_medians;
  bool met;  ///< judged on the minima, which other programs disturb least
};

struct AgreementResult {
  Agreement agreement;
  double error;  ///< relative to the column's largest value
  bool met;
};

struct Result {
  std::string title, note, base;
  bool by_size;
  std::vector<Row> rows;
  std::vector<RatioResult> ratios;  ///< without those of a subject that is not there
  std::vector<AgreementResult> agreements;
};

/// Times, then compares the states the timed runs ended in.
Result measure(const Comparison& comparison, const Effort& effort);

}  // namespace ballpark::perf
