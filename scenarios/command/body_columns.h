// What the bodies of a world carry, as the columns of its output files. Rows go by id.
#pragma once

#include <optional>
#include <string>

#include "ballpark/world.h"

namespace ballpark::command {

/// Orientation and angular velocity are written if any body has them; the others then show identity and zero.
struct CarriedColumns {
  bool orientation = false, angular_velocity = false;
};

CarriedColumns carried_columns(const World& world);
std::string csv_header(CarriedColumns carried);  ///< "id,x,y,z,qw,...": no line end
void append_csv_row(std::string& text, std::size_t id, const BodyState& body, CarriedColumns carried);  ///< likewise

}  // namespace ballpark::command
