#include "perf/throughput/comparison.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ballpark::perf {

namespace {

template <class Named>
const Named* find(const std::vector<Named>& all, const std::string& name) {
  const auto found = std::find_if(all.begin(), all.end(), [&](const Named& one) { return one.name == name; });
  return found == all.end() ? nullptr : &*found;
}

std::optional<RatioResult> evaluate(const Ratio& ratio, const std::vector<Row>& rows) {
  RatioResult result{.ratio = ratio, .of_minima = 1, .of_medians = 1, .met = true};
  const auto multiply = [&](const std::vector<std::string>& names, double power) {
    return std::all_of(names.begin(), names.end(), [&](const std::string& name) {
      const Row* row = find(rows, name);
      if (row == nullptr) return false;
      result.of_minima *= std::pow(row->nanoseconds(row->samples.minimum()), power);
      result.of_medians *= std::pow(row->nanoseconds(row->samples.median()), power);
      return true;
    });
  };
  if (!multiply(ratio.over, 1) || !multiply(ratio.under, -1)) return std::nullopt;
  if (ratio.bar) {
    result.met = ratio.bar->at_most ? result.of_minima <= ratio.bar->limit : result.of_minima >= ratio.bar->limit;
  }
  return result;
}

// The largest difference over the column's largest value; infinite if a value is not a number or has no counterpart.
double column_difference(const std::vector<double>& a, const std::vector<double>& b) {
  if (a.size() != b.size()) return std::numeric_limits<double>::infinity();
  double difference = 0, scale = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (!std::isfinite(a[i]) || !std::isfinite(b[i])) return std::numeric_limits<double>::infinity();
    difference = std::max(difference, std::abs(a[i] - b[i]));
    scale = std::max(scale, std::abs(a[i]));
  }
  return difference == 0 ? 0 : difference / scale;
}

std::optional<AgreementResult> evaluate(const Agreement& agreement, const std::vector<Subject>& subjects) {
  const Subject* first = find(subjects, agreement.a);
  const Subject* second = find(subjects, agreement.b);
  if (first == nullptr || second == nullptr) return std::nullopt;
  const StateColumns a = first->state(), b = second->state();
  double error = 0;
  for (std::size_t c = 0; c < a.size(); ++c) error = std::max(error, column_difference(a[c], b.at(c)));
  return AgreementResult{.agreement = agreement, .error = error, .met = error <= agreement.tolerance};
}

}  // namespace

Result measure(const Comparison& comparison, const Effort& effort) {
  std::vector<Task> tasks;
  for (const Subject& subject : comparison.subjects) tasks.push_back(subject.run);
  const std::vector<Samples> samples = time_interleaved(tasks, effort);

  Result result;
  result.title = comparison.title;
  result.note = comparison.note;
  result.base = comparison.base;
  result.by_size = comparison.by_size;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const Subject& subject = comparison.subjects[i];
    result.rows.push_back({subject.name, subject.bodies, subject.units, subject.bytes_per_unit, samples[i]});
  }
  for (const Ratio& ratio : comparison.ratios) {
    if (const auto evaluated = evaluate(ratio, result.rows)) result.ratios.push_back(*evaluated);
  }
  for (const Agreement& agreement : comparison.agreements) {
    if (const auto evaluated = evaluate(agreement, comparison.subjects)) result.agreements.push_back(*evaluated);
  }
  return result;
}

}  // namespace ballpark::perf
