// The rows of the key table for hard cases.
#include <fmt/format.h>

#include "scenarios/files/key_rows.h"
#include "scenarios/files/stress_check.h"

namespace ballpark::scenes {

namespace {

using enum KeyType;

constexpr Range positive{.minimum = 0, .above_minimum = true};
constexpr Range not_negative{.minimum = 0};

std::string comparisons_help() {
  std::string text = "What the run is compared with, for expectations of stress.MEASURE.";
  for (const ComparisonInfo& info : comparisons()) {
    text += fmt::format(" {}: stress.{}, {}.", info.name, info.measure, info.doc);
  }
  return text;
}

Rows stress_rows() {
  return {
      Row("class", word, "", into(&StressRequest::length), "quick: always run. long: by `ballpark stress --long`.")
          .one_of({"quick", "long"})
          .otherwise("\"quick\""),
      Row("what", text, "", into(&StressRequest::what), "What is measured, in one sentence.").must(),
      Row("waits_for", text, "", into(&StressRequest::waits_for),
          "A formulation of contacts that does not exist yet: the case is listed, not run."),
      Row("compare", words, "", into(&StressRequest::compare), comparisons_help())
          .one_of(names_of(comparisons()))
          .otherwise("[]"),
      Row("shift", vector, "m", into(&StressRequest::shift), "Of compare = [\"shift\"].").otherwise("[0, 0, 0]"),
      Row("from", number, "s", into(&StressRequest::from), "Of compare = [\"start\"]: what is the start.")
          .in(not_negative)
          .otherwise("0"),
      Row("frames", times, "s", into(&StressRequest::frames),
          "Of compare = [\"frame_pattern\"]: lengths of frames, taken in turn.")
          .in(positive)
          .otherwise("[0.01, 1e-05]"),
      Row(
          "owed", tables, +[](StressRequest& s) { return &s.owed.emplace_back(); },
          "Ways to run the case that must hold: what `ballpark stress` answers for."),
      Row(
          "shown", tables, +[](StressRequest& s) { return &s.shown.emplace_back(); },
          "Ways to run the case for comparison, whatever comes of them."),
  };
}

Rows cell_rows() {
  return {
      Row("name", text, "", into(&StressCell::name),
          "What the table calls it; its integrator, contact and precision if left out."),
      Row("set", words, "", into(&StressCell::set),
          "KEY=VALUE each, as `--set` takes them: what differs from the file.")
          .otherwise("[]"),
      Row("refused", text, "", into(&StressCell::refused),
          "Part of what the engine must say: the case holds if the scene is refused, or the run reported, so, and only "
          "then. Without it the expectations must be met."),
      Row("reported", text, "", into(&StressCell::reported),
          "Part of what the run's status must say, while the expectations are met all the same."),
  };
}

}  // namespace

Rows stress_top_rows() {
  return {
      Row(
          "stress", table, +[](Draft& d) { return &d.file.stress.emplace(); },
          "What makes the scene a hard case of `ballpark stress`."),
  };
}

std::vector<TableRows> stress_tables() {
  return {{"stress", stress_rows()}, {"stress.owed", cell_rows()}, {"stress.shown", cell_rows()}};
}

}  // namespace ballpark::scenes
