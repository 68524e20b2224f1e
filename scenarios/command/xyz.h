// The state over time as extended XYZ, which OVITO and ASE open: frame after frame, a line per body. Numbers are SI.
#pragma once

#include <string>

#include "scenarios/command/frame_file.h"
#include "scenarios/command/output_file.h"

namespace ballpark::command {

/// Where space repeats, as the comment line of each frame says it: Lattice, Origin, pbc.
std::string xyz_cell(const Scene& scene);

class XyzFrames : public FrameFile {
 public:
  XyzFrames(const std::string& path, bool single, std::string cell)
      : file_(path), single_(single), cell_(std::move(cell)) {}
  void begin(const FrameLayout& layout) override;
  void add(const Frames& frames) override;
  void finish() override { file_.commit(); }
  std::uint64_t bytes() const override { return file_.bytes(); }

 private:
  void add_frame(const Frames& frames, std::size_t frame);

  OutputFile file_;
  bool single_;
  std::string cell_, properties_;
  FrameLayout layout_;
};

}  // namespace ballpark::command
