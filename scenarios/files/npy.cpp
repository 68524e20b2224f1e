// NumPy's array format, version 1 to 3: magic, version, length of the header, header as a Python literal, data.
#include <fmt/format.h>

#include <charconv>
#include <cstring>
#include <stdexcept>

#include "scenarios/files/body_file.h"
#include "scenarios/files/npy.h"

namespace ballpark::scenes {

namespace {

[[noreturn]] void refuse(const std::string& message) {
  throw std::runtime_error(message);
}

/// What follows `'name':` in the header.
std::string_view field(std::string_view header, std::string_view name) {
  const std::string label = fmt::format("'{}':", name);
  const std::size_t start = header.find(label);
  if (start == std::string_view::npos) refuse(fmt::format("its header has no {}", label));
  header.remove_prefix(start + label.size());
  header.remove_prefix(std::min(header.find_first_not_of(' '), header.size()));
  return header;
}

/// (3, 4) or (3,)
std::vector<std::size_t> shape_of(std::string_view text) {
  const std::string_view all = text.substr(0, text.find(')') + 1);
  std::vector<std::size_t> shape;
  const char* at = all.data() + all.starts_with("(");
  const char* end = all.data() + all.size();
  while (at != end && *at != ')') {
    std::size_t length = 0;
    const auto [after, error] = std::from_chars(at, end, length);
    if (error != std::errc{}) refuse(fmt::format("its shape is {}, expected numbers in brackets", all));
    shape.push_back(length);
    at = after;
    while (at != end && (*at == ',' || *at == ' ')) ++at;
  }
  if (all.empty()) refuse("its shape does not end");
  return shape;
}

std::string_view take_header(std::string_view& bytes) {
  if (!bytes.starts_with("\x93NUMPY") || bytes.size() < 12) refuse("is no .npy file");
  const auto byte = [&](std::size_t i) { return static_cast<std::size_t>(static_cast<unsigned char>(bytes[i])); };
  const bool long_header = byte(6) > 1;
  const std::size_t start = long_header ? 12 : 10;
  const std::size_t size = byte(8) | byte(9) << 8 | (long_header ? byte(10) << 16 | byte(11) << 24 : std::size_t{0});
  if (bytes.size() - start < size) refuse("ends inside its header");
  const std::string_view header = bytes.substr(start, size);
  bytes.remove_prefix(start + size);
  return header;
}

template <class Item>
std::vector<Vector3d> vectors_of(std::string_view bytes, std::size_t rows) {
  std::vector<Vector3d> vectors(rows);
  for (std::size_t i = 0; i < rows; ++i) {
    Item row[3];
    std::memcpy(row, bytes.data() + i * sizeof row, sizeof row);
    vectors[i] = Vector3d(row[0], row[1], row[2]);
  }
  return vectors;
}

}  // namespace

std::size_t NpyLayout::item_size() const {
  return type == "<f8" ? 8 : type == "<f4" ? 4 : 0;
}

std::string NpyLayout::shape_text() const {
  return fmt::format("({}{})", fmt::join(shape, ", "), shape.size() == 1 ? "," : "");
}

NpyLayout take_npy_header(std::string_view& bytes) {
  const std::string_view header = take_header(bytes);
  const std::string_view type = field(header, "descr");
  if (!field(header, "fortran_order").starts_with("False")) refuse("it is in Fortran order, expected C order");
  const std::string_view quoted = type.substr(0, type.find(','));
  const bool plain = quoted.size() > 2 && quoted.front() == '\'' && quoted.back() == '\'';
  return {std::string(plain ? quoted.substr(1, quoted.size() - 2) : quoted), shape_of(field(header, "shape"))};
}

BodyGroup rows_from_npy(std::string_view bytes) {
  const NpyLayout layout = take_npy_header(bytes);
  if (layout.item_size() == 0) refuse(fmt::format("its type is '{}', expected '<f8' or '<f4'", layout.type));
  if (layout.shape.size() != 2 || layout.shape[1] != 3) {
    refuse(fmt::format("its shape is {}, expected (n, 3)", layout.shape_text()));
  }
  const std::size_t rows = layout.shape[0], row_size = 3 * layout.item_size();
  if (bytes.size() / row_size < rows) refuse(fmt::format("ends after {} of {} rows", bytes.size() / row_size, rows));
  BodyGroup group;
  group.position = layout.item_size() == 8 ? vectors_of<double>(bytes, rows) : vectors_of<float>(bytes, rows);
  return group;
}

}  // namespace ballpark::scenes
