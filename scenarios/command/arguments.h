// The command line as words: what was typed, not yet what it means.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace ballpark::command {

struct Arguments {
  std::string command;
  std::string name;                    ///< SCENE, NAME, or what to list
  std::vector<std::string> names;      ///< of `stress`, which takes several
  std::vector<std::string> overrides;  ///< key=value
  std::optional<std::string> threads, precision, target, copies, perturb, path;
  std::optional<std::string> state, figure, every, out, columns, out_precision;
  std::optional<std::string> steps, seconds;
  std::optional<std::string> integrators, axis_steps, tolerances, precisions, axis_contacts, rotations,
      openings;  ///< axes of `cost`
  std::optional<std::string> error, reference, tolerance, budget, csv, svg, html;
  std::optional<std::string> bodies;                                                             ///< of `prices`
  std::optional<std::string> frames, max_size, with, scene, compare, still, size, colour, from;  ///< of `view`
  bool write = false;
  bool ledger = false;              ///< of `run`
  bool long_cases = false;          ///< of `stress`
  std::optional<std::string> json;  ///< a file; "": standard output
  bool quiet = false;
};

/// Help or version text was asked for: print it, nothing else.
struct Answer {
  std::string text;
};

struct CommandLine {
  std::optional<Answer> answer;
  Arguments arguments;
};

/// Throws UsageError.
CommandLine read_command_line(int argc, char** argv);

}  // namespace ballpark::command
