#include "scenarios/command/npz.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>
#include <zip.h>

#include <bit>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <numeric>
#include <utility>

#include "scenarios/command/errors.h"
#include "scenarios/command/number_text.h"

namespace ballpark::command {
namespace {

static_assert(std::endian::native == std::endian::little, "array types are written as little-endian");

constexpr std::size_t header_size = 128;  // fixed, so that it can be written last: numpy asks for a multiple of 64

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

/// Stored, and dated as NumPy does: equal arrays give equal files.
bool finish_entry(zip_t* archive, zip_uint64_t index) {
  constexpr zip_uint16_t first_of_january_1980 = 1 << 5 | 1;
  return zip_set_file_compression(archive, index, ZIP_CM_STORE, 0) == 0 &&
         zip_file_set_dostime(archive, index, 0, first_of_january_1980, 0) == 0;
}

struct Discard {
  void operator()(zip_t* archive) const { zip_discard(archive); }
};
using Archive = std::unique_ptr<zip_t, Discard>;

}  // namespace

ArraySpool::ArraySpool(std::string name, std::string type, const std::string& folder)
    : name_(std::move(name)), type_(std::move(type)), file_(unnamed_file(folder)) {
  append(std::string(header_size, ' '));
}

void ArraySpool::append(std::string_view data) {
  if (std::fwrite(data.data(), 1, data.size(), file_.get()) != data.size()) spool_failed();
}

std::FILE* ArraySpool::close(const std::vector<std::size_t>& shape) {
  if (std::fseek(file_.get(), 0, SEEK_SET) != 0) spool_failed();
  append(npy_header(type_, shape));
  if (std::fseek(file_.get(), 0, SEEK_SET) != 0) spool_failed();  // libzip reads from where it stands
  return file_.release();
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
  id_.append({reinterpret_cast<const char*>(ids.data()), ids.size() * sizeof(std::uint64_t)});
  for (const FrameColumn& column : layout.columns) columns_.emplace_back(column.name, type_, folder_);
  if (layout.radius.empty()) return;
  columns_.emplace_back("radius", type_, folder_);
  append(columns_.back(), layout.radius);
}

void NpzFrames::append(ArraySpool& spool, std::span<const double> values) {
  spool.append(raw_bytes(values, single_, narrowed_));
}

void NpzFrames::add(const Frames& frames) {
  time_.append(raw_bytes(frames.times, false, narrowed_));
  for (std::size_t c = 0; c < layout_.columns.size(); ++c) append(columns_[c], frames.columns[c]);
  frames_ += frames.count();
}

void NpzFrames::finish() {
  int error = 0;
  Archive archive(zip_open(file_.working_path().c_str(), ZIP_CREATE | ZIP_TRUNCATE, &error));
  if (!archive) file_.fail(strerror(errno));
  const auto add_array = [&](ArraySpool& spool, const std::vector<std::size_t>& shape) {
    zip_source_t* source = zip_source_filep(archive.get(), spool.close(shape), 0, -1);
    const zip_int64_t index = zip_file_add(archive.get(), (spool.name() + ".npy").c_str(), source, ZIP_FL_ENC_UTF_8);
    if (index < 0 || !finish_entry(archive.get(), static_cast<zip_uint64_t>(index))) {
      file_.fail(zip_strerror(archive.get()));
    }
  };
  add_array(time_, {frames_});
  add_array(id_, {layout_.bodies});
  for (std::size_t c = 0; c < layout_.columns.size(); ++c) {
    add_array(columns_[c], {frames_, layout_.bodies, layout_.columns[c].components()});
  }
  if (!layout_.radius.empty()) add_array(columns_.back(), {layout_.bodies});
  if (zip_close(archive.get()) != 0) file_.fail(zip_strerror(archive.get()));
  archive.release();
  bytes_ = std::filesystem::file_size(file_.working_path());
  file_.commit();
}

}  // namespace ballpark::command
