// Frames of shown bodies, added one after the other, until they are a recording.
#pragma once

#include <vector>

#include "ballpark/state.h"
#include "scenarios/view/recording.h"
#include "scenarios/view/shown.h"

namespace ballpark::view {

/// Beside positions.
struct Columns {
  bool orientation = true;  ///< where bodies have one
  bool speed = true;
  bool energy = false, contacts = false;
};

struct Limits {
  std::size_t bodies = 100'000;  ///< shown
  double memory = 1e9;           ///< that frames may take [B]
  /// Bodies that may be shown in so many frames.
  std::size_t shown(const Columns& columns, std::size_t frames) const;
};

class Film {
 public:
  /// `frames`: about so many will come, of `bodies` in all.
  void begin(const ShownBodies& shown, Columns columns, std::size_t frames, std::size_t bodies, const Vector3d& origin);
  const ShownBodies& shown() const { return shown_; }
  /// A frame is the shown bodies in their order, then its end; `contacts` where they are a column.
  void add(const BodyState& body, std::uint8_t contacts = 0);
  void end_frame(double time);
  std::size_t frames() const { return recording_.times.size(); }
  Recording take();  ///< with a note of bodies that are no longer finite

 private:
  void leave_out();
  void hold();

  Columns columns_;
  ShownBodies shown_;
  Recording recording_;
  std::size_t at_ = 0;      ///< the next body of the frame
  std::vector<bool> held_;  ///< bodies that are no longer finite
  std::size_t held_count_ = 0;
};

}  // namespace ballpark::view
