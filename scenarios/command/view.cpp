// ballpark view: a page that plays a scene's motion, or a picture of one moment.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <utility>

#include "ballpark/scenes.h"
#include "scenarios/command/commands.h"
#include "scenarios/command/deliver.h"
#include "scenarios/command/recorded_motion.h"
#include "scenarios/command/scene_options.h"
#include "scenarios/command/terminal.h"
#include "scenarios/command/text.h"
#include "scenarios/command/view_options.h"
#include "scenarios/view/encode.h"
#include "scenarios/view/frame_times.h"
#include "scenarios/view/page.h"

namespace ballpark::command {
namespace {

using scenes::RunReport;
using view::Encoded;
using view::Recording;

struct Recorded {
  Recording recording;
  RunReport report;
};

/// Of each of the runs.
view::Limits limits_of(const ViewRequest& request) {
  return {.memory = view::Limits{}.memory / static_cast<double>(request.subjects.size())};
}

/// Runs the scene with frames at these times, and nothing else of what its file asks for.
Recorded record(const ViewSubject& subject, const ViewRequest& request, const Options& options, bool quiet) {
  scenes::SceneFile file = subject.file;
  file.expectations.clear();
  file.events.clear();
  scenes::OutputRequest frames;
  frames.at = request.times;
  file.outputs = {frames};
  view::Recorder recorder(file.scene, options, request.columns, view::frames_of(file.scene.run, request.times),
                          limits_of(request));
  Progress progress(file.scene.name, !quiet);
  scenes::RunHooks hooks;
  hooks.writers = {[&](const World& world) { recorder.add(world); }};
  hooks.progress = [&](double fraction) {
    progress.show(fraction);
    return !interrupted();
  };
  Recorded recorded;
  recorded.report = scenes::run(file, options, hooks);
  recorded.recording = recorder.take();
  if (!subject.label.empty()) recorded.recording.label = subject.label;
  std::vector<std::string>& notes = recorded.recording.notes;
  if (recorded.report.interrupted) {
    notes.push_back(
        fmt::format("interrupted at {} s of {} s", number(recorded.report.time), number(file.scene.run.duration)));
  }
  if (recorded.report.status.code != Status::Code::ok) notes.push_back(recorded.report.status.sentence);
  return recorded;
}

/// The frames of a file.
Recorded read(const ViewSubject& subject, const ViewRequest& request) {
  Recorded recorded;
  const auto go_on = [&] { return !(recorded.report.interrupted = interrupted()); };
  MotionRequest motion{subject.frames, subject.scene(), request.columns, request.columns_asked, {}, limits_of(request)};
  if (request.still) motion.until = request.still->time;
  recorded.recording = recorded_motion(motion, go_on);
  recorded.report.time = recorded.recording.times.empty() ? 0 : recorded.recording.times.back();
  return recorded;
}

std::vector<Recorded> record_all(const ViewRequest& request, const Options& options, bool quiet) {
  std::vector<Recorded> all;
  for (const ViewSubject& subject : request.subjects) {
    if (!all.empty() && interrupted()) break;
    all.push_back(subject.runs() ? record(subject, request, options, quiet) : read(subject, request));
  }
  return all;
}

Exit exit_code(const std::vector<Recorded>& all, const ViewRequest& request) {
  if (all.back().report.interrupted || all.size() < request.subjects.size()) return interrupted_exit;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Status& status = all[i].report.status;
    if (status.code != Status::Code::ok && !accepted(request.subjects[i].file.scene, status)) return contract_left;
  }
  return done;
}

std::string title_of(const std::vector<Recorded>& all) {
  std::string title = all.front().recording.scenario;
  for (const Recorded& one : all) {
    if (one.recording.scenario != all.front().recording.scenario) title += " and " + one.recording.scenario;
  }
  return title;
}

/// Bytes that a page has for its runs. Throws UsageError.
std::size_t room_of(const ViewRequest& request, const std::string& title) {
  constexpr std::size_t marks = 100;  // around the data of a run
  const std::size_t own = view::page_size(title) + marks * request.subjects.size();
  if (request.max_size > own) return request.max_size - own;
  throw UsageError(fmt::format("--max-size: {} are not enough: a page without bodies takes {}",
                               bytes(static_cast<double>(request.max_size)), bytes(static_cast<double>(own))));
}

std::vector<Encoded> encoded(const std::vector<Recorded>& all, const ViewRequest& request) {
  std::vector<const Recording*> recordings;
  for (const Recorded& one : all) recordings.push_back(&one.recording);
  std::optional<std::vector<Encoded>> runs = view::encode_within(recordings, room_of(request, title_of(all)));
  if (runs) return std::move(*runs);
  throw UsageError(fmt::format("--max-size: {} are not enough for one body of each group in {} frames",
                               bytes(static_cast<double>(request.max_size)), recordings[0]->times.size()));
}

std::string columns_text(const Encoded& run) {
  std::vector<std::string> parts;
  for (const Encoded::Column& column : run.columns) {
    parts.push_back(column.name + " " + bytes(static_cast<double>(column.bytes)));
  }
  return joined(parts);
}

std::string text_of(const std::vector<Recorded>& all, const std::vector<Encoded>& runs, const std::string& path,
                    std::size_t size) {
  Page text = page();
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const Encoded& run = runs[i];
    const std::string of = run.stride > 1 ? " of " + grouped(run.bodies) : "";
    text.heading(fmt::format("{}: {}", all[i].recording.scenario, all[i].recording.label));
    text.fields({{"bodies", grouped(run.shown) + of},
                 {"frames", fmt::format("{} until {} s", grouped(run.frames), number(all[i].report.time))},
                 {"columns", columns_text(run)}});
    text.list(run.notes);
  }
  text.blank();
  text.line(fmt::format("  wrote {} ({})", path, bytes(static_cast<double>(size))));
  return text.text();
}

Json json_of(const std::vector<Recorded>& all, const std::vector<Encoded>& runs, const std::string& path,
             std::size_t size) {
  Json list = Json::array();
  for (std::size_t i = 0; i < runs.size(); ++i) {
    Json columns = Json::object();
    for (const Encoded::Column& column : runs[i].columns) columns[column.name] = column.bytes;
    list.push_back({{"scenario", all[i].recording.scenario},
                    {"label", all[i].recording.label},
                    {"bodies", runs[i].bodies},
                    {"shown", runs[i].shown},
                    {"stride", runs[i].stride},
                    {"frames", runs[i].frames},
                    {"bytes", columns},
                    {"notes", runs[i].notes}});
  }
  return {{"file", path}, {"bytes", size}, {"runs", list}};
}

void write(OutputFile& file, const std::string& content) {
  file.write(content);
  file.commit();
}

void warn_of(const std::vector<Recorded>& all, const std::vector<Encoded>& runs) {
  for (std::size_t i = 0; i < runs.size(); ++i) {
    std::vector<std::string> warnings = all[i].report.warnings;
    if (runs[i].stride > 1) {
      warnings.push_back(fmt::format("{} of {} bodies are shown, one in {}", grouped(runs[i].shown),
                                     grouped(runs[i].bodies), grouped(runs[i].stride)));
    }
    warn(warnings);
  }
}

void write_page(const std::vector<Recorded>& all, const ViewRequest& request, OutputFile& file, Delivery& delivery,
                bool quiet) {
  const std::vector<Encoded> runs = encoded(all, request);
  const std::string content = view::page(title_of(all), runs);
  write(file, content);
  delivery.text(text_of(all, runs, file.path(), content.size()));
  delivery.json(json_of(all, runs, file.path(), content.size()).dump(2, ' ', false, Json::error_handler_t::replace));
  if (!quiet) warn_of(all, runs);
}

void write_picture(const Recorded& one, const ViewRequest& request, OutputFile& file, Delivery& delivery) {
  const Still& still = *request.still;
  const Recording& recording = one.recording;
  const bool grey = recording.speed.empty() && still.colour == view::ColourBy::speed;
  const view::Drawing drawing =
      view::drawing_of(recording, recording.times.size() - 1, grey ? view::ColourBy::plain : still.colour);
  const bool vector = std::filesystem::path(file.path()).extension() == ".svg";
  const Vector3d from = still.from.value_or(view::usual_direction(drawing.box));
  const std::string content = vector ? view::svg(drawing, from, still.width, still.height)
                                     : view::png(view::picture(drawing, from, still.width, still.height));
  write(file, content);
  const std::string of = recording.stride > 1 ? " of " + grouped(recording.bodies) : "";
  delivery.text(fmt::format("{} at {} s: {}{} {}\n\n  wrote {} ({})\n", recording.scenario,
                            number(recording.times.back()), grouped(recording.shown), of,
                            recording.bodies == 1 ? "body" : "bodies", file.path(),
                            bytes(static_cast<double>(content.size()))));
  const Json json{{"file", file.path()},
                  {"bytes", content.size()},
                  {"scenario", recording.scenario},
                  {"time", recording.times.back()},
                  {"bodies", recording.bodies},
                  {"shown", recording.shown}};
  delivery.json(json.dump(2, ' ', false, Json::error_handler_t::replace));
}

}  // namespace

Exit view_motion(const Arguments& arguments) {
  const Options options = run_options(arguments);
  const ViewRequest request = view_request(arguments, options);
  if (!request.still) room_of(request, "");  // before anything runs
  OutputFile file(request.out);
  Delivery delivery(arguments);
  watch_for_interrupt();
  const std::vector<Recorded> all = record_all(request, options, arguments.quiet);
  const Exit code = exit_code(all, request);
  if (!request.still) {
    write_page(all, request, file, delivery, arguments.quiet);
  } else if (code != interrupted_exit) {
    write_picture(all.front(), request, file, delivery);
  } else {
    complain(fmt::format("'{}' was not written: the run did not reach the moment", request.out));
  }
  const bool told = !request.still && !arguments.quiet;  // among the warnings
  for (const Recorded& one : all) {
    const Status& status = one.report.status;
    if (code == contract_left && !told && status.code != Status::Code::ok) complain(status.sentence);
  }
  return code;
}

}  // namespace ballpark::command
