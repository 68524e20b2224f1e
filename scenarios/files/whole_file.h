// A whole file as text, or a sentence on why not.
#pragma once

#include <filesystem>
#include <string>

namespace ballpark::scenes {

/// Throws std::runtime_error: no such file, a directory, not readable, or more than `limit` bytes.
std::string whole_file(const std::filesystem::path& path, std::uintmax_t limit);

}  // namespace ballpark::scenes
