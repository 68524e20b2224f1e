// One moment of a recording, as coloured balls and faint lines in space.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "scenarios/view/camera.h"
#include "scenarios/view/outline.h"
#include "scenarios/view/recording.h"

namespace ballpark::view {

struct Colour {
  std::uint8_t red = 0, green = 0, blue = 0;
};
std::string hex(Colour colour);  ///< #0072b2
/// Viridis (Smith and van der Walt 2015): told apart by people of all kinds of colour vision, and in grey. `share` in
/// 0..1.
Colour viridis(double share);

enum class ColourBy { speed, group, plain };  ///< speed: up to the fastest of the moment

struct Ball {
  Vector3d centre;
  double radius;
  Colour colour;
  bool turns;
  Quaternion orientation;
};

/// What the colours mean.
struct Key {
  std::string scale;   ///< "speed [m/s]", on viridis from 0 on; "": no scale
  double highest = 0;  ///< at its end
  std::vector<std::pair<Colour, std::string>> entries;
};

struct Drawing {
  double time = 0;  ///< [s]
  Key key;
  std::vector<Ball> balls;
  std::vector<Line> lines;  ///< boundaries
  Box box;                  ///< of all positions of the recording, with the bodies around them
};

Drawing drawing_of(const Recording& recording, std::size_t frame, ColourBy colour);

/// The marks of a ball that turns reach so far from the middle of theirs, in radii: see stripes.h.
inline constexpr double band_half_width = 0.22, mark_half_width = 0.09;

/// Pixels from the upper left, red, green and blue each.
struct Image {
  int width = 0, height = 0;
  std::vector<std::uint8_t> pixels;
};

Image picture(const Drawing& drawing, const Vector3d& direction, int width, int height);
std::string png(const Image& image);
std::string svg(const Drawing& drawing, const Vector3d& direction, int width, int height);

}  // namespace ballpark::view
