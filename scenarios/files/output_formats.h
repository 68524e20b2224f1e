// The kinds of files that frames are written to, and the columns that they may have.
#pragma once

#include <string>
#include <vector>

#include "ballpark/scenes.h"

namespace ballpark::scenes {

struct OutputFormat {
  std::string ending;   ///< ".npz"
  std::string read_by;  ///< "NumPy"; "" for all the world
  bool single = false;  ///< precision of a request that names none
  bool drawn = false;   ///< as spheres: positions must be there, and radii are unless columns are chosen
};

const std::vector<OutputFormat>& output_formats();
/// By the ending of a file's name; nullptr if there is no such format.
const OutputFormat* output_format(const std::string& path);
/// ".npz (NumPy), .csv, ... or .vtp (ParaView)"
std::string output_endings();

/// Names of columns, in the order in which files have them.
const std::vector<std::string>& output_columns();
/// Would the file be drawn, but has chosen columns without positions?
bool lacks_position(const OutputRequest& request);
/// A column that it has chosen, of contacts, which the scene has not; "" if there is none.
std::string lacking_contacts(const OutputRequest& request, const Scene& scene);

}  // namespace ballpark::scenes
