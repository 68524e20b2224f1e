// The head of NumPy's arrays.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace ballpark::scenes {

struct NpyLayout {
  std::string type;                ///< as NumPy has it: <f8
  std::vector<std::size_t> shape;  ///< in C order
  std::size_t item_size() const;   ///< of <f8 and <f4 [B]; of all else 0
  std::string shape_text() const;  ///< (3, 4)
};

/// Takes magic, version and header off the bytes. Throws std::runtime_error with what is wrong with them.
NpyLayout take_npy_header(std::string_view& bytes);

}  // namespace ballpark::scenes
