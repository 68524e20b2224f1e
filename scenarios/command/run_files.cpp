#include "scenarios/command/run_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include "scenarios/command/csv.h"
#include "scenarios/command/errors.h"
#include "scenarios/command/scene_options.h"
#include "scenarios/command/terminal.h"
#include "scenarios/command/text.h"
#include "scenarios/files/output_formats.h"

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

std::vector<std::string> column_names(const std::string& list) {
  std::vector<std::string> names;
  std::istringstream words(list);
  for (std::string word; std::getline(words, word, ',');) {
    const std::vector<std::string>& known = scenes::output_columns();
    if (std::find(known.begin(), known.end(), word) == known.end()) {
      throw UsageError("--columns: " + no_such("column", word, known));
    }
    names.push_back(word);
  }
  if (names.empty()) throw UsageError("--columns: is empty, expected some of " + joined(scenes::output_columns()));
  return names;
}

void refuse_alone(const char* option, const std::optional<std::string>& value, const char* purpose) {
  if (value) throw UsageError(fmt::format("{} needs --out FILE: {}", option, purpose));
}

std::optional<scenes::OutputRequest> requested_series(const Arguments& arguments, const Scene& scene) {
  if (!arguments.out) {
    refuse_alone("--every", arguments.every, "where the frames go");
    refuse_alone("--columns", arguments.columns, "what of the bodies goes there");
    refuse_alone("--out-precision", arguments.out_precision, "the precision of its numbers");
    return std::nullopt;
  }
  if (!arguments.every) throw UsageError("--out needs --every S: how often a frame is written");
  scenes::OutputRequest request;
  request.every = real_number("--every", *arguments.every, false);
  request.file = *arguments.out;
  if (arguments.columns) request.columns = column_names(*arguments.columns);
  if (arguments.out_precision) {
    request.precision = *arguments.out_precision;
    if (request.precision != "single" && request.precision != "double") {
      throw UsageError("--out-precision: " + no_such("precision", request.precision, {"single", "double"}));
    }
  }
  if (scenes::lacks_position(request)) {
    throw UsageError(fmt::format("--columns: '{}' shows where bodies are, so position must be there", request.file));
  }
  if (const std::string column = scenes::lacking_contacts(request, scene); !column.empty()) {
    throw UsageError(fmt::format("--columns: there are no {}: bodies do not touch in this scene", column));
  }
  return request;
}

}  // namespace

RunFiles::RunFiles(scenes::SceneFile& scene_file, const Arguments& arguments) : scene_(scene_file.scene) {
  if (auto request = requested_series(arguments, scene_)) scene_file.outputs.push_back(*request);
  std::vector<std::string> paths;
  for (const scenes::OutputRequest& output : scene_file.outputs) paths.push_back(frame_file_name(output.file));
  if (arguments.state) paths.push_back(*arguments.state);
  if (arguments.figure) paths.push_back(*arguments.figure);
  if (arguments.json && !arguments.json->empty()) paths.push_back(*arguments.json);
  refuse_shared(paths);
  refuse_inputs(paths, scene_file);
  for (const scenes::OutputRequest& output : scene_file.outputs) series_.emplace_back(output, scene_);
  if (arguments.state) {
    state_.emplace(*arguments.state);
    scenes::OutputRequest end;
    end.at = {scene_.run.duration};
    end.file = *arguments.state;
    scene_file.outputs.push_back(end);
  }
  if (arguments.figure) {
    figure_.emplace(*arguments.figure, scene_, arguments.ledger);
    scene_file.outputs.push_back(figure_->request());
  }
}

std::vector<scenes::FrameWriter> RunFiles::writers() {
  std::vector<scenes::FrameWriter> all;
  for (Series& series : series_) {
    all.push_back([&series](const World& world) {
      series.add(world);
      if (const auto news = series.news()) complain(*news + "; the run goes on without it");
    });
  }
  if (state_) {
    all.push_back([this](const World& world) {
      state_reached_ = true;
      try {
        write_state(world, scene_, *state_);
      } catch (const WriteError& error) {
        state_failure_ = error.what();
      }
    });
  }
  if (figure_) {
    all.push_back([this](const World& world) { figure_->add(world); });
  }
  return all;
}

bool RunFiles::finish() {
  bool all = true;
  for (Series& series : series_) {
    if (series.finish()) {
      written_.push_back(series.cost().file);
    } else {
      all = false;
    }
    if (const auto news = series.news()) failures_.push_back(*news);
  }
  if (state_) finish_state();
  if (figure_) finish_figure();
  return all && failures_.empty();
}

void RunFiles::finish_state() {
  try {
    if (!state_reached_) {
      throw WriteError(fmt::format("'{}' was not written: the run did not reach its end", state_->path()));
    }
    if (!state_failure_.empty()) throw WriteError(state_failure_);
    state_->commit();
    written_.push_back(state_->path());
  } catch (const WriteError& error) {
    failures_.push_back(error.what());
  }
}

void RunFiles::finish_figure() {
  try {
    figure_->write();
    written_.push_back(figure_->path());
  } catch (const WriteError& error) {
    failures_.push_back(error.what());
  }
}

std::vector<SeriesCost> RunFiles::costs() const {
  std::vector<SeriesCost> list;
  for (const Series& series : series_) list.push_back(series.cost());
  return list;
}

}  // namespace ballpark::command
