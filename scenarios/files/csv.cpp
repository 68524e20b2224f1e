#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <stdexcept>

#include "scenarios/files/body_file.h"
#include "scenarios/files/values.h"

namespace ballpark::scenes {

namespace {

const std::vector<std::string> column_names = {"id", "x",  "y",  "z",  "qw", "qx", "qy",   "qz",
                                               "vx", "vy", "vz", "wx", "wy", "wz", "mass", "radius"};

[[noreturn]] void refuse(const std::string& message) {
  throw std::runtime_error(message);
}

std::string_view trimmed(std::string_view text) {
  const std::size_t start = text.find_first_not_of(" \t\r");
  if (start == std::string_view::npos) return {};
  return text.substr(start, text.find_last_not_of(" \t\r") - start + 1);
}

std::string_view take_until(std::string_view& text, char end) {
  const std::size_t size = std::min(text.find(end), text.size());
  const std::string_view part = text.substr(0, size);
  text.remove_prefix(std::min(size + 1, text.size()));
  return trimmed(part);
}

/// The numbers of the file, row after row, and which column is where.
class Sheet {
 public:
  explicit Sheet(std::string_view text) {
    if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
    read_header(take_until(text, '\n'));
    for (std::size_t line = 2; !text.empty(); ++line) {
      const std::string_view row = take_until(text, '\n');
      if (!row.empty()) read_row(row, line);
    }
  }

  std::size_t rows() const { return numbers_.size() / header_.size(); }
  bool has(const std::string& column) const { return index_of(column) < header_.size(); }
  double at(std::size_t row, std::size_t column) const { return numbers_[row * header_.size() + column]; }
  std::size_t index_of(const std::string& column) const {
    return static_cast<std::size_t>(std::find(header_.begin(), header_.end(), column) - header_.begin());
  }

  /// The places of these columns; empty if the file has none of them. Some alone are an error.
  std::vector<std::size_t> together(const std::vector<std::string>& columns) const {
    std::vector<std::size_t> places;
    std::string missing;
    for (const std::string& column : columns) {
      if (has(column)) {
        places.push_back(index_of(column));
      } else {
        missing = column;
      }
    }
    if (places.empty() || missing.empty()) return places;
    refuse(fmt::format("has no column {}, expected all of {} or none", missing, fmt::join(columns, ", ")));
  }

 private:
  void read_header(std::string_view line) {
    while (!line.empty()) {
      const std::string name(take_until(line, ','));
      if (std::find(column_names.begin(), column_names.end(), name) == column_names.end()) {
        refuse(fmt::format("line 1: unknown column \"{}\", expected some of {}{}", printable(name),
                           fmt::join(column_names, ", "), hint(name, column_names)));
      }
      if (has(name)) refuse(fmt::format("line 1: column {} is there twice", name));
      header_.push_back(name);
    }
    if (header_.empty()) refuse("is empty, expected a line that names the columns");
  }

  void read_row(std::string_view line, std::size_t line_number) {
    std::size_t column = 0;
    for (; !line.empty() && column < header_.size(); ++column) {
      const std::string_view cell = take_until(line, ',');
      double number = 0;
      const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), number);
      if (error != std::errc{} || end != cell.data() + cell.size()) {
        refuse(fmt::format("line {}, column {}: \"{}\" given, expected a number", line_number, header_[column],
                           printable(std::string(cell))));
      }
      numbers_.push_back(number);
    }
    if (column < header_.size() || !line.empty()) {
      refuse(fmt::format("line {}: expected {} numbers, one for each column", line_number, header_.size()));
    }
  }

  std::vector<std::string> header_;
  std::vector<double> numbers_;
};

std::vector<double> numbers_of(const Sheet& sheet, const std::string& column) {
  std::vector<double> list;
  if (!sheet.has(column)) return list;
  const std::size_t place = sheet.index_of(column);
  for (std::size_t row = 0; row < sheet.rows(); ++row) list.push_back(sheet.at(row, place));
  return list;
}

std::vector<Vector3d> vectors_of(const Sheet& sheet, const std::vector<std::string>& columns) {
  const std::vector<std::size_t> c = sheet.together(columns);
  std::vector<Vector3d> list;
  if (c.empty()) return list;
  for (std::size_t i = 0; i < sheet.rows(); ++i)
    list.emplace_back(sheet.at(i, c[0]), sheet.at(i, c[1]), sheet.at(i, c[2]));
  return list;
}

std::vector<Quaternion> quaternions_of(const Sheet& sheet) {
  const std::vector<std::size_t> c = sheet.together({"qw", "qx", "qy", "qz"});
  std::vector<Quaternion> list;
  if (c.empty()) return list;
  for (std::size_t i = 0; i < sheet.rows(); ++i) {
    list.push_back({sheet.at(i, c[0]), sheet.at(i, c[1]), sheet.at(i, c[2]), sheet.at(i, c[3])});
  }
  return list;
}

}  // namespace

BodyGroup rows_from_csv(std::string_view text) {
  const Sheet sheet(text);
  const std::vector<double> ids = numbers_of(sheet, "id");
  // Bodies are numbered by their order, so a file that says otherwise would be read wrongly in silence.
  if (!std::is_sorted(ids.begin(), ids.end(), std::less_equal<>())) refuse("its rows are not in the order of id");
  BodyGroup group;
  group.mass = numbers_of(sheet, "mass");
  group.radius = numbers_of(sheet, "radius");
  group.position = vectors_of(sheet, {"x", "y", "z"});
  group.velocity = vectors_of(sheet, {"vx", "vy", "vz"});
  group.angular_velocity = vectors_of(sheet, {"wx", "wy", "wz"});
  group.orientation = quaternions_of(sheet);
  return group;
}

}  // namespace ballpark::scenes
