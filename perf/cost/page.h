// The figure as a page that opens in a browser, without a network: what is measured can be chosen, points tell of
// themselves.
#pragma once

#include <string>

namespace ballpark::cost {

/// `json`: a result in the format "ballpark-cost-1". No text in it can become markup or script.
std::string page(const std::string& json, const std::string& title);

}  // namespace ballpark::cost
