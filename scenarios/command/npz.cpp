#include "scenarios/command/npz.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>
#include <zip.h>

#include <bit>
#include <cerrno>
#include <cstring>
#include <utility>

#include "scenarios/command/errors.h"

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
  append(std::string(header_size, ' ').data(), header_size);
}

void ArraySpool::append(const void* data, std::size_t size) {
  if (std::fwrite(data, 1, size, file_.get()) != size) spool_failed();
}

std::FILE* ArraySpool::close(const std::vector<std::size_t>& shape) {
  if (std::fseek(file_.get(), 0, SEEK_SET) != 0) spool_failed();
  append(npy_header(type_, shape).data(), header_size);
  if (std::fseek(file_.get(), 0, SEEK_SET) != 0) spool_failed();  // libzip reads from where it stands
  return file_.release();
}

NpzFrames::NpzFrames(const std::string& path)
    : file_(path, true),
      folder_(folder_of(file_.working_path())),
      time_("time", "<f8", folder_),
      id_("id", "<u8", folder_),
      position_("position", "<f8", folder_),
      velocity_("velocity", "<f8", folder_) {}

void NpzFrames::begin(const World& world) {
  begun_ = true;
  bodies_ = world.body_count();
  const CarriedColumns carried = carried_columns(world);
  if (carried.orientation) orientation_.emplace("orientation", "<f8", folder_);
  if (carried.angular_velocity) angular_velocity_.emplace("angular_velocity", "<f8", folder_);
  for (std::uint64_t id = 0; id < bodies_; ++id) id_.append(&id, sizeof id);
}

void NpzFrames::add(const World& world) {
  if (!begun_) begin(world);
  const double time = world.time();
  time_.append(&time, sizeof time);
  for (std::size_t id = 0; id < bodies_; ++id) {
    const BodyState body = world.body(id);
    position_.append(body.position.data(), 3 * sizeof(double));
    velocity_.append(body.velocity.data(), 3 * sizeof(double));
    const double q[4] = {body.orientation.w, body.orientation.x, body.orientation.y, body.orientation.z};
    if (orientation_) orientation_->append(q, sizeof q);
    if (angular_velocity_) angular_velocity_->append(body.angular_velocity.data(), 3 * sizeof(double));
  }
  ++frames_;
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
  add_array(id_, {bodies_});
  add_array(position_, {frames_, bodies_, 3});
  add_array(velocity_, {frames_, bodies_, 3});
  if (orientation_) add_array(*orientation_, {frames_, bodies_, 4});
  if (angular_velocity_) add_array(*angular_velocity_, {frames_, bodies_, 3});
  if (zip_close(archive.get()) != 0) file_.fail(zip_strerror(archive.get()));
  archive.release();
  file_.commit();
}

}  // namespace ballpark::command
