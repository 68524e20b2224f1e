#include "scenarios/files/stress.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include "scenarios/files/comparisons.h"
#include "scenarios/files/document.h"
#include "scenarios/files/findings.h"
#include "scenarios/files/judge.h"
#include "scenarios/files/stress_check.h"

namespace ballpark::scenes {

namespace {

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

bool accepts(const Scene& scene, Status::Code code) {
  const std::vector<std::string>& list = scene.run.accept;
  return code == Status::Code::ok || std::find(list.begin(), list.end(), name(code)) != list.end();
}

/// Messages of the problems, in a line.
std::string said_by(const SceneFileError& error) {
  std::string text;
  for (const LocatedProblem& problem : error.problems()) {
    text += (text.empty() ? "" : "; ") + (problem.key.empty() ? "" : problem.key + ": ") + problem.message;
  }
  return text;
}

std::string said_by(const SceneError& error) {
  std::string text;
  for (const Problem& problem : error.problems()) text += (text.empty() ? "" : "; ") + problem.path + problem.message;
  return text;
}

void judge_comparisons(CellResult& result, double time) {
  const std::string prefix = stress_prefix;
  for (Verdict& verdict : result.verdicts) {
    if (!is_compared(verdict.expectation)) continue;
    const auto found = result.measures.find(verdict.expectation.quantity.substr(prefix.size()));
    if (found != result.measures.end()) verdict = judged(verdict.expectation, found->second, time);
  }
}

/// How far into what it may be: 1 at the limit.
double share_of_limit(const Verdict& verdict) {
  const Expectation& wanted = verdict.expectation;
  if (wanted.value) {
    const double off = std::abs(verdict.measured - *wanted.value), tolerance = wanted.tolerance.value_or(0);
    return off == 0 ? 0 : off / tolerance;
  }
  double share = 0;
  if (wanted.maximum && *wanted.maximum != 0) share = std::max(share, verdict.measured / *wanted.maximum);
  if (wanted.minimum && verdict.measured != 0) share = std::max(share, *wanted.minimum / verdict.measured);
  return share;
}

}  // namespace

StressCase::StressCase(const std::string& path) : file_(load(path)) {
  if (!file_.stress) {
    LocatedProblem problem;
    problem.location = {path, 0, 0};
    problem.message = "is no hard case, expected a table [stress]";
    throw SceneFileError({problem});
  }
  if (!file_.stress->waits_for.empty()) return;
  add("owed", file_.stress->owed);
  add("shown", file_.stress->shown);
}

void StressCase::add(const std::string& list, const std::vector<StressCell>& cells) {
  for (std::size_t i = 0; i < cells.size(); ++i) {
    cells_.push_back(loaded(cells[i], fmt::format("stress.{}[{}]", list, i)));
    cells_.back().owed = list == "owed";
  }
}

StressCase::Way StressCase::loaded(const StressCell& cell, const std::string& path) const {
  std::vector<Override> all;
  for (const std::string& text : cell.set) all.push_back(*override_of(text));
  Way way{cell, false, {}, {}};
  try {
    way.file = load(file_.path, all);
    return way;
  } catch (const SceneFileError& error) {
    if (!cell.refused.empty()) {
      way.refusal = said_by(error);
      return way;
    }
    std::vector<LocatedProblem> problems = error.problems();
    for (LocatedProblem& problem : problems) {
      if (problem.location.file != "--set") continue;
      problem.location = locate(file_, path + ".set");
      problem.key = path + ".set: " + problem.key;
    }
    throw SceneFileError(std::move(problems));
  }
}

std::string StressCase::label(const StressCell& cell) const {
  if (!cell.name.empty()) return cell.name;
  std::string integrator = file_.scene.run.integrator, contact = file_.scene.contact.kind;
  std::string precision = file_.scene.run.precision == Precision::single_ ? "single" : "double", rest;
  for (const std::string& text : cell.set) {
    const Override change = *override_of(text);
    if (change.key == "run.integrator") {
      integrator = change.value;
    } else if (change.key == "contact.kind") {
      contact = change.value;
    } else if (change.key == "run.precision") {
      precision = change.value;
    } else if (!change.key.starts_with("expect.")) {
      rest += ", " + text.substr(change.key.starts_with("run.") ? 4 : 0);
    }
  }
  return integrator + (contact.empty() ? "" : ", " + contact) + ", " + precision + rest;
}

CaseResult StressCase::empty_result() const {
  const StressRequest& stress = *file_.stress;
  return {file_.scene.name, stress.what, stress.length, stress.waits_for, {}};
}

CellResult StressCase::run(std::size_t cell, const Options& options, const RunHooks& hooks) const {
  const Way& way = cells_.at(cell);
  CellResult result;
  result.name = label(way.cell);
  result.owed = way.owed;
  result.refused = way.cell.refused;
  result.reported = way.cell.reported;
  result.said = way.refusal;
  const auto start = std::chrono::steady_clock::now();
  try {
    if (way.file) run(*way.file, options, hooks, result);
  } catch (const SceneError& error) {
    result.said = said_by(error);
  }
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  judge(result);
  return result;
}

void StressCase::run(const SceneFile& file, const Options& options, const RunHooks& hooks, CellResult& result) {
  Ending ending;
  RunHooks all = hooks;
  all.last = [&](const World& world) { ending = ending_of(world); };
  const RunReport report = scenes::run(file, options, all);
  result.interrupted = report.interrupted;
  if (!accepts(file.scene, report.status.code)) result.said = report.status.sentence;
  result.verdicts = report.verdicts;
  if (report.interrupted || (!result.said.empty() && result.reported.empty())) return;
  const Compared found = compared(file, options, ending);
  result.measures = found.measures;
  if (result.said.empty() && !accepts(file.scene, found.shifted.code)) result.said = found.shifted.sentence;
  judge_comparisons(result, report.time);
}

void StressCase::judge(CellResult& result) {
  const bool met = std::all_of(result.verdicts.begin(), result.verdicts.end(), [](auto& v) { return v.met; });
  const std::string& wanted = result.refused.empty() ? result.reported : result.refused;
  const bool says = wanted.empty() ? result.said.empty() : contains(result.said, wanted);
  result.held = says && !result.interrupted && (met || !result.refused.empty());
}

const Verdict* decisive(const std::vector<Verdict>& verdicts) {
  const Verdict* found = nullptr;
  for (const Verdict& verdict : verdicts) {
    if (!verdict.met) return &verdict;
    if (!found || share_of_limit(verdict) > share_of_limit(*found)) found = &verdict;
  }
  return found;
}

bool holds(const CaseResult& result) {
  return std::all_of(result.cells.begin(), result.cells.end(),
                     [](const CellResult& cell) { return cell.held || !cell.owed; });
}

}  // namespace ballpark::scenes
