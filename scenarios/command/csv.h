// The state as CSV: over time, or once. 17 significant digits: reading it back gives the same bits.
#pragma once

#include <string>

#include "scenarios/command/body_columns.h"
#include "scenarios/command/frame_file.h"
#include "scenarios/command/output_file.h"

namespace ballpark::command {

/// One row per frame and body: time, then the columns of the state.
class CsvFrames : public FrameFile {
 public:
  explicit CsvFrames(const std::string& path) : file_(path) {}
  void add(const World& world) override;
  void finish() override { file_.commit(); }

 private:
  OutputFile file_;
  std::optional<CarriedColumns> carried_;
};

/// Header, then one row per body.
void write_state(const World& world, OutputFile& file);

}  // namespace ballpark::command
