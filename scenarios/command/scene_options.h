// What the options of a scene command mean: a loaded scene file, and how to run it.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "ballpark/options.h"
#include "ballpark/report.h"
#include "ballpark/scenes.h"
#include "scenarios/command/arguments.h"

namespace ballpark::command {

/// All of these throw UsageError that names the option and what it takes.
Options run_options(const Arguments& arguments);
std::uint64_t whole_number(const std::string& option, const std::string& text, std::uint64_t lowest,
                           std::uint64_t highest);
/// A finite number above zero, or from zero on.
double real_number(const std::string& option, const std::string& text, bool zero_too);

/// The scene with its overrides. Throws UsageError or SceneFileError.
scenes::SceneFile load_scene(const Arguments& arguments);

/// Do both names stand for one file, whatever they are spelt like? A file need not exist.
bool same_file(const std::string& a, const std::string& b);
/// Throws UsageError if one of the paths is what the scene was read from: writing it would lose it.
void refuse_inputs(const std::vector<std::string>& paths, const scenes::SceneFile& file);

/// Bodies of one copy.
std::size_t body_count(const BodyGroup& group);
std::size_t body_count(const Scene& scene);
/// Whether the scene says that it runs although this happens.
bool accepted(const Scene& scene, const Status& status);
/// Refuses what this machine's memory cannot hold: an allocation would end the program, or the machine.
void check_memory(const Scene& scene, const Options& options);

}  // namespace ballpark::command
