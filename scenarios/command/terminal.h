// The two streams: results go to standard output, progress and warnings to standard error.
#pragma once

#include <string>
#include <vector>

#include "scenarios/command/page.h"

namespace ballpark::command {

/// A page as wide and as colourful as standard output allows: 80 columns and plain unless it is a terminal.
Page page();

/// To standard output. A reader that has gone (`| head`) is no error; a full disk is a WriteError.
void print(const std::string& text);
/// To standard error, "ballpark: " before each line.
void complain(const std::string& text);
void warn(const std::vector<std::string>& warnings);

/// From now on Ctrl-C and `kill` set `interrupted()` instead of ending the program; a second time they end it.
void watch_for_interrupt();
bool interrupted();

/// One line on standard error that overwrites itself: only on a terminal.
class Progress {
 public:
  Progress(std::string label, bool wanted);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  void show(double fraction);

 private:
  std::string label_;
  bool on_;
  bool drawn_ = false;
  double started_, last_ = 0;
  double first_time_ = 0, first_fraction_ = -1;  // where the pace is measured from: what came before is not stepping
};

/// Seconds of a steady clock.
double now();

}  // namespace ballpark::command
