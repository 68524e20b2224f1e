// Watches a run and keeps what a page of it needs.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "ballpark/world.h"
#include "scenarios/view/history.h"
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
};

class Recorder {
 public:
  /// `frames`: at most so many will come. `scene` must outlive the recorder.
  Recorder(const Scene& scene, const Options& options, Columns columns, std::size_t frames, Limits limits = {});
  void add(const World& world);
  std::size_t frames() const { return recording_.times.size(); }
  Recording take();  ///< with notes of what is not shown as it was

 private:
  void begin(const World& world);
  void add_body(const BodyState& body, std::size_t index);
  double bytes_per_body() const;

  const Scene& scene_;
  int copies_;
  Columns columns_;
  std::size_t frames_;
  Limits limits_;
  ShownBodies shown_;
  Recording recording_;
  History history_;
  std::vector<bool> held_;  ///< bodies that are no longer finite
  std::size_t held_count_ = 0;
};

}  // namespace ballpark::view
