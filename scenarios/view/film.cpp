#include "scenarios/view/film.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

namespace ballpark::view {
namespace {

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

std::size_t Limits::shown(const Columns& columns, std::size_t frames) const {
  const int per_body = 12 + 6 * columns.orientation + 4 * columns.speed + 8 * columns.energy + columns.contacts;
  const double fit = memory / (per_body * static_cast<double>(std::max<std::size_t>(frames, 1)));
  return std::max<std::size_t>(1, std::min(bodies, static_cast<std::size_t>(fit)));
}

void Film::begin(const ShownBodies& shown, Columns columns, std::size_t frames, std::size_t bodies,
                 const Vector3d& origin) {
  shown_ = shown;
  columns_ = columns;
  const auto turns = [](const ShownGroup& group) { return group.turns; };
  columns_.orientation = columns.orientation && std::any_of(shown.groups.begin(), shown.groups.end(), turns);
  recording_.bodies = bodies;
  recording_.shown = shown_.ids.size();
  recording_.stride = shown_.stride;
  recording_.groups = shown_.groups;
  recording_.position.reserve(3 * recording_.shown * frames);
  if (origin.allFinite()) recording_.origin = origin;
  held_.resize(recording_.shown);
}

void Film::add(const BodyState& body, std::uint8_t contacts) {
  const Vector3d place = body.position - recording_.origin;
  const Quaternion& q = body.orientation;
  const double speed = body.velocity.norm();
  const bool finite = place.cast<float>().allFinite() && std::isfinite(static_cast<float>(speed)) &&
                      std::isfinite(q.w + q.x + q.y + q.z) && body.angular_velocity.allFinite();
  if (columns_.contacts) recording_.contacts.push_back(contacts);
  if (!body.present) {
    leave_out();
  } else if (finite) {
    for (int c = 0; c < 3; ++c) recording_.position.push_back(static_cast<float>(place[c]));
    const double sign = q.w < 0 ? -1 : 1;
    for (const double component : {q.x, q.y, q.z}) {
      if (columns_.orientation) recording_.orientation.push_back(quantised(sign * component));
    }
    if (columns_.speed) recording_.speed.push_back(static_cast<float>(speed));
    if (columns_.energy) recording_.energy.push_back(kinetic_energy(body, shown_.inertias[at_]));
  } else {
    hold();
  }
  ++at_;
}

/// Nobody there: a place that is not drawn.
void Film::leave_out() {
  for (int c = 0; c < 3; ++c) recording_.position.push_back(std::numeric_limits<float>::quiet_NaN());
  for (int c = 0; c < 3 && columns_.orientation; ++c) recording_.orientation.push_back(quantised(0));
  if (columns_.speed) recording_.speed.push_back(0);
  if (columns_.energy) recording_.energy.push_back(0);
}

void Film::hold() {
  const std::size_t row = recording_.shown;
  held_count_ += !held_[at_];
  held_[at_] = true;
  for (int c = 0; c < 3; ++c) repeat(recording_.position, 3 * row);
  for (int c = 0; c < 3 && columns_.orientation; ++c) repeat(recording_.orientation, 3 * row);
  if (columns_.speed) repeat(recording_.speed, row);
  if (columns_.energy) repeat(recording_.energy, row);
}

void Film::end_frame(double time) {
  recording_.times.push_back(time);
  at_ = 0;
}

Recording Film::take() {
  if (held_count_ > 0) {
    recording_.notes.push_back(
        fmt::format("{} of the shown bodies are no longer finite: they stay where they last were", held_count_));
  }
  return std::move(recording_);
}

}  // namespace ballpark::view
