#include "scenarios/command/view_options.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <tuple>
#include <utility>

#include "scenarios/command/errors.h"
#include "scenarios/command/frame_source.h"
#include "scenarios/command/scene_options.h"
#include "scenarios/command/text.h"
#include "scenarios/files/timetable.h"
#include "scenarios/view/frame_times.h"
#include "scenarios/view/shown.h"

namespace ballpark::command {
namespace {

constexpr std::size_t usual_frames = 301, still_frames = 61, most_frames = 100'000, most_runs = 8;

/// Cut at the commas that stand outside of brackets and quotes.
std::vector<std::string> values_of(const std::string& text) {
  std::vector<std::string> values(1);
  int depth = 0;
  bool quoted = false;
  for (const char c : text) {
    if (c == '"') quoted = !quoted;
    if (!quoted) depth += (c == '[' || c == '{') - (c == ']' || c == '}');
    if (c == ',' && depth == 0 && !quoted) {
      values.emplace_back();
    } else {
      values.back() += c;
    }
  }
  return values;
}

/// Options that mean nothing for what is asked for.
void refuse_all(const std::string& why, std::initializer_list<std::pair<const char*, bool>> given) {
  for (const auto& [name, there] : given) {
    if (there) throw UsageError(name + why);
  }
}

std::vector<ViewSubject> compared(const Arguments& arguments) {
  const std::string& text = *arguments.compare;
  const std::size_t equals = text.find('=');
  const std::vector<std::string> values = values_of(text.substr(std::min(equals, text.size() - 1) + 1));
  const bool empty = std::find(values.begin(), values.end(), "") != values.end();
  if (equals == std::string::npos || equals == 0 || values.size() < 2 || values.size() > most_runs || empty) {
    throw UsageError(fmt::format("--compare: '{}' is not a key with 2 to {} values (for example integrator=euler,rk4)",
                                 text, most_runs));
  }
  const std::string name = text.substr(0, equals), key = name.find('.') == std::string::npos ? "run." + name : name;
  std::vector<ViewSubject> subjects;
  for (const std::string& value : values) {
    Arguments one = arguments;
    one.overrides.push_back(key + "=" + value);
    subjects.push_back({load_scene(one), name + " = " + value});
  }
  return subjects;
}

/// Recorded files, which nothing runs.
std::vector<ViewSubject> recorded(const Arguments& arguments) {
  refuse_all(" is of runs: a recorded file is shown as it is",
             {{"--threads", arguments.threads.has_value()},
              {"--precision", arguments.precision.has_value()},
              {"--target", arguments.target.has_value()},
              {"--copies", arguments.copies.has_value()},
              {"--perturb", arguments.perturb.has_value()},
              {"--path", arguments.path.has_value()},
              {"--frames", arguments.frames.has_value()},
              {"--every", arguments.every.has_value()},
              {"--compare", arguments.compare.has_value()},
              {"--set without --scene", !arguments.overrides.empty() && !arguments.scene}});
  ViewSubject subject;
  if (arguments.scene) {
    Arguments of_scene = arguments;
    of_scene.name = *arguments.scene;
    subject.file = load_scene(of_scene);
  }
  subject.frames = arguments.name;
  std::vector<ViewSubject> subjects{subject};
  if (!arguments.with) return subjects;
  if (!is_frame_file(*arguments.with)) throw UsageError("--with: beside a recorded file goes another recorded file");
  subject.frames = *arguments.with;
  subjects.push_back(subject);
  return subjects;
}

std::vector<ViewSubject> subjects_of(const Arguments& arguments) {
  if (is_frame_file(arguments.name)) return recorded(arguments);
  if (arguments.scene) throw UsageError("--scene is of recorded files: it tells what was run");
  if (arguments.with && is_frame_file(*arguments.with)) {
    throw UsageError("--with: beside a scene goes another scene; two recorded files go together");
  }
  if (arguments.compare && arguments.with) throw UsageError("--with and --compare exclude each other");
  if (arguments.compare) return compared(arguments);
  std::vector<ViewSubject> subjects{{load_scene(arguments), ""}};
  if (!arguments.with) return subjects;
  Arguments other = arguments;
  other.name = *arguments.with;
  subjects.push_back({load_scene(other), ""});
  for (ViewSubject& subject : subjects) {
    const Scene& scene = subject.file.scene;
    subject.label = fmt::format("{}: {}", scene.name, pace_text(scene.run));
  }
  return subjects;
}

view::Columns columns_of(const std::optional<std::string>& text) {
  view::Columns columns;
  if (!text) return columns;
  bool position = true;  // always there
  const std::map<std::string, bool*> by_name{{"position", &position},
                                             {"orientation", &columns.orientation},
                                             {"speed", &columns.speed},
                                             {"energy", &columns.energy},
                                             {"contacts", &columns.contacts}};
  for (const auto& [name, column] : by_name) *column = false;
  for (const std::string& name : values_of(*text)) {
    const auto found = by_name.find(name);
    if (found == by_name.end()) {
      throw UsageError("--columns: " +
                       no_such("column", name, {"position", "orientation", "speed", "energy", "contacts"}));
    }
    *found->second = true;
  }
  return columns;
}

/// 30M; powers of 1000, as sizes are printed.
std::size_t size_limit(const std::string& text) {
  std::string digits = text;
  double unit = 1;
  const std::map<char, double> units{{'k', 1e3}, {'M', 1e6}, {'G', 1e9}};
  if (const auto found = digits.empty() ? units.end() : units.find(digits.back()); found != units.end()) {
    unit = found->second;
    digits.pop_back();
  }
  return static_cast<std::size_t>(std::min(real_number("--max-size", digits, false) * unit, 1e18));
}

std::pair<int, int> picture_size(const std::string& text) {
  const std::size_t cross = std::min(text.find('x'), text.size());
  const auto side = [&](const std::string& number) {
    return static_cast<int>(whole_number("--size (WIDTHxHEIGHT)", number, 16, 8192));
  };
  return {side(text.substr(0, cross)), side(cross < text.size() ? text.substr(cross + 1) : "")};
}

view::ColourBy colour_named(const std::string& word) {
  const std::map<std::string, view::ColourBy> colours{
      {"speed", view::ColourBy::speed}, {"group", view::ColourBy::group}, {"plain", view::ColourBy::plain}};
  const auto found = colours.find(word);
  if (found == colours.end()) throw UsageError("--colour: " + no_such("colour", word, {"speed", "group", "plain"}));
  return found->second;
}

Vector3d direction(const std::string& text) {
  Vector3d from = Vector3d::Zero();
  const std::vector<std::string> parts = values_of(text);
  for (std::size_t c = 0; c < 3 && parts.size() == 3; ++c) {
    const bool negative = parts[c].starts_with('-');
    const double size = real_number("--from", parts[c].substr(negative), true);
    from[static_cast<Eigen::Index>(c)] = negative ? -size : size;
  }
  if (from.cwiseAbs().maxCoeff() > 0) return from;
  throw UsageError(fmt::format("--from: '{}' is not a direction x,y,z (for example 1,-1.6,0.9)", text));
}

Still still_of(const Arguments& arguments) {
  refuse_all(" is of pages: it does not go with --still", {{"--frames", arguments.frames.has_value()},
                                                           {"--every", arguments.every.has_value()},
                                                           {"--max-size", arguments.max_size.has_value()},
                                                           {"--columns", arguments.columns.has_value()},
                                                           {"--with", arguments.with.has_value()},
                                                           {"--compare", arguments.compare.has_value()}});
  Still still;
  if (arguments.size) std::tie(still.width, still.height) = picture_size(*arguments.size);
  if (arguments.colour) still.colour = colour_named(*arguments.colour);
  if (arguments.from) still.from = direction(*arguments.from);
  still.time = real_number("--still", *arguments.still, true);
  return still;
}

/// A run ends at the moment that is wanted of it, which is at its nearest step.
double cut_at(RunSettings& run, double time) {
  if (time > run.duration * (1 + 1e-12)) {
    throw UsageError(
        fmt::format("--still: {} s is beyond the end of the run at {} s", number(time), number(run.duration)));
  }
  const scenes::Pace pace(run);
  run.duration = pace.by_steps() ? pace.at(time) * run.step : pace.at(time);
  return run.duration;
}

std::vector<double> page_times(const Arguments& arguments, const std::vector<ViewSubject>& subjects) {
  if (arguments.frames && arguments.every) throw UsageError("--frames and --every exclude each other");
  double end = 0;
  for (const ViewSubject& subject : subjects) end = std::max(end, subject.file.scene.run.duration);
  const std::size_t frames =
      arguments.frames ? whole_number("--frames", *arguments.frames, 1, most_frames) : usual_frames;
  if (!arguments.every) return view::frame_times(end, frames);
  const double every = real_number("--every", *arguments.every, false);
  if (end / every > static_cast<double>(most_frames)) {
    throw UsageError(fmt::format("--every: {} s make more than {} frames", number(every), grouped(most_frames)));
  }
  return view::frame_times(end, frames, every);
}

/// The file's name, or one after the scene in the current folder.
std::string destination(const Arguments& arguments, const ViewRequest& request) {
  const ViewSubject& first = request.subjects.front();
  const std::string stem = std::filesystem::path(first.runs() ? first.file.path : first.frames).stem().string();
  const std::string out = arguments.out.value_or(stem + (request.still ? ".png" : ".html"));
  const std::string ending = std::filesystem::path(out).extension().string();
  const bool known = request.still ? ending == ".png" || ending == ".svg" : ending == ".html";
  if (!known) {
    throw UsageError(fmt::format("--out: '{}' must end in {}", out,
                                 request.still ? ".png or .svg" : ".html (or, with --still T, in .png or .svg)"));
  }
  for (const ViewSubject& subject : request.subjects) {
    if (subject.scene()) refuse_inputs({out}, subject.file);
  }
  const bool json_too = arguments.json && !arguments.json->empty() && same_file(out, *arguments.json);
  if (json_too) throw UsageError(fmt::format("'{}' would be written twice: give each its own file", out));
  return out;
}

/// Many balls that spin are not made to show it: an orientation takes more room than a position.
void let_turn(std::vector<ViewSubject>& subjects, const Options& options, bool asked) {
  constexpr std::size_t few = 1000;
  for (ViewSubject& subject : subjects) {
    Scene& scene = subject.file.scene;
    if (!asked && body_count(scene) * static_cast<std::size_t>(options.copies) > few) continue;
    view::let_spinning_balls_turn(scene, options);
  }
}

}  // namespace

ViewRequest view_request(const Arguments& arguments, const Options& options) {
  ViewRequest request;
  request.columns = columns_of(arguments.columns);
  request.columns_asked = arguments.columns.has_value();
  if (arguments.max_size) request.max_size = size_limit(*arguments.max_size);
  if (arguments.still) {
    request.still = still_of(arguments);
  } else {
    refuse_all(" is of pictures: it needs --still T", {{"--size", arguments.size.has_value()},
                                                       {"--colour", arguments.colour.has_value()},
                                                       {"--from", arguments.from.has_value()}});
  }
  request.subjects = subjects_of(arguments);
  request.out = destination(arguments, request);
  if (!request.subjects[0].runs()) return request;
  for (const ViewSubject& subject : request.subjects) check_memory(subject.file.scene, options);
  request.times = request.still
                      ? view::frame_times(cut_at(request.subjects[0].file.scene.run, request.still->time), still_frames)
                      : page_times(arguments, request.subjects);
  if (request.columns.orientation) let_turn(request.subjects, options, request.columns_asked);
  return request;
}

}  // namespace ballpark::command
