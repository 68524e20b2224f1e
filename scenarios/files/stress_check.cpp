#include "scenarios/files/stress_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "ballpark/catalogue.h"
#include "scenarios/files/document.h"
#include "scenarios/files/judge.h"
#include "scenarios/files/values.h"

namespace ballpark::scenes {

namespace {

bool has(const std::vector<std::string>& words, const std::string& word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

class StressCheck {
 public:
  explicit StressCheck(const SceneFile& file) : file_(file), stress_(*file.stress) {}

  void request() {
    if (stress_.what.empty()) add("stress.what", "is empty, expected a sentence");
    if (!stress_.waits_for.empty()) return waiting();
    if (stress_.owed.empty()) {
      add("stress.owed", "is missing, expected tables, each under [[stress.owed]]: at least one way to run the case");
    }
    settings();
    cells("owed", stress_.owed);
    cells("shown", stress_.shown);
  }

  void expectation(const Expectation& expectation, const std::string& path) {
    const std::string measure = expectation.quantity.substr(std::string(stress_prefix).size());
    std::vector<std::string> names;
    bool known = false, compared = false;
    for (const ComparisonInfo& info : comparisons()) {
      if (!has(names, info.measure)) names.push_back(info.measure);
      known |= info.measure == measure;
      compared |= info.measure == measure && has(stress_.compare, info.name);
    }
    if (!known) {
      add(path + ".quantity", fmt::format("there is no \"{}\" in stress, expected one of {}{}", printable(measure),
                                          fmt::join(names, ", "), hint(measure, names)));
    } else if (!compared) {
      add(path + ".quantity", fmt::format("\"{}\" is not measured, expected {} in stress.compare",
                                          printable(expectation.quantity), ways_to(measure)));
    }
    if (expectation.at) add(path + ".at", "stands beside a quantity of whole runs, which is measured at their end");
  }

  std::vector<Problem> problems;

 private:
  void add(const std::string& path, const std::string& message) { problems.push_back({path, message}); }

  static std::string ways_to(const std::string& measure) {
    std::vector<std::string> ways;
    for (const ComparisonInfo& info : comparisons()) {
      if (info.measure == measure) ways.push_back(info.name);
    }
    return fmt::format("\"{}\"", fmt::join(ways, "\" or \""));
  }

  void waiting() {
    for (const NamedDescription& kind : contacts()) {
      if (kind.name == stress_.waits_for) {
        add("stress.waits_for", fmt::format("is \"{}\", which exists: the case can be run", kind.name));
      }
    }
  }

  void settings() {
    const bool shifted = has(stress_.compare, "shift");
    if (shifted != (stress_.shift.norm() > 0)) {
      add("stress.shift", shifted ? "is missing, expected a shift [x, y, z] [m] beside compare = [\"shift\"]"
                                  : "stands without compare = [\"shift\"]");
    }
    const double duration = file_.scene.run.duration;
    if (!(stress_.from >= 0 && stress_.from <= duration)) {
      add("stress.from", fmt::format("is {} s, expected 0 to run.duration = {} s", stress_.from, duration));
    }
    const bool lengths = !stress_.frames.empty() && std::all_of(stress_.frames.begin(), stress_.frames.end(),
                                                                [](double s) { return std::isfinite(s) && s > 0; });
    if (!lengths) add("stress.frames", "hold no length or one that is not > 0, expected a list of numbers > 0 [s]");
  }

  void cells(const std::string& list, const std::vector<StressCell>& cells) {
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const std::string path = fmt::format("stress.{}[{}]", list, i);
      for (const std::string& text : cells[i].set) {
        if (!override_of(text)) {
          add(path + ".set", fmt::format("\"{}\" is not key=value (for example run.step=1e-3)", printable(text)));
        }
      }
      if (!cells[i].refused.empty() && !cells[i].reported.empty()) {
        add(path + ".reported", "stands beside refused, expected one of the two");
      }
      if (cells[i].refused.empty() && file_.expectations.empty()) {
        add(path, "has nothing to hold, expected [[expect]] in the file, or refused");
      }
    }
  }

  const SceneFile& file_;
  const StressRequest& stress_;
};

}  // namespace

const std::vector<ComparisonInfo>& comparisons() {
  static const std::vector<ComparisonInfo> list{
      {"repeat", "hash_equal", "1 if a second run ends in the same bits, else 0"},
      {"threads", "hash_equal", "likewise runs with 1, 2, 4, 8 and 16 threads"},
      {"targets", "hash_equal", "likewise runs with each instruction set of this machine"},
      {"resume", "hash_equal", "likewise a run that another world goes on with, from a snapshot half way"},
      {"frame_pattern", "hash_equal", "likewise a run that is asked for in frames"},
      {"shift", "difference", "the most by which a body of the shifted scene is elsewhere, the shift taken off [m]"},
      {"with_fault", "bodies_changed", "bodies that no [[impulse]] hits, and whose bits change with the impulses"},
      {"brute_force", "pair_errors",
       "bodies whose number of contacts at the end is not that of overlaps, all pairs tried"},
      {"mirror", "mirror_error", "the largest distance of a body's mirror image, -y for y, from the nearest body [m]"},
      {"start", "displacement", "the largest distance of a body from where it was at the start [m]"},
      {"unit", "norm_error", "the most by which an orientation's length differs from 1"},
  };
  return list;
}

std::optional<Override> override_of(const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos || equals == 0) return std::nullopt;
  return Override{text.substr(0, equals), text.substr(equals + 1)};
}

std::vector<Problem> check_stress(const SceneFile& file) {
  std::vector<Problem> problems;
  if (file.stress) {
    StressCheck check(file);
    check.request();
    for (std::size_t i = 0; i < file.expectations.size(); ++i) {
      if (is_compared(file.expectations[i])) check.expectation(file.expectations[i], fmt::format("expect[{}]", i));
    }
    problems = std::move(check.problems);
  } else {
    for (std::size_t i = 0; i < file.expectations.size(); ++i) {
      if (!is_compared(file.expectations[i])) continue;
      problems.push_back({fmt::format("expect[{}].quantity", i), "is of a hard case, expected a [stress] table"});
    }
  }
  return problems;
}

}  // namespace ballpark::scenes
