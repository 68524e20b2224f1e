// The state over time as NumPy's .npz: arrays time [T], id [N], position and velocity [T, N, 3], and where any body
// carries them orientation [T, N, 4] and angular_velocity [T, N, 3]. Stored, not compressed: states do not compress
// and np.load stays quick.
#pragma once

#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "scenarios/command/body_columns.h"
#include "scenarios/command/frame_file.h"
#include "scenarios/command/output_file.h"

namespace ballpark::command {

/// One array on its way to the archive: an unnamed file in `folder`, so that nothing is left behind whatever happens.
class ArraySpool {
 public:
  /// `type` as NumPy writes it: "<f8", "<u8". Throws DestinationError.
  ArraySpool(std::string name, std::string type, const std::string& folder);
  void append(const void* data, std::size_t size);  ///< throws WriteError
  /// Writes the header and hands the file over.
  std::FILE* close(const std::vector<std::size_t>& shape);
  const std::string& name() const { return name_; }

 private:
  struct Closer {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  std::string name_, type_;
  std::unique_ptr<std::FILE, Closer> file_;
};

class NpzFrames : public FrameFile {
 public:
  explicit NpzFrames(const std::string& path);
  void add(const World& world) override;
  void finish() override;

 private:
  void begin(const World& world);

  OutputFile file_;
  std::string folder_;
  ArraySpool time_, id_, position_, velocity_;
  std::optional<ArraySpool> orientation_, angular_velocity_;
  bool begun_ = false;
  std::size_t frames_ = 0, bodies_ = 0;
};

}  // namespace ballpark::command
