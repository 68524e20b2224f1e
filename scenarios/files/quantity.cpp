#include "scenarios/files/quantity.h"

#include <fmt/format.h>

#include <charconv>
#include <limits>

#include "scenarios/files/values.h"

namespace ballpark::scenes {

namespace {

/// A column of a body's state, and whether a body carries it.
struct Column {
  const char* name;
  double (*value)(const BodyState&);
  bool (*carried)(const BodyState&);
};

bool always(const BodyState&) {
  return true;
}
bool oriented(const BodyState& body) {
  return body.has_orientation;
}
bool spinning(const BodyState& body) {
  return body.has_angular_velocity;
}

constexpr Column columns[] = {
    {"x", [](const BodyState& b) { return b.position.x(); }, always},
    {"y", [](const BodyState& b) { return b.position.y(); }, always},
    {"z", [](const BodyState& b) { return b.position.z(); }, always},
    {"vx", [](const BodyState& b) { return b.velocity.x(); }, always},
    {"vy", [](const BodyState& b) { return b.velocity.y(); }, always},
    {"vz", [](const BodyState& b) { return b.velocity.z(); }, always},
    {"qw", [](const BodyState& b) { return b.orientation.w; }, oriented},
    {"qx", [](const BodyState& b) { return b.orientation.x; }, oriented},
    {"qy", [](const BodyState& b) { return b.orientation.y; }, oriented},
    {"qz", [](const BodyState& b) { return b.orientation.z; }, oriented},
    {"wx", [](const BodyState& b) { return b.angular_velocity.x(); }, spinning},
    {"wy", [](const BodyState& b) { return b.angular_velocity.y(); }, spinning},
    {"wz", [](const BodyState& b) { return b.angular_velocity.z(); }, spinning},
};

const Column* column_of(const std::string& name) {
  for (const Column& column : columns) {
    if (column.name == name) return &column;
  }
  return nullptr;
}

std::vector<std::string> carried_names(const BodyState& body) {
  std::vector<std::string> names;
  for (const Column& column : columns) {
    if (column.carried(body)) names.push_back(column.name);
  }
  return names;
}

std::vector<std::string> split(const std::string& path) {
  std::vector<std::string> segments(1);
  for (const char letter : path) {
    if (letter == '.') {
      segments.emplace_back();
    } else {
      segments.back() += letter;
    }
  }
  return segments;
}

std::optional<std::size_t> whole(const std::string& text) {
  std::size_t number = 0;
  const char* end = text.data() + text.size();
  const auto result = std::from_chars(text.data(), end, number);
  if (result.ec != std::errc{} || result.ptr != end) return std::nullopt;
  return number;
}

/// The names inside an object; those of lists are left out, their lengths differ from run to run.
std::vector<std::string> names_in(const Json& json) {
  std::vector<std::string> names;
  if (!json.is_object()) return names;
  for (const auto& item : json.items()) {
    if (!item.value().is_array()) names.push_back(item.key());
  }
  return names;
}

/// By name, or in a list by index.
const Json* find_in(const Json& json, const std::string& name) {
  if (json.is_array()) {
    const std::optional<std::size_t> index = whole(name);
    return index && *index < json.size() ? &json[*index] : nullptr;
  }
  if (!json.is_object()) return nullptr;
  const auto found = json.find(name);
  return found == json.end() ? nullptr : &*found;
}

/// The one list whose numbers are quantities: empty at the start, it grows as the run goes.
constexpr const char* times_of_event = "times";

std::string index_problem(const std::string& index) {
  const std::optional<std::size_t> k = whole(index);
  if (k && *k < most_event_times) return "";
  return fmt::format("there is no \"{}\" in {}, expected a whole number below {}", printable(index), times_of_event,
                     most_event_times);
}

}  // namespace

Quantity::Quantity(const std::string& path) : segments_(split(path)) {
  is_state_ = segments_.front() == "state";
  if (is_state_ && segments_.size() == 3) id_ = whole(segments_[1]);
}

std::string Quantity::problem(const World& world, const Json& report) const {
  return is_state_ ? state_problem(world) : report_problem(report);
}

std::string Quantity::state_problem(const World& world) const {
  if (!is_state_ || !id_) return "expected state.ID.COLUMN, such as state.0.x";
  if (*id_ >= world.body_count()) {
    return fmt::format("there is no body {}, expected an id below {}", *id_, world.body_count());
  }
  const BodyState body = world.body(*id_);
  const std::vector<std::string> names = carried_names(body);
  const Column* column = column_of(segments_[2]);
  if (column && column->carried(body)) return "";
  return fmt::format("body {} carries no {}, expected one of {}{}", *id_, printable(segments_[2]),
                     fmt::join(names, ", "), hint(segments_[2], names));
}

std::string Quantity::report_problem(const Json& report) const {
  const Json* json = &report;
  std::string reached = "the run's report";
  for (const std::string& segment : segments_) {
    if (reached == times_of_event && json->is_array()) return index_problem(segment);
    const std::vector<std::string> names = names_in(*json);
    json = find_in(*json, segment);
    if (!json) {
      const std::string choices = names.empty() ? "" : fmt::format(", expected one of {}", fmt::join(names, ", "));
      return fmt::format("there is no \"{}\" in {}{}{}", printable(segment), reached, choices, hint(segment, names));
    }
    reached = segment;
  }
  if (json->is_number() || json->is_null()) return "";
  if (json->is_object()) return fmt::format("has parts, expected one of {}", fmt::join(names_in(*json), ", "));
  return "is not a number";
}

double (*Quantity::column() const)(const BodyState&) {
  return column_of(segments_[2])->value;
}

double Quantity::measured(const World& world) const {
  return column()(world.body(*id_));
}

double Quantity::measured(const Json& report) const {
  const Json* json = &report;
  for (std::size_t i = 0; json && i < segments_.size(); ++i) json = find_in(*json, segments_[i]);
  return json && json->is_number() ? json->get<double>() : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace ballpark::scenes
