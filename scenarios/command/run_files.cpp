#include "scenarios/command/run_files.h"

#include <fmt/format.h>

#include "scenarios/command/csv.h"
#include "scenarios/command/errors.h"
#include "scenarios/command/scene_options.h"
#include "scenarios/command/terminal.h"

namespace ballpark::command {
namespace {

/// Two results in one file would overwrite each other.
void refuse_shared(const std::vector<std::string>& paths) {
  for (std::size_t i = 0; i < paths.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (same_file(paths[i], paths[j])) {
        throw UsageError(fmt::format("'{}' would be written twice: give each its own file", paths[i]));
      }
    }
  }
}

std::optional<scenes::OutputRequest> requested_series(const Arguments& arguments) {
  if (arguments.every.has_value() != arguments.out.has_value()) {
    throw UsageError(arguments.every ? "--every needs --out FILE: where the frames go"
                                     : "--out needs --every S: how often a frame is written");
  }
  if (!arguments.every) return std::nullopt;
  scenes::OutputRequest request;
  request.every = real_number("--every", *arguments.every, false);
  request.file = *arguments.out;
  return request;
}

}  // namespace

RunFiles::RunFiles(scenes::SceneFile& scene_file, const Arguments& arguments) {
  if (auto request = requested_series(arguments)) scene_file.outputs.push_back(*request);
  std::vector<std::string> paths;
  for (const scenes::OutputRequest& output : scene_file.outputs) paths.push_back(output.file);
  if (arguments.state) paths.push_back(*arguments.state);
  if (arguments.json && !arguments.json->empty()) paths.push_back(*arguments.json);
  refuse_shared(paths);
  refuse_inputs(paths, scene_file);
  for (const scenes::OutputRequest& output : scene_file.outputs) {
    series_.push_back({output.file, "", open_frame_file(output.file)});
  }
  if (!arguments.state) return;
  state_.emplace(*arguments.state);
  scenes::OutputRequest end;
  end.at = {scene_file.scene.run.duration};
  end.file = *arguments.state;
  scene_file.outputs.push_back(end);
}

std::vector<scenes::FrameWriter> RunFiles::writers() {
  std::vector<scenes::FrameWriter> all;
  for (Series& series : series_) {
    all.push_back([this, &series](const World& world) { add_to(series, world); });
  }
  if (state_) {
    all.push_back([this](const World& world) {
      state_reached_ = true;
      try {
        write_state(world, *state_);
      } catch (const WriteError& error) {
        state_failure_ = error.what();
      }
    });
  }
  return all;
}

void RunFiles::add_to(Series& series, const World& world) {
  if (!series.failure.empty()) return;
  try {
    series.file->add(world);
  } catch (const std::runtime_error& error) {
    series.failure = error.what();
    complain(series.failure + "; the run goes on without it");
  }
}

std::vector<std::string> RunFiles::finish() {
  std::vector<std::string> failures;
  const auto attempt = [&](const std::string& path, const std::string& failure, const auto& put_in_place) {
    try {
      if (!failure.empty()) throw WriteError(failure);
      put_in_place();
      written_.push_back(path);
    } catch (const std::runtime_error& error) {
      failures.push_back(error.what());
    }
  };
  for (Series& series : series_) {
    attempt(series.path, series.failure, [&] { series.file->finish(); });
  }
  if (state_ && !state_reached_) {
    failures.push_back(fmt::format("'{}' was not written: the run did not reach its end", state_->path()));
  } else if (state_) {
    attempt(state_->path(), state_failure_, [&] { state_->commit(); });
  }
  return failures;
}

}  // namespace ballpark::command
