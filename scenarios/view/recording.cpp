#include "scenarios/view/recording.h"

#include <algorithm>
#include <cmath>

namespace ballpark::view {
namespace {

/// The kept bodies' rows of a column.
template <class T>
std::vector<T> rows_of(const std::vector<T>& column, std::size_t components, std::size_t bodies,
                       const std::vector<std::size_t>& kept) {
  std::vector<T> rows;
  rows.reserve(bodies ? column.size() / bodies * kept.size() : 0);
  for (std::size_t frame = 0; frame < column.size(); frame += bodies * components) {
    for (const std::size_t body : kept) {
      const auto row = column.begin() + static_cast<std::ptrdiff_t>(frame + body * components);
      rows.insert(rows.end(), row, row + static_cast<std::ptrdiff_t>(components));
    }
  }
  return rows;
}

}  // namespace

Box box_of(const Recording& recording) {
  Box box;
  bool found = false;
  for (std::size_t i = 0; i + 2 < recording.position.size(); i += 3) {
    const Vector3d p(recording.position[i], recording.position[i + 1], recording.position[i + 2]);
    if (!p.allFinite()) continue;
    box.low = found ? box.low.cwiseMin(p).eval() : p;
    box.high = found ? box.high.cwiseMax(p).eval() : p;
    found = true;
  }
  return box;
}

double point_radius(const Recording& recording, const Box& box) {
  const double size = box.diagonal() > 0 ? box.diagonal() : 1;
  return size * std::min(0.015, 0.1 / std::cbrt(static_cast<double>(std::max<std::size_t>(recording.shown, 1))));
}

Quaternion orientation_of(const Recording& recording, std::size_t frame, std::size_t body) {
  if (recording.orientation.empty()) return {};
  const std::uint16_t* q = &recording.orientation[3 * (frame * recording.shown + body)];
  const auto value = [&](int c) { return q[c] / 32767.5 - 1; };
  const double rest = 1 - value(0) * value(0) - value(1) * value(1) - value(2) * value(2);
  return {std::sqrt(std::max(0.0, rest)), value(0), value(1), value(2)};
}

Recording thinned(const Recording& recording, std::size_t factor) {
  Recording thin;
  thin.scenario = recording.scenario, thin.label = recording.label, thin.doc = recording.doc;
  thin.bodies = recording.bodies;
  thin.times = recording.times;
  thin.groups = recording.groups;
  thin.boundaries = recording.boundaries;
  thin.origin = recording.origin;
  thin.series = recording.series;
  thin.notes = recording.notes;
  std::vector<std::size_t> kept;
  for (ShownGroup& group : thin.groups) {
    const ShownGroup all = group;
    group.first = kept.size();
    if (all.radius.size() > 1) group.radius.clear();
    for (std::size_t row = 0; row < all.count; row += factor) {
      kept.push_back(all.first + row);
      if (all.radius.size() > 1) group.radius.push_back(all.radius[row]);
    }
    group.count = kept.size() - group.first;
  }
  thin.stride = recording.stride * factor;
  thin.shown = kept.size();
  thin.position = rows_of(recording.position, 3, recording.shown, kept);
  thin.orientation = rows_of(recording.orientation, 3, recording.shown, kept);
  thin.speed = rows_of(recording.speed, 1, recording.shown, kept);
  thin.energy = rows_of(recording.energy, 1, recording.shown, kept);
  thin.contacts = rows_of(recording.contacts, 1, recording.shown, kept);
  return thin;
}

}  // namespace ballpark::view
