// A ZIP archive whose entries are stored as they are, without compression. Entries may exceed 4 GiB (ZIP64), and are
// dated as NumPy does: equal entries give equal archives.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "scenarios/command/output_file.h"

namespace ballpark::command {

class StoredZip {
 public:
  explicit StoredZip(OutputFile& file) : file_(file) {}
  /// What follows `size` bytes with this CRC-32; the caller writes them to the file next. Throws WriteError, as
  /// finish().
  void begin_entry(const std::string& name, std::uint64_t size, std::uint32_t crc);
  void finish();  ///< writes the list of entries

 private:
  struct Entry {
    std::string name;
    std::uint64_t size, offset;
    std::uint32_t crc;
  };
  OutputFile& file_;
  std::vector<Entry> entries_;
};

}  // namespace ballpark::command
