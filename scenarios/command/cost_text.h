// What `ballpark cost` prints and writes.
#pragma once

#include <optional>
#include <string>

#include "ballpark/scenes.h"
#include "perf/cost/result.h"
#include "scenarios/command/arguments.h"
#include "scenarios/command/deliver.h"
#include "scenarios/command/output_file.h"
#include "scenarios/command/page.h"

namespace ballpark::command {

std::string cost_text(const cost::Result& result);
/// What errors are held against.
void add_ground(Page& page, const cost::Result& result);

/// Statistics beyond the horizon.
void add_ensemble(Page& page, const cost::Ensemble& ensemble);

/// "1.2340 +- 0.0021 J": as many digits as the margin makes known.
std::string mean_text(const cost::Mean& mean, const cost::Observable& observable);

/// The whole command's progress, from the part that it is at.
double overall(const std::string& what, double fraction);

/// The files asked for, opened before anything is measured.
class CostFiles {
 public:
  CostFiles(const Arguments& arguments, const scenes::SceneFile& file);
  /// What was written, as lines of text.
  std::string write(const cost::Result& result, const Json& json);

 private:
  std::optional<OutputFile> csv_, svg_, html_;
  const scenes::SceneFile& file_;
  bool write_back_ = false;
};

}  // namespace ballpark::command
