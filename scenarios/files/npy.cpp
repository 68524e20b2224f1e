// NumPy's array format, version 1 to 3: magic, version, length of the header, header as a Python literal, data.
#include <fmt/format.h>

#include <charconv>
#include <cstring>
#include <stdexcept>

#include "scenarios/files/body_file.h"

namespace ballpark::scenes {

namespace {

struct Layout {
  std::size_t item_size = 0;  ///< 4 or 8
  std::size_t rows = 0;
};

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

std::size_t rows_of(std::string_view shape) {
  std::size_t rows = 0, columns = 0;
  const char* end = shape.data() + shape.size();
  const char* at = shape.starts_with("(") ? shape.data() + 1 : end;
  const auto first = std::from_chars(at, end, rows);
  at = first.ptr;
  while (at != end && (*at == ',' || *at == ' ')) ++at;
  const auto second = std::from_chars(at, end, columns);
  const bool closed = second.ptr != end && *second.ptr == ')';
  if (first.ec != std::errc{} || second.ec != std::errc{} || columns != 3 || !closed) {
    refuse(fmt::format("its shape is {}, expected (n, 3)", shape.substr(0, shape.find(')') + 1)));
  }
  return rows;
}

Layout layout_of(std::string_view header) {
  const std::string_view type = field(header, "descr");
  const bool is_double = type.starts_with("'<f8'");
  if (!is_double && !type.starts_with("'<f4'")) {
    refuse(fmt::format("its type is {}, expected '<f8' or '<f4'", type.substr(0, type.find(','))));
  }
  if (!field(header, "fortran_order").starts_with("False")) refuse("it is in Fortran order, expected C order");
  return {is_double ? std::size_t{8} : std::size_t{4}, rows_of(field(header, "shape"))};
}

/// Takes the magic, the version and the header off the bytes.
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

BodyGroup rows_from_npy(std::string_view bytes) {
  const Layout layout = layout_of(take_header(bytes));
  const std::size_t row_size = 3 * layout.item_size;
  if (bytes.size() / row_size < layout.rows) {
    refuse(fmt::format("ends after {} of {} rows", bytes.size() / row_size, layout.rows));
  }
  BodyGroup group;
  group.position =
      layout.item_size == 8 ? vectors_of<double>(bytes, layout.rows) : vectors_of<float>(bytes, layout.rows);
  return group;
}

}  // namespace ballpark::scenes
