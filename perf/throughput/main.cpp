// Throughput, measured side by side: Ballpark beside a hand-written loop, its own other paths, and Boost.odeint.
#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <fstream>
#include <optional>

#include "perf/throughput/attraction.h"
#include "perf/throughput/bars.h"
#include "perf/throughput/drop.h"
#include "perf/throughput/report.h"

namespace {

using namespace ballpark::perf;

constexpr int done = 0, failed = 1, bad_usage = 2;

struct CommandLine {
  Settings settings;
  std::vector<std::string> names;  ///< of the benchmarks to run
  DropSettings drop;
  bool check_bars = false;
  std::optional<std::string> json;  ///< file; empty: standard output
};

// Returns an exit code if the program ends here.
std::optional<int> parse(int argc, char** argv, CommandLine& line) {
  line.settings.threads = std::min(2, machine().threads);
  for (const Benchmark& benchmark : benchmarks()) line.names.push_back(benchmark.name);
  CLI::App app(
      "Measures Ballpark's throughput beside a hand-written loop and Boost.odeint, in turns in one run.\n"
      "Exit code 1 if their results disagree, or (--check-bars) if a ratio misses its bar.");
  std::vector<std::string> all = line.names;
  all.insert(all.end(), {"bars", "drop", "tree"});
  app.add_option("comparison", line.names, "which to run (default: all but bars, drop and tree, which take minutes)")
      ->check(CLI::IsMember(all));
  app.add_option("--balls", line.drop.balls, "of drop: 1000, 10000 or 100000 fall into a box")
      ->check(CLI::Range(1, 10000000))
      ->capture_default_str();
  app.add_option("--steps", line.drop.steps, "of drop")->check(CLI::Range(10, 100000))->capture_default_str();
  app.add_flag("--alone", line.drop.alone, "drop without ODE and Bullet");
  app.add_option("--bodies", line.settings.bodies, "of the largest scenes")
      ->check(CLI::Range(std::size_t{1}, std::size_t{1} << 32))
      ->capture_default_str();
  app.add_option("--seconds", line.settings.seconds, "for each comparison, at least (and at least 9 rounds)")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  app.add_option("--threads", line.settings.threads, "whose gain is compared with that of a streaming triad")
      ->check(CLI::Range(1, 4096))
      ->capture_default_str();
  std::string file;
  CLI::Option* json = app.add_option("--json", file, "write JSON to FILE, or instead of the tables to standard output")
                          ->expected(0, 1)
                          ->type_name("[FILE]");
  app.add_flag("--check-bars", line.check_bars, "exit with 1 if a ratio misses its bar");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? done : bad_usage;
  }
  if (json->count() > 0) line.json = file;
  return std::nullopt;
}

std::vector<Result> measure_all(const CommandLine& line, bool print) {
  std::vector<Result> results;
  for (const Benchmark& benchmark : benchmarks()) {
    if (std::find(line.names.begin(), line.names.end(), benchmark.name) == line.names.end()) continue;
    if (isatty(STDERR_FILENO)) fmt::print(stderr, "measuring {} ...\n", benchmark.name);
    results.push_back(measure(benchmark.build(line.settings), {.seconds = line.settings.seconds}));
    if (print) fmt::print("{}", to_text(results.back()));
    std::fflush(stdout);
  }
  return results;
}

bool all_met(const std::vector<Result>& results, bool check_bars) {
  const auto met = [](const auto& item) { return item.met; };
  return std::all_of(results.begin(), results.end(), [&](const Result& result) {
    return std::all_of(result.agreements.begin(), result.agreements.end(), met) &&
           (!check_bars || std::all_of(result.ratios.begin(), result.ratios.end(), met));
  });
}

/// Was this asked for? Then it is done apart from the comparisons.
bool taken(CommandLine& line, const char* name) {
  return std::erase(line.names, name) > 0;
}

int run(CommandLine line) {
  if (taken(line, "drop")) {
    line.drop.threads = line.settings.threads;
    drop(line.drop);
    if (line.names.empty()) return done;
  }
  bool met = true;
  if (taken(line, "tree")) met = tree({line.settings.bodies, line.settings.threads}) && met;
  if (taken(line, "bars")) met = bars(line.settings) && met;
  met = met || !line.check_bars;
  if (line.names.empty()) return met ? done : failed;
  const Machine here = machine();
  const bool json_only = line.json && line.json->empty();
  if (!json_only) fmt::print("{}", heading(here, line.settings));
  const std::vector<Result> results = measure_all(line, !json_only);
  if (json_only) fmt::print("{}", to_json(here, line.settings, results));
  if (line.json && !json_only && !(std::ofstream(*line.json) << to_json(here, line.settings, results))) {
    fmt::print(stderr, "cannot write {}\n", *line.json);
    return bad_usage;
  }
  return all_met(results, line.check_bars) && met ? done : failed;
}

}  // namespace

int main(int argc, char** argv) {
  CommandLine line;
  if (const auto code = parse(argc, argv, line)) return *code;
  try {
    return run(line);
  } catch (const std::exception& error) {
    fmt::print(stderr, "error: {}\n", error.what());
    return failed;
  }
}
