// How the sums of a run go over time: energy, momenta, contacts, speed.
#pragma once

#include <vector>

#include "ballpark/world.h"
#include "scenarios/view/recording.h"

namespace ballpark::view {

/// Samples a world now and then. Each sample is a pass over all bodies.
class History {
 public:
  /// What the scene has: without contacts, none of them. `ledger`: and that of the world.
  explicit History(const Scene& scene, bool ledger = false);
  void add(const World& world);
  /// What was done since add() is no part of the steps to come: their time begins now.
  void go_on();
  const std::vector<double>& times() const { return times_; }
  std::vector<Series> take();

 private:
  void add(const Ledger& ledger);

  bool touching_, ledger_;
  double substeps_;
  std::vector<double> times_;  ///< [s]
  std::vector<Series> series_;
  Counters before_;
  double left_ = 0;  ///< when the last sample was taken [s of a clock]
};

}  // namespace ballpark::view
