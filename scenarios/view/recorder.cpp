#include "scenarios/view/recorder.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "scenarios/view/touching.h"

namespace ballpark::view {
namespace {

std::string pace_label(const RunSettings& run) {
  return run.tolerance > 0 ? fmt::format("{}, tolerance {:.6g}", run.integrator, run.tolerance)
                           : fmt::format("{}, step {:.6g} s", run.integrator, run.step);
}

/// A component of a quaternion: -1..1.
std::uint16_t quantised(double component) {
  return static_cast<std::uint16_t>(std::lround((std::clamp(component, -1.0, 1.0) + 1) * 32767.5));
}

double kinetic_energy(const BodyState& body, const Inertia& inertia) {
  const Quaternion& q = body.orientation;
  const Vector3d axis(q.x, q.y, q.z), w = body.angular_velocity;
  const Vector3d turn = 2 * axis.cross(w);
  const Vector3d spin = w - q.w * turn + axis.cross(turn);  // in the body's axes
  return 0.5 * (inertia.mass * body.velocity.squaredNorm() + inertia.moments.dot(spin.cwiseProduct(spin)));
}

/// As the last frame had it; zero if there is none.
template <class T>
void repeat(std::vector<T>& column, std::size_t row_length) {
  const std::size_t size = column.size();
  column.push_back(size >= row_length ? column[size - row_length] : T());
}

}  // namespace

Recorder::Recorder(const Scene& scene, const Options& options, Columns columns, std::size_t frames, Limits limits)
    : scene_(scene), copies_(options.copies), columns_(columns), frames_(frames), limits_(limits), history_(scene) {
  recording_.scenario = scene.name;
  recording_.label = pace_label(scene.run);
  recording_.doc = scene.doc;
  recording_.boundaries = scene.boundaries;
}

double Recorder::bytes_per_body() const {
  return 12 + 6 * columns_.orientation + 4 * columns_.speed + 8 * columns_.energy + columns_.contacts;
}

void Recorder::begin(const World& world) {
  const double fit = limits_.memory / (bytes_per_body() * static_cast<double>(std::max<std::size_t>(frames_, 1)));
  const std::size_t most = std::max<std::size_t>(1, std::min(limits_.bodies, static_cast<std::size_t>(fit)));
  shown_ = shown_bodies(scene_, world, copies_, most);
  recording_.bodies = world.body_count();
  recording_.shown = shown_.ids.size();
  recording_.stride = shown_.stride;
  recording_.groups = shown_.groups;
  const bool any_turns =
      std::any_of(shown_.groups.begin(), shown_.groups.end(), [](const ShownGroup& group) { return group.turns; });
  columns_.orientation = columns_.orientation && any_turns;
  held_.resize(recording_.shown);
  recording_.position.reserve(3 * recording_.shown * frames_);
  if (recording_.shown == 0) return;
  const Vector3d first = world.body(shown_.ids.front()).position;
  if (first.allFinite()) recording_.origin = first;
}

void Recorder::add_body(const BodyState& body, std::size_t index) {
  const Vector3d place = body.position - recording_.origin;
  const Quaternion& q = body.orientation;
  const double speed = body.velocity.norm();
  const bool finite = place.cast<float>().allFinite() && std::isfinite(static_cast<float>(speed)) &&
                      std::isfinite(q.w + q.x + q.y + q.z) && body.angular_velocity.allFinite();
  const std::size_t row = recording_.shown;
  if (!finite) {
    held_count_ += !held_[index];
    held_[index] = true;
    for (int c = 0; c < 3; ++c) repeat(recording_.position, 3 * row);
    for (int c = 0; c < 3 && columns_.orientation; ++c) repeat(recording_.orientation, 3 * row);
    if (columns_.speed) repeat(recording_.speed, row);
    if (columns_.energy) repeat(recording_.energy, row);
    return;
  }
  for (int c = 0; c < 3; ++c) recording_.position.push_back(static_cast<float>(place[c]));
  if (columns_.orientation) {
    const double sign = q.w < 0 ? -1 : 1;
    for (const double component : {q.x, q.y, q.z}) recording_.orientation.push_back(quantised(sign * component));
  }
  if (columns_.speed) recording_.speed.push_back(static_cast<float>(speed));
  if (columns_.energy) recording_.energy.push_back(kinetic_energy(body, shown_.inertias[index]));
}

void Recorder::add(const World& world) {
  history_.add(world);
  if (frames() == 0) begin(world);
  for (std::size_t i = 0; i < shown_.ids.size(); ++i) add_body(world.body(shown_.ids[i]), i);
  if (columns_.contacts) {
    const std::vector<std::uint8_t> counts = touching(scene_, world, copies_);
    for (const std::size_t id : shown_.ids) recording_.contacts.push_back(counts[id]);
  }
  recording_.times.push_back(world.time());
  history_.go_on();
}

Recording Recorder::take() {
  recording_.series = history_.take();
  if (held_count_ > 0) {
    recording_.notes.push_back(
        fmt::format("{} of the shown bodies are no longer finite: they stay where they last were", held_count_));
  }
  return std::move(recording_);
}

}  // namespace ballpark::view
