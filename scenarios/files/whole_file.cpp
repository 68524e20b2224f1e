#include "scenarios/files/whole_file.h"

#include <fmt/format.h>

#include <fstream>
#include <stdexcept>

namespace ballpark::scenes {

std::string whole_file(const std::filesystem::path& path, std::uintmax_t limit) {
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status)) throw std::runtime_error("no such file");
  if (std::filesystem::is_directory(status)) throw std::runtime_error("is a directory, expected a file");
  std::ifstream stream(path, std::ios::binary);
  std::string text;
  // Read in pieces, whatever size the file claims: it may be a pipe or a device without an end.
  constexpr std::size_t piece = 1 << 20;
  while (stream && text.size() <= limit) {
    const std::size_t before = text.size();
    text.resize(before + piece);
    stream.read(text.data() + before, piece);
    text.resize(before + static_cast<std::size_t>(stream.gcount()));
  }
  if (!stream.eof() && !stream.good()) throw std::runtime_error("cannot be read");
  if (text.size() > limit) throw std::runtime_error(fmt::format("is larger than {} MiB", limit >> 20));
  return text;
}

}  // namespace ballpark::scenes
