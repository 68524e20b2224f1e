#include "engine/world/check.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "engine/core/nearest.h"
#include "engine/world/interface.h"

namespace ballpark {

std::string text(double value) {
  return fmt::format("{:g}", value);
}

std::string path_of(const char* table, std::size_t index, const char* key) {
  return fmt::format("{}[{}]{}{}", table, index, *key ? "." : "", key);
}

std::string path_of(const std::string& path, std::size_t row, std::size_t rows) {
  return rows == 1 ? path : fmt::format("{}[{}]", path, row);
}

double Problems::rounded(double value) const {
  const bool single = precision_ == Precision::single_;
  const double smallest = single ? std::numeric_limits<float>::min() : std::numeric_limits<double>::min();
  if (std::abs(value) < smallest) return 0;  // a step flushes denormals
  return single ? static_cast<double>(static_cast<float>(value)) : value;
}

bool Problems::finite(const std::string& path, double value, const char* unit) {
  const bool good = std::isfinite(value) && std::isfinite(rounded(value));
  const char* range = std::isfinite(value) ? " in this precision's range" : "";
  if (!good) add(path, fmt::format("is {}, expected a finite number [{}]{}", text(value), unit, range));
  return good;
}

bool Problems::finite(const std::string& path, const Vector3d& value, const char* unit) {
  for (int c = 0; c < 3; ++c) {
    if (!finite(path, value[c], unit)) return false;
  }
  return true;
}

bool Problems::positive(const std::string& path, double value, const char* unit) {
  const bool good = value > 0 && std::isfinite(rounded(value)) && rounded(value) > 0;
  if (!good) add(path, fmt::format("is {}, expected a finite number > 0 [{}]", text(value), unit));
  return good;
}

bool Problems::not_negative(const std::string& path, double value, const char* unit) {
  const bool good = value >= 0 && std::isfinite(rounded(value));
  if (!good) add(path, fmt::format("is {}, expected a finite number >= 0 [{}]", text(value), unit));
  return good;
}

bool Problems::known(const std::string& path, const char* what, const std::string& word,
                     const std::vector<std::string>& words) {
  for (const std::string& w : words) {
    if (w == word) return true;
  }
  add(path, fmt::format("unknown {} \"{}\"{}", what, word, suggestion(word, words)));
  return false;
}

namespace {

/// Rounding must stay well below what is asked for.
void check_tolerance(const RunSettings& run, Problems& problems) {
  const double least = run.precision == Precision::single_ ? 1e-6 : run.precision == Precision::double_ ? 1e-15 : 1e-18;
  if (!(run.tolerance >= least && run.tolerance <= 0.1)) {
    problems.add("run.tolerance", fmt::format("is {}, expected a number from {} (what this precision resolves) to 0.1",
                                              text(run.tolerance), text(least)));
  }
  if (run.absolute_tolerance != 0) problems.positive("run.absolute_tolerance", run.absolute_tolerance, "m");
  if (run.step != 0 || run.automatic_step) {
    problems.add("run.step", "is given beside run.tolerance, expected one of the two");
  }
}

void check_run(const RunSettings& run, Problems& problems) {
  const bool ends = problems.not_negative("run.duration", run.duration, "s");
  if (run.tolerance != 0) {
    check_tolerance(run, problems);
  } else if (run.automatic_step) {
    if (run.step != 0) problems.add("run.step", "is given beside run.automatic_step, expected one of the two");
  } else if (run.step == 0) {
    problems.add("run.step",
                 "is not given, expected a number > 0 [s], or run.tolerance of an integrator that takes one");
  } else if (problems.positive("run.step", run.step, "s") && ends && run.duration / run.step > 1e15) {
    problems.add("run.step", fmt::format("is {} s: a duration of {} s would need more than 1e15 steps", text(run.step),
                                         text(run.duration)));
  }
  std::vector<std::string> rules;
  for (const NamedDescription& rule : rotations()) rules.push_back(rule.name);
  problems.known("run.rotation", "rotation update", run.rotation, rules);
  for (std::size_t i = 0; i < run.accept.size(); ++i) {
    problems.known(path_of("run.accept", i), "limit", run.accept[i], {"stability", "accuracy"});
  }
}

void check_impulses(const Scene& scene, Problems& problems) {
  std::size_t count = 0;
  for (const BodyGroup& group : scene.bodies) count += body_count(group);
  for (std::size_t i = 0; i < scene.impulses.size(); ++i) {
    const Impulse& impulse = scene.impulses[i];
    problems.not_negative(path_of("impulse", i, "at"), impulse.at, "s");
    problems.finite(path_of("impulse", i, "J"), impulse.J, "N s");
    problems.finite(path_of("impulse", i, "offset"), impulse.offset, "m");
    if (impulse.id >= count) {
      problems.add(path_of("impulse", i, "id"),
                   fmt::format("is {}, expected the id of one of the {} bodies, from 0", impulse.id, count));
      continue;
    }
    if (impulse.offset == Vector3d::Zero()) continue;
    std::size_t first = 0;
    for (const BodyGroup& group : scene.bodies) {
      const std::size_t n = body_count(group);
      if (impulse.id >= first && impulse.id < first + n && !rotates(group) && !pivot_of(scene, group)) {
        problems.add(
            path_of("impulse", i, "offset"),
            "body " + std::to_string(impulse.id) + " is a particle without rotation, expected an offset of zero");
      }
      first += n;
    }
  }
}

}  // namespace

std::vector<Problem> check(const Scene& scene) {
  Problems problems(scene.run.precision);
  check_run(scene.run, problems);
  check_integrator(scene, problems);
  check_bodies(scene, problems);
  check_effects(scene, problems);
  check_presence(scene, problems);
  check_contacts(scene, problems);
  check_impulses(scene, problems);
  return problems.all();
}

}  // namespace ballpark
