// A file that appears whole or not at all.
#pragma once

#include <cstdint>
#include <cstdio>
#include <string>
#include <string_view>

namespace ballpark::command {

/// Written beside its place under another name, and renamed by commit(). A device or a pipe is written in place.
class OutputFile {
 public:
  /// Opens it, so that what cannot be written is known at once. Throws DestinationError.
  /// `seekable`: only a regular file will do.
  explicit OutputFile(const std::string& path, bool seekable = false);
  ~OutputFile();  ///< what was not committed is gone
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  void write(std::string_view text);  ///< throws WriteError
  /// The first `size` bytes of another file. Throws WriteError.
  void write_from(int descriptor, std::uint64_t size);
  void commit();                                  ///< throws WriteError
  std::uint64_t bytes() const { return bytes_; }  ///< written so far
  const std::string& path() const { return path_; }
  const std::string& working_path() const { return working_path_; }
  [[noreturn]] void fail(const std::string& why) const;  ///< throws the WriteError of this file

 private:
  std::string path_, target_, working_path_;  ///< as given; symbolic links followed; "" for a device
  std::FILE* file_ = nullptr;
  std::uint64_t bytes_ = 0;
};

/// The folder that a file stands in, "." if its path names none.
std::string folder_of(const std::string& path);

}  // namespace ballpark::command
