// PNG: red, green and blue of 8 bits; each row as differences from the pixel to the left, which shades well.
#include "scenarios/view/deflate.h"
#include "scenarios/view/drawing.h"

namespace ballpark::view {
namespace {

std::string big_endian(std::uint32_t value) {
  std::string bytes;
  for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(value >> shift & 255);
  return bytes;
}

std::string chunk(const std::string& name, const std::string& content) {
  const std::string body = name + content;
  return big_endian(static_cast<std::uint32_t>(content.size())) + body + big_endian(crc(body));
}

}  // namespace

std::string png(const Image& image) {
  constexpr std::size_t pixel = 3;
  constexpr std::uint8_t left_neighbour = 1;
  const auto width = static_cast<std::size_t>(image.width), height = static_cast<std::size_t>(image.height);
  std::vector<std::uint8_t> row(1 + pixel * width, left_neighbour);
  Deflater deflater;
  for (std::size_t y = 0; y < height; ++y) {
    const std::uint8_t* from = &image.pixels[pixel * width * y];
    for (std::size_t i = 0; i < pixel * width; ++i) {
      row[1 + i] = static_cast<std::uint8_t>(from[i] - (i < pixel ? 0 : from[i - pixel]));
    }
    deflater.add(row);
  }
  const std::string size =
      big_endian(static_cast<std::uint32_t>(image.width)) + big_endian(static_cast<std::uint32_t>(image.height));
  const std::string eight_bits_of_three_colours("\x08\x02\x00\x00\x00", 5);
  return "\x89PNG\r\n\x1a\n" + chunk("IHDR", size + eight_bits_of_three_colours) + chunk("IDAT", deflater.finish()) +
         chunk("IEND", "");
}

}  // namespace ballpark::view
