#include "scenarios/command/vtp.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <filesystem>
#include <limits>
#include <numeric>

#include "scenarios/command/errors.h"
#include "scenarios/command/number_bytes.h"
#include "scenarios/command/terminal.h"

namespace ballpark::command {
namespace {

static_assert(std::endian::native == std::endian::little, "files say that numbers are little-endian");

using Size = std::uint64_t;  // before each block of numbers: its bytes

std::string escaped(const std::string& text) {
  std::string xml;
  for (const char c : text) {
    if (c == '&' || c == '<' || c == '"') {
      xml += c == '&' ? "&amp;" : c == '<' ? "&lt;" : "&quot;";
    } else {
      xml += c;
    }
  }
  return xml;
}

std::string file_head(const std::string& type) {
  return fmt::format(
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"{}\" version=\"1.0\" byte_order=\"LittleEndian\" "
      "header_type=\"UInt64\">\n",
      type);
}

void write_size(OutputFile& file, Size size) {
  file.write({reinterpret_cast<const char*>(&size), sizeof size});
}

void write_block(OutputFile& file, const std::vector<std::int32_t>& numbers) {
  write_size(file, bytes_of(numbers).size());
  file.write(bytes_of(numbers));
}

}  // namespace

VtpFrames::VtpFrames(const std::string& index_path, bool single)
    : index_path_(index_path), stem_(std::filesystem::path(index_path).replace_extension().string()), single_(single) {
  const OutputFile writable(index_path, true);
}

void VtpFrames::begin(const FrameLayout& layout) {
  if (layout.bodies > std::numeric_limits<std::int32_t>::max()) {
    throw WriteError(fmt::format("'{}' cannot hold {} bodies, at most 2^31 - 1", index_path_, layout.bodies));
  }
  layout_ = layout;
  write_index();  // what an earlier run left would name this run's frames
}

void VtpFrames::add(const Frames& frames) {
  for (std::size_t frame = 0; frame < frames.count(); ++frame) {
    write_frame(frames, frame);
    if (index_is_due()) write_index();
  }
}

/// Numbers of `components` for each body that stand at `offset`, which then moves behind them.
std::string VtpFrames::data_array(const std::string& attributes, std::size_t components, std::size_t size,
                                  std::size_t& offset) const {
  const std::string text = fmt::format("<DataArray {} NumberOfComponents=\"{}\" format=\"appended\" offset=\"{}\"/>\n",
                                       attributes, components, offset);
  offset += sizeof(Size) + ids_.size() * components * size;
  return text;
}

// The blocks stand in this order: ids (of bodies and of their points), ends of vertices, columns, radii.
std::string VtpFrames::header(double time) const {
  const std::string real = single_ ? "Float32" : "Float64";
  const std::size_t real_size = single_ ? sizeof(float) : sizeof(double);
  std::size_t offset = 0, ids = 0;
  const std::string id = data_array("type=\"Int32\" Name=\"id\"", 1, sizeof(std::int32_t), offset);
  const std::string points_of_vertices = data_array("type=\"Int32\" Name=\"connectivity\"", 1, 0, ids);
  const std::string ends = data_array("type=\"Int32\" Name=\"offsets\"", 1, sizeof(std::int32_t), offset);
  std::string points, data = id;
  const auto real_array = [&](const std::string& name, std::size_t components) {
    return data_array(fmt::format("type=\"{}\" Name=\"{}\"", real, name), components, real_size, offset);
  };
  for (const FrameColumn& column : layout_.columns) {
    (column.name == "position" ? points : data) += real_array(column.name, column.components());
  }
  if (!layout_.radius.empty()) data += real_array("radius", 1);
  return file_head("PolyData") +
         fmt::format(
             "<PolyData>\n<FieldData>\n<DataArray type=\"Float64\" Name=\"TimeValue\" NumberOfTuples=\"1\" "
             "format=\"ascii\">{}</DataArray>\n</FieldData>\n"
             "<Piece NumberOfPoints=\"{}\" NumberOfVerts=\"{}\" NumberOfLines=\"0\" NumberOfStrips=\"0\" "
             "NumberOfPolys=\"0\">\n<PointData>\n{}</PointData>\n<Points>\n{}</Points>\n<Verts>\n{}{}</Verts>\n"
             "</Piece>\n</PolyData>\n<AppendedData encoding=\"raw\">\n_",
             time, ids_.size(), ids_.size(), data, points, points_of_vertices, ends);
}

/// `values` of all bodies: those of who is there.
void VtpFrames::write_numbers(OutputFile& file, std::span<const double> values) {
  const std::size_t n = values.size() / std::max<std::size_t>(layout_.bodies, 1);
  if (ids_.size() < layout_.bodies) {
    here_.clear();
    for (const std::int32_t id : ids_) {
      const auto first = values.begin() + static_cast<std::ptrdiff_t>(n) * id;
      here_.insert(here_.end(), first, first + static_cast<std::ptrdiff_t>(n));
    }
    values = here_;
  }
  write_size(file, values.size() * (single_ ? sizeof(float) : sizeof(double)));
  command::write_numbers(values, single_, [&](std::string_view bytes) { file.write(bytes); });
}

void VtpFrames::write_frame(const Frames& frames, std::size_t frame) {
  const double time = frames.times[frame];
  ids_ = present(layout_, frames, frame);
  ends_.resize(ids_.size());
  std::iota(ends_.begin(), ends_.end(), 1);
  const std::string path = fmt::format("{}_{:04}.vtp", stem_, frames_);
  OutputFile file(path, true);
  file.write(header(time));
  write_block(file, ids_);
  write_block(file, ends_);
  for (std::size_t c = 0; c < layout_.columns.size(); ++c) {
    write_numbers(file, frames.values(c, frame));
  }
  if (!layout_.radius.empty()) write_numbers(file, layout_.radius);
  file.write("\n</AppendedData>\n</VTKFile>\n");
  file.commit();
  bytes_ += file.bytes();
  listed_ += fmt::format("<DataSet timestep=\"{}\" part=\"0\" file=\"{}\"/>\n", time,
                         escaped(std::filesystem::path(path).filename().string()));
  ++frames_;
}

/// Not at each frame: the time for it would grow with the square of their number.
bool VtpFrames::index_is_due() const {
  return now() - index_written_ > 1 || frames_ > frames_in_index_ + frames_in_index_ / 4;
}

void VtpFrames::write_index() {
  OutputFile index(index_path_, true);
  index.write(file_head("Collection") + "<Collection>\n" + listed_ + "</Collection>\n</VTKFile>\n");
  index.commit();
  index_bytes_ = index.bytes();
  frames_in_index_ = frames_;
  index_written_ = now();
}

}  // namespace ballpark::command
