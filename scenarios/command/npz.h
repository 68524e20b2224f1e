// The state over time as NumPy's .npz: arrays time [T], id [N], a column's name [T, N, 3] (orientation [T, N, 4],
// contacts [T, N]), and radius [N] if it was asked for. Stored, not compressed: states do not compress and np.load
// stays quick.
#pragma once

#include <cstdio>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "scenarios/command/frame_file.h"
#include "scenarios/command/output_file.h"
#include "scenarios/command/stored_zip.h"

namespace ballpark::command {

/// One array on its way to the archive: an unnamed file in `folder`, so that nothing is left behind whatever happens.
class ArraySpool {
 public:
  /// `type` as NumPy writes it: "<f8", "<u8". Throws DestinationError.
  ArraySpool(std::string name, std::string type, const std::string& folder);
  void append(std::string_view data);  ///< throws WriteError
  /// As the next entry of the archive that is written to `file`. Throws WriteError.
  void move_to(StoredZip& archive, OutputFile& file, const std::vector<std::size_t>& shape);

 private:
  struct Closer {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  std::string name_, type_;
  std::unique_ptr<std::FILE, Closer> file_;
  std::uint32_t crc_ = 0;  ///< of what was appended
  std::uint64_t size_ = 0;
};

class NpzFrames : public FrameFile {
 public:
  NpzFrames(const std::string& path, bool single);
  void begin(const FrameLayout& layout) override;
  void add(const Frames& frames) override;
  void finish() override;
  std::uint64_t bytes() const override { return file_.bytes(); }

 private:
  void append(ArraySpool& spool, std::span<const double> values);

  OutputFile file_;
  bool single_;
  std::string folder_, type_;
  FrameLayout layout_;
  ArraySpool time_, id_;
  std::vector<ArraySpool> columns_;  ///< as in the layout, then the radius
  std::size_t frames_ = 0;
};

}  // namespace ballpark::command
