// The state as CSV: over time, or once. Reading a number back gives the same bits.
#pragma once

#include <optional>
#include <string>

#include "ballpark/world.h"
#include "scenarios/command/frame_file.h"
#include "scenarios/command/output_file.h"

namespace ballpark::command {

/// One row per frame and body: time, id, then the columns.
class CsvFrames : public FrameFile {
 public:
  CsvFrames(const std::string& path, bool single) : file_(path), single_(single) {}
  void begin(const FrameLayout& layout) override;
  void add(const Frames& frames) override;
  void finish() override { file_.commit(); }
  std::uint64_t bytes() const override { return file_.bytes(); }

 private:
  OutputFile file_;
  bool single_;
  FrameLayout layout_;
};

/// Header, then one row per body: id, then what bodies carry.
void write_state(const World& world, const Scene& scene, OutputFile& file);

}  // namespace ballpark::command
