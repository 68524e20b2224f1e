// Orbits beside Boost.odeint at equal error: one solve and many copies, fixed steps and tolerances, in turns in one
// run.
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>

#include "perf/machine.h"
#include "perf/peers/orbits_cases.h"

namespace {

using namespace ballpark::perf;

constexpr int done = 0, failed = 1, bad_usage = 2;

struct CommandLine {
  std::vector<std::string> words;  ///< of the names of cases to run
  double seconds = 1;
  bool check_bars = false;
  std::optional<std::string> json;  ///< file; empty: standard output
};

constexpr const char* usage =
    "usage: orbits [WORD]... [--seconds S] [--check-bars] [--json [FILE]]\n"
    "Measures Ballpark beside Boost.odeint on Kepler's orbit and the Pleiades: curves of error against wall time,\n"
    "compared at equal error.\n"
    "  WORD...        only cases with all of these in their names, as: Copies Kepler\n"
    "  --seconds S    for each case, at least (and at least 9 rounds; default 1)\n"
    "  --check-bars   exit with 1 if a ratio misses its bar\n"
    "  --json [FILE]  JSON to FILE, or instead of the tables to standard output\n";

/// The exit code, if there is nothing to run.
std::optional<int> parse(int argc, char** argv, CommandLine& line) {
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    const bool followed = i + 1 < argc && argv[i + 1][0] != '-';
    if (word == "--help") {
      fmt::print("{}", usage);
      return done;
    }
    if (word == "--check-bars") {
      line.check_bars = true;
    } else if (word == "--json") {
      line.json = followed ? argv[++i] : "";
    } else if (word == "--seconds" && followed) {
      char* end = nullptr;
      line.seconds = std::strtod(argv[++i], &end);
      if (*end != '\0' || !(line.seconds >= 0)) return fmt::print(stderr, "{}", usage), bad_usage;
    } else if (word[0] != '-') {
      line.words.push_back(word);
    } else {
      return fmt::print(stderr, "{}", usage), bad_usage;
    }
  }
  return std::nullopt;
}

std::string bar_of(const OrbitCase& orbit) {
  const std::string aim = orbit.aim > 0 ? fmt::format(" (aim {})", orbit.aim) : "";
  return fmt::format("{} {}{}", orbit.at_most ? "<=" : ">=", orbit.bar, aim);
}

const char* ratio_of(const OrbitCase& orbit) {
  return orbit.at_most ? "Ballpark / odeint" : "odeint / Ballpark";
}

void print(const OrbitResult& result) {
  const OrbitCase& orbit = result.orbit;
  fmt::print("\n{}{}\n", orbit.name, orbit.copies > 1 ? fmt::format(": {} of them", orbit.copies) : "");
  fmt::print("{:<36}{:>9}{:>11}{:>9}{:>13}{:>12}{:>12}\n", "", "setting", "error", "steps", "evaluations", "minimum ms",
             "median ms");
  for (const Curve& curve : result.curves) {
    for (const Point& p : curve.points) {
      fmt::print("{:<36}{:>9.4g}{:>11.2e}{:>9}{:>13}{:>12.4f}{:>12.4f}\n", curve.name, p.setting, p.error, p.steps,
                 p.evaluations, 1e3 * p.minimum, 1e3 * p.median);
    }
  }
  const auto line = [](const std::string& name, const EqualError& r, const std::string& note) {
    fmt::print("  {:<34}{:>8.3f} by the minima, {:>6.3f} by the medians{}\n", name, r.of_minima, r.of_medians, note);
  };
  for (const EqualError& r : result.at_errors) line(fmt::format("{} at error {:g}", ratio_of(orbit), r.error), r, "");
  line("mean", result.mean, fmt::format("   {}: {}", bar_of(orbit), result.met ? "met" : "MISSED"));
  for (const EqualError& r : result.gain_of_threads) line("one thread / two", r, "");
}

void print_summary(const std::vector<OrbitResult>& results) {
  fmt::print("\n{:<30}{:<20}{:>10}{:>11}   {}\n", "at equal error", "ratio of times", "of minima", "of medians", "bar");
  for (const OrbitResult& r : results) {
    fmt::print("{:<30}{:<20}{:>10.2f}{:>11.2f}   {}: {}\n", r.orbit.name, ratio_of(r.orbit), r.mean.of_minima,
               r.mean.of_medians, bar_of(r.orbit), r.met ? "met" : "MISSED");
    if (r.orbit.copies == 1) continue;
    const EqualError gain = mean(r.gain_of_threads);
    fmt::print("{:<30}{:<20}{:>10.2f}{:>11.2f}\n", "", "one thread / two", gain.of_minima, gain.of_medians);
  }
}

nlohmann::json json_of(const EqualError& r) {
  return {{"error", r.error}, {"of_minima", r.of_minima}, {"of_medians", r.of_medians}};
}

nlohmann::json json_of(const Curve& curve) {
  nlohmann::json points = nlohmann::json::array();
  for (const Point& p : curve.points) {
    points.push_back({{"setting", p.setting},
                      {"error", p.error},
                      {"steps", p.steps},
                      {"evaluations", p.evaluations},
                      {"seconds", {{"min", p.minimum}, {"median", p.median}}}});
  }
  return {{"name", curve.name}, {"points", points}};
}

nlohmann::json json_of(const OrbitResult& result);

template <class Item>
nlohmann::json json_list(const std::vector<Item>& items) {
  nlohmann::json list = nlohmann::json::array();
  for (const Item& item : items) list.push_back(json_of(item));
  return list;
}

nlohmann::json json_of(const OrbitResult& result) {
  const OrbitCase& orbit = result.orbit;
  return {{"name", orbit.name},
          {"copies", orbit.copies},
          {"curves", json_list(result.curves)},
          {"ratio", orbit.at_most ? "ballpark / odeint" : "odeint / ballpark"},
          {"at_errors", json_list(result.at_errors)},
          {"mean", json_of(result.mean)},
          {orbit.at_most ? "at_most" : "at_least", orbit.bar},
          {"met", result.met},
          {"one_thread_over_two", json_list(result.gain_of_threads)}};
}

std::string to_json(const Machine& here, const CommandLine& line, const std::vector<OrbitResult>& results) {
  const nlohmann::json json = {
      {"format", 1},
      {"machine",
       {{"processor", here.processor}, {"threads", here.threads}, {"compiler", here.compiler}, {"load", here.load}}},
      {"seconds", line.seconds},
      {"cases", json_list(results)}};
  return json.dump(2) + "\n";
}

int run(const CommandLine& line) {
  const Machine here = machine();
  const bool json_only = line.json && line.json->empty();
  if (!json_only) {
    fmt::print("{}, {} threads at once; {}; load {:.2f}\n", here.processor, here.threads, here.compiler, here.load);
    fmt::print("Subjects run in turns, at least {:g} s and 9 rounds each case; bars are judged on the minima.\n",
               line.seconds);
  }
  std::vector<OrbitResult> results;
  for (const OrbitCase& orbit : orbit_cases()) {
    const auto named = [&](const std::string& word) { return orbit.name.find(word) != std::string::npos; };
    if (!std::all_of(line.words.begin(), line.words.end(), named)) continue;
    results.push_back(measure(orbit, {.seconds = line.seconds}));
    if (!json_only) print(results.back());
    std::fflush(stdout);
  }
  if (!json_only) print_summary(results);
  if (json_only) fmt::print("{}", to_json(here, line, results));
  if (line.json && !json_only && !(std::ofstream(*line.json) << to_json(here, line, results))) {
    fmt::print(stderr, "cannot write {}\n", *line.json);
    return bad_usage;
  }
  const bool met = std::all_of(results.begin(), results.end(), [](const OrbitResult& r) { return r.met; });
  return met || !line.check_bars ? done : failed;
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
