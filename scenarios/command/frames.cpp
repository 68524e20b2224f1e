#include "scenarios/command/frames.h"

#include <algorithm>
#include <cmath>

#include "scenarios/command/scene_options.h"
#include "scenarios/files/output_formats.h"

namespace ballpark::command {
namespace {

/// What any body carries.
std::vector<std::string> carried(const World& world) {
  bool orientation = false, angular_velocity = false;
  for (std::size_t id = 0; id < world.body_count(); ++id) {
    const BodyState body = world.body(id);
    orientation |= body.has_orientation;
    angular_velocity |= body.has_angular_velocity;
    if (orientation && angular_velocity) break;
  }
  std::vector<std::string> names{"position", "velocity"};
  if (orientation) names.push_back("orientation");
  if (angular_velocity) names.push_back("angular_velocity");
  return names;
}

bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

std::vector<FrameColumn> columns_named(const std::vector<std::string>& names) {
  std::vector<FrameColumn> columns;
  for (const FrameColumn& column : known_columns()) {
    if (contains(names, column.name)) columns.push_back(column);
  }
  return columns;
}

/// Of each body of one copy of the scene; empty if none has one.
std::vector<double> radii(const Scene& scene) {
  std::vector<double> list;
  bool any = false;
  for (const BodyGroup& group : scene.bodies) {
    const std::vector<double>& given = group.radius;
    any |= !given.empty();
    for (std::size_t row = 0; row < body_count(group); ++row) {
      list.push_back(given.empty() ? 0 : given[given.size() == 1 ? 0 : row]);
    }
  }
  return any ? list : std::vector<double>();
}

/// Position or velocity straight from the world's columns: the quick way, for what every body has.
template <class Real>
void append_view(const World& world, const std::string& name, const std::vector<std::size_t>& rows,
                 std::vector<double>& to) {
  const std::size_t before = to.size();
  to.resize(before + 3 * rows.size());
  if (rows.empty()) return;
  const View<Real> view = world.view<Real>(name);
  const Real *x = view[0].data(), *y = view[1].data(), *z = view[2].data();
  double* out = to.data() + before;
  for (const std::size_t world_row : rows) {
    const std::size_t row = world_row - view.first_row;
    *out++ = static_cast<double>(x[row]);
    *out++ = static_cast<double>(y[row]);
    *out++ = static_cast<double>(z[row]);
  }
}

void append_view_of(const World& world, const std::string& name, const std::vector<std::size_t>& rows,
                    std::vector<double>& to) {
  switch (world.precision()) {
    case Precision::single_:
      return append_view<float>(world, name, rows, to);
    case Precision::double_:
      return append_view<double>(world, name, rows, to);
    case Precision::extended:
      return append_view<long double>(world, name, rows, to);
  }
}

void append_orientations(const World& world, std::vector<double>& to) {
  for (std::size_t id = 0; id < world.body_count(); ++id) {
    const Quaternion q = world.body(id).orientation;
    to.insert(to.end(), {q.w, q.x, q.y, q.z});
  }
}

void append_angular_velocities(const World& world, std::vector<double>& to) {
  for (std::size_t id = 0; id < world.body_count(); ++id) {
    const Vector3d w = world.body(id).angular_velocity;
    to.insert(to.end(), {w.x(), w.y(), w.z()});
  }
}

}  // namespace

std::vector<std::int32_t> present(const FrameLayout& layout, const Frames& frames, std::size_t frame) {
  std::vector<std::int32_t> ids;
  const auto position = std::find_if(layout.columns.begin(), layout.columns.end(),
                                     [](const FrameColumn& column) { return column.name == "position"; });
  const bool known = position != layout.columns.end();
  const auto places = known ? frames.values(static_cast<std::size_t>(position - layout.columns.begin()), frame)
                            : std::span<const double>();
  for (std::size_t id = 0; id < layout.bodies; ++id) {
    if (!known || !std::isnan(places[3 * id])) ids.push_back(static_cast<std::int32_t>(id));
  }
  return ids;
}

const std::vector<FrameColumn>& known_columns() {
  static const std::vector<FrameColumn> columns = {
      {"position", {"x", "y", "z"}},    {"orientation", {"qw", "qx", "qy", "qz"}},
      {"velocity", {"vx", "vy", "vz"}}, {"angular_velocity", {"wx", "wy", "wz"}},
      {"contacts", {"contacts"}},       {"contact_force", {"fx", "fy", "fz"}}};
  return columns;
}

FrameLayout layout_without_bodies(const scenes::OutputRequest& request) {
  if (!request.columns.empty()) return {0, columns_named(request.columns), {}};
  return {0, columns_named({"position", "velocity"}), {}};
}

std::size_t Frames::bytes() const {
  std::size_t numbers = times.size();
  for (const std::vector<double>& column : columns) numbers += column.size();
  return numbers * sizeof(double);
}

void Frames::clear() {
  times.clear();
  for (std::vector<double>& column : columns) column.clear();
}

std::span<const double> Frames::values(std::size_t column, std::size_t frame) const {
  const std::size_t size = columns[column].size() / count();
  return std::span(columns[column]).subspan(frame * size, size);
}

FrameReader::FrameReader(const World& world, const Scene& scene, const scenes::OutputRequest& request) {
  layout_.bodies = world.body_count();
  layout_.columns = columns_named(request.columns.empty() ? carried(world) : request.columns);
  const scenes::OutputFormat* format = scenes::output_format(request.file);
  const bool drawn = format && format->drawn && request.columns.empty();
  if (drawn || contains(request.columns, "radius")) {
    const std::vector<double> of_copy = radii(scene);
    if (!drawn || !of_copy.empty()) layout_.radius.resize(layout_.bodies, 0);
    for (std::size_t id = 0; id < layout_.bodies && !of_copy.empty(); ++id) {
      layout_.radius[id] = of_copy[id % of_copy.size()];
    }
  }
  rows_.reserve(layout_.bodies);
  for (std::size_t id = 0; id < layout_.bodies; ++id) rows_.push_back(world.row_of(id));
}

void FrameReader::add(const World& world, Frames& frames) const {
  const auto of_contacts = [](const FrameColumn& column) { return column.name.starts_with("contact"); };
  const bool touched = std::any_of(layout_.columns.begin(), layout_.columns.end(), of_contacts);
  const std::vector<ContactLoad> loads = touched ? world.contact_loads() : std::vector<ContactLoad>();
  frames.columns.resize(layout_.columns.size());
  frames.times.push_back(world.time());
  for (std::size_t c = 0; c < layout_.columns.size(); ++c) {
    const std::string& name = layout_.columns[c].name;
    std::vector<double>& values = frames.columns[c];
    if (name == "orientation") {
      append_orientations(world, values);
    } else if (name == "angular_velocity") {
      append_angular_velocities(world, values);
    } else if (name == "contacts") {
      for (const ContactLoad& load : loads) values.push_back(load.contacts);
    } else if (name == "contact_force") {
      for (const ContactLoad& load : loads) values.insert(values.end(), load.force.begin(), load.force.end());
    } else {
      append_view_of(world, name, rows_, values);
    }
  }
}

}  // namespace ballpark::command
