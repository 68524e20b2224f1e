// Runs as a page that opens in a browser, without a network, and plays them.
#pragma once

#include <string>
#include <vector>

#include "scenarios/view/encode.h"

namespace ballpark::view {

/// No text of a run can become markup or script.
std::string page(const std::string& title, const std::vector<Encoded>& runs);

/// Bytes of a page without runs.
std::size_t page_size(const std::string& title);

}  // namespace ballpark::view
