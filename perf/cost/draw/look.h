// What curves look like: which of them get colours, and the shape of a point.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "perf/cost/draw/canvas.h"
#include "perf/cost/result.h"

namespace ballpark::cost::draw {

inline constexpr const char* dark = "#1f2328";
inline constexpr const char* medium = "#57606a";
inline constexpr const char* faint = "#8c959f";
inline constexpr const char* grid = "#eceff2";

/// Told apart by people of all kinds of colour vision (after Okabe and Ito 2008, and Tol 2021). `ink`: for text.
struct Colour {
  const char* line;
  const char* ink;
};
inline constexpr Colour grey{"#b3b9c0", "#6e7781"};

struct Look {
  bool strong = false;  ///< in colour
  Colour colour = grey;
};

/// Can it be drawn?
bool drawable(const Point& point);
/// The wall time that is drawn.
double cost_of(const Point& point);
bool equal(const Setting& a, const Setting& b);

/// One a curve. Strong are at most eight: those of the front first, then the scene's own, then what is near the front.
/// Curves that differ by their precision alone share a colour.
std::vector<Look> looks(const Result& result);
/// The index-th of the colours that no curve has.
Colour spare_colour(const std::vector<Look>& looks, std::size_t index);

/// A point's marker: the more corners the higher the order.
std::string marker(Spot at, int order, double size);
std::string setting_text(const Setting& setting);  ///< rk4, step 0.001 s

}  // namespace ballpark::cost::draw
