#include "scenarios/view/recorder.h"

#include <fmt/format.h>

#include "scenarios/view/touching.h"

namespace ballpark::view {
namespace {

std::string pace_label(const RunSettings& run) {
  return run.tolerance > 0 ? fmt::format("{}, tolerance {:.6g}", run.integrator, run.tolerance)
                           : fmt::format("{}, step {:.6g} s", run.integrator, run.step);
}

}  // namespace

Recorder::Recorder(const Scene& scene, const Options& options, Columns columns, std::size_t frames, Limits limits)
    : scene_(scene), copies_(options.copies), columns_(columns), frames_(frames), limits_(limits), history_(scene) {}

void Recorder::begin(const World& world) {
  const ShownBodies shown = shown_bodies(scene_, world, copies_, limits_.shown(columns_, frames_));
  const Vector3d origin = shown.ids.empty() ? Vector3d::Zero().eval() : world.body(shown.ids.front()).position;
  film_.begin(shown, columns_, frames_, world.body_count(), origin);
}

void Recorder::add(const World& world) {
  history_.add(world);
  if (film_.frames() == 0) begin(world);
  const std::vector<std::uint8_t> contacts =
      columns_.contacts ? touching(scene_, world, copies_) : std::vector<std::uint8_t>(world.body_count());
  for (const std::size_t id : film_.shown().ids) film_.add(world.body(id), contacts[id]);
  film_.end_frame(world.time());
  history_.go_on();
}

Recording Recorder::take() {
  Recording recording = film_.take();
  recording.scenario = scene_.name;
  recording.label = pace_label(scene_.run);
  recording.doc = scene_.doc;
  recording.boundaries = scene_.boundaries;
  recording.series = history_.take();
  return recording;
}

}  // namespace ballpark::view
