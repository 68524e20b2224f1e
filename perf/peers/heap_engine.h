// An engine that lets balls fall into an open box: what the engines of the comparison DROP have in common.
#pragma once

#include <array>
#include <memory>
#include <vector>

namespace ballpark::perf {

/// Balls of one size, at rest, in a box without a lid; SI.
struct HeapScene {
  std::vector<std::array<double, 3>> positions;
  double radius = 0.05, density = 1000;
  double width = 0;  ///< walls at x, y = 0 and width; floor z = 0
  double gravity = 9.81, friction = 0.5, restitution = 0.1, step = 1.0 / 60;
};

class HeapEngine {
 public:
  virtual ~HeapEngine() = default;
  virtual void step() = 0;
  virtual std::vector<std::array<double, 3>> positions() const = 0;
};

/// Open Dynamics Engine: QuickStep, 10 iterations; null if it was not there when this was built.
std::unique_ptr<HeapEngine> ode_heap(const HeapScene& scene);
/// Bullet: its sequential impulse solver, 10 iterations; null if it was not there.
std::unique_ptr<HeapEngine> bullet_heap(const HeapScene& scene);

}  // namespace ballpark::perf
