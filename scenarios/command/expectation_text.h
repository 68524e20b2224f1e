// What an expectation asks for, in words and with the digits that its tolerance deserves.
#pragma once

#include <string>

#include "ballpark/scenes.h"

namespace ballpark::command {

/// Digits that show the tolerance.
int digits_of(const scenes::Expectation& expectation);
std::string wanted(const scenes::Expectation& expectation);  ///< "5 +- 1e-09", "0 to 1", ">= 0"

}  // namespace ballpark::command
