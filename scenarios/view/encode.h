// A recording as the page reads it: a header in JSON, and its columns as deflated differences in base64.
//
// Of each column, for frame f and component c: a byte of each shown body, or of 16 bits all low bytes and then all
// high ones. Values are differences along time of what was quantised, modulo 2^bits, before the first frame zeros: of
// positions and orientations second ones, q[f] - 2 q[f-1] + q[f-2], since bodies move on.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "scenarios/view/recording.h"

namespace ballpark::view {

struct Encoded {
  std::string header;  ///< JSON
  std::string data;    ///< base64 of zlib's format
  struct Column {
    std::string name;
    std::size_t bytes = 0;  ///< in the page
  };
  std::vector<Column> columns;
  std::size_t bodies = 0, shown = 0, stride = 1, frames = 0;
  std::vector<std::string> notes;
  std::size_t bytes() const { return header.size() + data.size(); }
};

Encoded encode(const Recording& recording);

/// At most `limit` bytes for all together, in equal shares: with as many bodies as there is room for. None if there is
/// not even room for one body of each group.
std::optional<std::vector<Encoded>> encode_within(const std::vector<const Recording*>& recordings, std::size_t limit);

}  // namespace ballpark::view
