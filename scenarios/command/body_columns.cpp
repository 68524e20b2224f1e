#include "scenarios/command/body_columns.h"

#include <fmt/format.h>

#include <cmath>
#include <iterator>
#include <limits>

namespace ballpark::command {
namespace {

void append(std::string& text, std::initializer_list<double> values) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();  // without a sign: "-nan" means nothing to a reader
  for (double value : values) {
    fmt::format_to(std::back_inserter(text), ",{:.17g}", std::isnan(value) ? nan : value);
  }
}

void append(std::string& text, const Vector3d& v) {
  append(text, {v.x(), v.y(), v.z()});
}

}  // namespace

CarriedColumns carried_columns(const World& world) {
  CarriedColumns carried;
  for (std::size_t id = 0; id < world.body_count(); ++id) {
    const BodyState body = world.body(id);
    carried.orientation |= body.has_orientation;
    carried.angular_velocity |= body.has_angular_velocity;
    if (carried.orientation && carried.angular_velocity) break;
  }
  return carried;
}

std::string csv_header(CarriedColumns carried) {
  return std::string("id,x,y,z") + (carried.orientation ? ",qw,qx,qy,qz" : "") + ",vx,vy,vz" +
         (carried.angular_velocity ? ",wx,wy,wz" : "");
}

void append_csv_row(std::string& text, std::size_t id, const BodyState& body, CarriedColumns carried) {
  fmt::format_to(std::back_inserter(text), "{}", id);
  append(text, body.position);
  const Quaternion& q = body.orientation;
  if (carried.orientation) append(text, {q.w, q.x, q.y, q.z});
  append(text, body.velocity);
  if (carried.angular_velocity) append(text, body.angular_velocity);
}

}  // namespace ballpark::command
