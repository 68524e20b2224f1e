#include "scenarios/view/header.h"

#include <nlohmann/json.hpp>

namespace ballpark::view {
namespace {

using Json = nlohmann::ordered_json;

Json json_of(const Vector3d& v) {
  return {v.x(), v.y(), v.z()};
}

Json json_of(const Motion& motion) {
  return {{"velocity", json_of(motion.velocity)},
          {"amplitude", json_of(motion.amplitude)},
          {"frequency", motion.frequency},
          {"phase", motion.phase}};
}

Json json_of(const Boundary& boundary) {
  Json json{{"shape", boundary.shape}, {"name", boundary.name}};
  if (boundary.shape == "box") {
    json["min"] = json_of(boundary.point - boundary.size / 2);
    json["max"] = json_of(boundary.point + boundary.size / 2);
    json["side"] = boundary.side;
    json["open"] = boundary.open;
  } else {
    json["point"] = json_of(boundary.point);
  }
  if (boundary.shape == "plane" || boundary.shape == "tube") json["normal"] = json_of(boundary.normal);
  if (boundary.shape == "tube") json["radius"] = boundary.radius;
  if (boundary.shape == "periodic") json["size"] = json_of(boundary.size);
  if (boundary.motion) json["motion"] = json_of(*boundary.motion);
  return json;
}

Json json_of(const ShownGroup& group) {
  Json json{{"name", group.name}, {"first", group.first}, {"count", group.count}};
  if (group.radius.size() == 1) json["radius"] = group.radius[0];
  if (group.radius.size() > 1) json["radius"] = group.radius;
  json["turns"] = group.turns;
  return json;
}

Json json_of(const HeaderColumn& column) {
  Json json{{"name", column.name},
            {"components", column.components},
            {"bits", column.bits},
            {"differences", column.differences}};
  if (column.range) {
    json["min"] = column.range->first;
    json["max"] = column.range->second;
    json["unit"] = column.unit;
  }
  return json;
}

Json json_of(const Series& series) {
  return {{"name", series.name}, {"unit", series.unit}, {"values", series.values}};
}

template <class T>
Json list_of(const std::vector<T>& values) {
  Json list = Json::array();
  for (const T& value : values) list.push_back(json_of(value));
  return list;
}

}  // namespace

std::string header(const Recording& recording, const Box& box, const std::vector<HeaderColumn>& columns,
                   const std::vector<std::string>& notes) {
  const Json json{{"format", 1},
                  {"scenario", recording.scenario},
                  {"label", recording.label},
                  {"doc", recording.doc},
                  {"bodies", recording.bodies},
                  {"shown", recording.shown},
                  {"stride", recording.stride},
                  {"times", recording.times},
                  {"groups", list_of(recording.groups)},
                  {"boundaries", list_of(recording.boundaries)},
                  {"box", {{"min", json_of(box.low)}, {"max", json_of(box.high)}}},
                  {"columns", list_of(columns)},
                  {"series", list_of(recording.series)},
                  {"notes", notes}};
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace ballpark::view
