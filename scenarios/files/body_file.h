// Rows of a group of bodies from a file.
#pragma once

#include <filesystem>

#include "ballpark/scene.h"

namespace ballpark::scenes {

/// The lists that the file gives (.npy: n by 3 positions; .csv: named columns), others empty. Throws std::runtime_error
/// with what is wrong with the file.
BodyGroup rows_from_file(const std::filesystem::path& path);

BodyGroup rows_from_npy(std::string_view bytes);
BodyGroup rows_from_csv(std::string_view text);

}  // namespace ballpark::scenes
