// The energy of any state, as one scene counts it: that of a run without an effect lacks the effect's potential.
#pragma once

#include "perf/cost/subject.h"

namespace ballpark::cost {

class Gauge {
 public:
  /// Of the scene at its end. Throws SceneError.
  Gauge(const Scene& scene, const Options& options);
  /// Of a track that knows all bodies at the end [J]; NaN where the scene cannot take its state.
  double energy(const Track& end);
  /// When and whom such a track looks at.
  const Samples& at_end() const { return at_end_; }

 private:
  void place(std::size_t id, BodyState state);

  World world_;
  Samples at_end_;
};

}  // namespace ballpark::cost
