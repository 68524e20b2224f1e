#include "scenarios/command/npz.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>
#include <zlib.h>

#include <bit>
#include <cerrno>
#include <cstring>
#include <numeric>
#include <utility>

#include "scenarios/command/errors.h"
#include "scenarios/command/number_bytes.h"

namespace ballpark::command {
namespace {

static_assert(std::endian::native == std::endian::little, "array types are written as little-endian");

constexpr std::size_t header_size = 128;  // a multiple of 64, as numpy asks for

/// A file without a name: gone when closed, and when the program is killed.
std::FILE* unnamed_file(const std::string& folder) {
  std::string name = folder + "/.ballpark-spool-XXXXXX";
  const int descriptor = mkostemp(name.data(), O_CLOEXEC);
  if (descriptor < 0) throw DestinationError(fmt::format("cannot write in folder '{}': {}", folder, strerror(errno)));
  unlink(name.c_str());
  return fdopen(descriptor, "w+");
}

std::string npy_header(const std::string& type, const std::vector<std::size_t>& shape) {
  std::string text = fmt::format("{{'descr': '{}', 'fortran_order': False, 'shape': ({}{}), }}", type,
                                 fmt::join(shape, ", "), shape.size() == 1 ? "," : "");
  constexpr std::size_t preamble = 10;
  text.resize(header_size - preamble - 1, ' ');
  const char length = static_cast<char>(header_size - preamble);
  return std::string("\x93NUMPY\x01\x00", 8) + length + '\0' + text + '\n';
}

[[noreturn]] void spool_failed() {
  throw WriteError(fmt::format("spooling frames failed: {}", strerror(errno)));
}

std::uint32_t crc_of(std::string_view bytes, std::uint32_t before = 0) {
  return static_cast<std::uint32_t>(crc32_z(before, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()));
}

}  // namespace

ArraySpool::ArraySpool(std::string name, std::string type, const std::string& folder)
    : name_(std::move(name)), type_(std::move(type)), file_(unnamed_file(folder)) {}

void ArraySpool::append(std::string_view data) {
  if (std::fwrite(data.data(), 1, data.size(), file_.get()) != data.size()) spool_failed();
  crc_ = crc_of(data, crc_);
  size_ += data.size();
}

void ArraySpool::move_to(StoredZip& archive, OutputFile& file, const std::vector<std::size_t>& shape) {
  if (std::fflush(file_.get()) != 0) spool_failed();
  const std::string header = npy_header(type_, shape);
  const auto crc = crc32_combine(crc_of(header), crc_, static_cast<z_off_t>(size_));
  archive.begin_entry(name_ + ".npy", header.size() + size_, static_cast<std::uint32_t>(crc));
  file.write(header);
  file.write_from(fileno(file_.get()), size_);
  file_.reset();
}

NpzFrames::NpzFrames(const std::string& path, bool single)
    : file_(path, true),
      single_(single),
      folder_(folder_of(file_.working_path())),
      type_(single ? "<f4" : "<f8"),
      time_("time", "<f8", folder_),
      id_("id", "<u8", folder_) {}

void NpzFrames::begin(const FrameLayout& layout) {
  layout_ = layout;
  std::vector<std::uint64_t> ids(layout.bodies);
  std::iota(ids.begin(), ids.end(), 0);
  id_.append(bytes_of(ids));
  for (const FrameColumn& column : layout.columns) columns_.emplace_back(column.name, type_, folder_);
  if (layout.radius.empty()) return;
  columns_.emplace_back("radius", type_, folder_);
  append(columns_.back(), layout.radius);
}

void NpzFrames::append(ArraySpool& spool, std::span<const double> values) {
  write_numbers(values, single_, [&](std::string_view bytes) { spool.append(bytes); });
}

void NpzFrames::add(const Frames& frames) {
  time_.append(bytes_of(frames.times));
  for (std::size_t c = 0; c < layout_.columns.size(); ++c) append(columns_[c], frames.columns[c]);
  frames_ += frames.count();
}

void NpzFrames::finish() {
  StoredZip archive(file_);
  time_.move_to(archive, file_, {frames_});
  id_.move_to(archive, file_, {layout_.bodies});
  for (std::size_t c = 0; c < layout_.columns.size(); ++c) {
    std::vector<std::size_t> shape{frames_, layout_.bodies};
    if (const std::size_t n = layout_.columns[c].components(); n > 1) shape.push_back(n);
    columns_[c].move_to(archive, file_, shape);
  }
  if (!layout_.radius.empty()) columns_.back().move_to(archive, file_, {layout_.bodies});
  archive.finish();
  file_.commit();
}

}  // namespace ballpark::command
