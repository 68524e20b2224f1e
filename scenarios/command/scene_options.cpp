#include "scenarios/command/scene_options.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <map>

#include "ballpark/catalogue.h"
#include "scenarios/command/errors.h"
#include "scenarios/command/scenario_folder.h"
#include "scenarios/command/text.h"

namespace ballpark::command {
namespace {

constexpr std::uint64_t most_threads = 1024, most_copies = 1'000'000'000;

/// The value that `word` names, or an error with the nearest name.
template <class T>
T named(const std::string& option, const std::string& word, const std::map<std::string, T>& values) {
  if (const auto found = values.find(word); found != values.end()) return found->second;
  std::vector<std::string> names;
  for (const auto& [name, value] : values) names.push_back(name);
  throw UsageError(option + ": " + no_such(option.substr(2), word, names));
}

std::string target_named(const std::string& word) {
  std::vector<std::string> names{"auto"}, usable{"auto"};
  for (const NamedDescription& target : targets()) {
    names.push_back(target.name);
    if (target.available) usable.push_back(target.name);
  }
  if (std::find(names.begin(), names.end(), word) == names.end()) {
    throw UsageError("--target: " + no_such("target", word, usable));
  }
  if (std::find(usable.begin(), usable.end(), word) == usable.end()) {
    throw UsageError(fmt::format("--target: this machine cannot run '{}' ({})", word, joined(usable)));
  }
  return word;
}

}  // namespace

std::uint64_t whole_number(const std::string& option, const std::string& text, std::uint64_t lowest,
                           std::uint64_t highest) {
  std::uint64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || value < lowest || value > highest) {
    throw UsageError(fmt::format("{}: '{}' is not a whole number from {} to {}", option, text, lowest, highest));
  }
  return value;
}

double real_number(const std::string& option, const std::string& text, bool zero_too) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool whole = error == std::errc() && end == text.data() + text.size();
  if (!whole || !std::isfinite(value) || value < 0 || (value == 0 && !zero_too)) {
    throw UsageError(
        fmt::format("{}: '{}' is not a finite number {}", option, text, zero_too ? "of at least 0" : "above 0"));
  }
  return value;
}

Options run_options(const Arguments& arguments) {
  Options options;
  if (arguments.threads) {
    options.threads = static_cast<int>(whole_number("--threads", *arguments.threads, 1, most_threads));
  }
  if (arguments.copies) options.copies = static_cast<int>(whole_number("--copies", *arguments.copies, 1, most_copies));
  if (arguments.perturb) options.perturb = real_number("--perturb", *arguments.perturb, true);
  if (arguments.target) options.target = target_named(*arguments.target);
  if (arguments.precision) {
    options.precision = named<Precision>(
        "--precision", *arguments.precision,
        {{"single", Precision::single_}, {"double", Precision::double_}, {"extended", Precision::extended}});
  }
  if (arguments.path) {
    options.path = named<Path>("--path", *arguments.path,
                               {{"automatic", Path::automatic}, {"fused", Path::fused}, {"staged", Path::staged}});
  }
  return options;
}

scenes::SceneFile load_scene(const Arguments& arguments) {
  std::vector<scenes::Override> overrides;
  for (const std::string& text : arguments.overrides) {
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos || equals == 0) {
      throw UsageError(fmt::format("--set: '{}' is not key=value (for example run.step=1e-3)", text));
    }
    overrides.push_back({text.substr(0, equals), text.substr(equals + 1)});
  }
  scenes::SceneFile file = scenes::load(scene_path(arguments.name), overrides);
  if (arguments.json && !arguments.json->empty()) refuse_inputs({*arguments.json}, file);
  return file;
}

bool same_file(const std::string& a, const std::string& b) {
  std::error_code failed_a, failed_b;
  const auto real_a = std::filesystem::weakly_canonical(std::filesystem::absolute(a), failed_a);
  const auto real_b = std::filesystem::weakly_canonical(std::filesystem::absolute(b), failed_b);
  return failed_a || failed_b ? a == b : real_a == real_b;
}

void refuse_inputs(const std::vector<std::string>& paths, const scenes::SceneFile& file) {
  std::vector<std::string> inputs = file.body_files;
  inputs.push_back(file.path);
  for (const std::string& path : paths) {
    for (const std::string& input : inputs) {
      if (same_file(path, input)) {
        throw UsageError(fmt::format("'{}' is what the scene is read from: writing it would lose it", path));
      }
    }
  }
}

std::size_t body_count(const BodyGroup& group) {
  std::size_t n =
      std::max({group.radius.size(), group.mass.size(), group.density.size(), group.inertia.size(),
                group.position.size(), group.velocity.size(), group.angular_velocity.size(), group.orientation.size()});
  if (!group.generate) return n;
  std::size_t generated = 1;
  for (std::size_t count : group.generate->count) generated *= count;
  if (group.generate->kind == "rack") generated = generated * (generated + 1) / 2;
  return std::max(n, generated);
}

std::size_t body_count(const Scene& scene) {
  std::size_t n = 0;
  for (const BodyGroup& group : scene.bodies) n += body_count(group);
  return n;
}

bool accepted(const Scene& scene, const Status& status) {
  const auto& accept = scene.run.accept;
  return std::find(accept.begin(), accept.end(), name(status.code)) != accept.end();
}

void check_memory(const Scene& scene, const Options& options) {
  constexpr double bytes_per_body = 100;  // at least: position, velocity and ids, twice while they are built
  const double bodies = static_cast<double>(body_count(scene)) * options.copies;
  const double memory = static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
  if (bodies * bytes_per_body > memory) {
    throw UsageError(fmt::format("{} bodies need about {} of memory; this machine has {}", rate(bodies),
                                 bytes(bodies * bytes_per_body), bytes(memory)));
  }
}

}  // namespace ballpark::command
