#include "scenarios/command/stored_zip.h"

#include <concepts>

namespace ballpark::command {
namespace {

using U16 = std::uint16_t;
using U32 = std::uint32_t;
using U64 = std::uint64_t;

constexpr U16 zip64_version = 45, names_are_utf8 = 1 << 11, stored = 0, midnight = 0;
constexpr U16 first_of_january_1980 = 1 << 5 | 1, zip64_extra = 1;
constexpr U16 many_entries = 0xffff;
constexpr U32 see_zip64 = 0xffffffff;

/// Little-endian, one after the other.
template <std::unsigned_integral... Numbers>
std::string fields(Numbers... numbers) {
  std::string text;
  const auto append = [&](auto number) {
    for (std::size_t byte = 0; byte < sizeof number; ++byte) text += static_cast<char>(U64{number} >> (8 * byte));
  };
  (append(numbers), ...);
  return text;
}

/// What the header of an entry and its line in the list share.
std::string common(U32 crc, const std::string& name, std::size_t extra) {
  return fields(zip64_version, names_are_utf8, stored, midnight, first_of_january_1980, crc, see_zip64, see_zip64,
                static_cast<U16>(name.size()), static_cast<U16>(extra));
}

}  // namespace

void StoredZip::begin_entry(const std::string& name, U64 size, U32 crc) {
  entries_.push_back({name, size, file_.bytes(), crc});
  const std::string extra = fields(zip64_extra, U16{16}, size, size);
  file_.write(fields(U32{0x04034b50}) + common(crc, name, extra.size()) + name + extra);
}

void StoredZip::finish() {
  const U64 start = file_.bytes(), count = entries_.size();
  for (const Entry& entry : entries_) {
    const std::string extra = fields(zip64_extra, U16{24}, entry.size, entry.size, entry.offset);
    file_.write(fields(U32{0x02014b50}, zip64_version) + common(entry.crc, entry.name, extra.size()) +
                fields(U16{0}, U16{0}, U16{0}, U32{0}, see_zip64) + entry.name + extra);
  }
  const U64 end = file_.bytes();
  file_.write(
      fields(U32{0x06064b50}, U64{44}, zip64_version, zip64_version, U32{0}, U32{0}, count, count, end - start, start) +
      fields(U32{0x07064b50}, U32{0}, end, U32{1}) +
      fields(U32{0x06054b50}, U16{0}, U16{0}, many_entries, many_entries, see_zip64, see_zip64, U16{0}));
}

}  // namespace ballpark::command
