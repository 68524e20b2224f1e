// One moment of a recording, as coloured balls and faint lines in space.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "scenarios/view/camera.h"
#include "scenarios/view/outline.h"
#include "scenarios/view/recording.h"

namespace ballpark::view {

struct Colour {
  std::uint8_t red = 0, green = 0, blue = 0;
};
std::string hex(Colour colour);  ///< #0072b2

enum class ColourBy { speed, group, plain };  ///< speed: up to the fastest of the moment

struct Ball {
  Vector3d centre;
  double radius;
  Colour colour;
  bool turns;
  Quaternion orientation;
};

struct Drawing {
  std::vector<Ball> balls;
  std::vector<Line> lines;  ///< boundaries
  Box box;                  ///< of all positions of the recording, with the bodies around them
};

Drawing drawing_of(const Recording& recording, std::size_t frame, ColourBy colour);

/// Pixels from the upper left, red, green and blue each.
struct Image {
  int width = 0, height = 0;
  std::vector<std::uint8_t> pixels;
};

Image picture(const Drawing& drawing, const Vector3d& direction, int width, int height);
std::string png(const Image& image);
std::string svg(const Drawing& drawing, const Vector3d& direction, int width, int height);

}  // namespace ballpark::view
