// DROP: balls fall into an open box, on Ballpark, ODE and Bullet in turns, with speed and overlap side by side: an
// engine that lets balls sink into each other is not faster.
#include "perf/throughput/drop.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <unordered_map>

#include "ballpark/ballpark.h"
#include "perf/machine.h"
#include "perf/peers/heap_engine.h"

namespace ballpark::perf {

namespace {

using Clock = std::chrono::steady_clock;

/// n balls on a lattice whose sites are shaken by sines: the same on every machine to the last digits of a sine.
HeapScene falling(std::size_t n) {
  HeapScene scene;
  const std::size_t nx = n <= 1000 ? 10 : n <= 10000 ? 25 : 50;
  const double s = 0.11;
  scene.width = static_cast<double>(nx) * s;
  for (std::size_t i = 0; i < n; ++i) {
    const auto k = static_cast<double>(i);
    const auto ix = static_cast<double>(i % nx), iy = static_cast<double>(i / nx % nx),
               iz = static_cast<double>(i / nx / nx);
    scene.positions.push_back({s * (ix + 0.5) + 0.004 * std::sin(12.9898 * k),
                               s * (iy + 0.5) + 0.004 * std::sin(78.233 * k),
                               0.15 + s * iz + 0.004 * std::sin(37.719 * k)});
  }
  return scene;
}

class BallparkHeap : public HeapEngine {
 public:
  BallparkHeap(const HeapScene& heap, int threads) : world_(scene_of(heap), {.threads = threads}) {}
  void step() override { world_.step(); }
  std::vector<std::array<double, 3>> positions() const override {
    const auto x = world_.view<double>("position");
    std::vector<std::array<double, 3>> list;
    for (std::size_t id = 0; id < world_.body_count(); ++id) {
      const std::size_t row = world_.row_of(id) - x.first_row;
      list.push_back({x[0][row], x[1][row], x[2][row]});
    }
    return list;
  }
  const ballpark::World& world() const { return world_; }

 private:
  static ballpark::Scene scene_of(const HeapScene& heap) {
    ballpark::Scene scene;
    scene.run.duration = 10;
    scene.run.step = heap.step;
    scene.run.integrator = "semi_implicit_euler";
    scene.contact.kind = "impulse";
    scene.materials["ball"] = {heap.restitution, heap.friction};
    ballpark::BodyGroup balls;
    balls.name = "balls", balls.shape = "sphere", balls.material = "ball";
    balls.radius = {heap.radius}, balls.density = {heap.density};
    for (const auto& x : heap.positions) balls.position.push_back({x[0], x[1], x[2]});
    scene.bodies = {balls};
    ballpark::Boundary box;
    box.shape = "box", box.material = "ball", box.open = {"+z"};
    box.size = {heap.width, heap.width, 100}, box.point = {heap.width / 2, heap.width / 2, 50};
    scene.boundaries = {box};
    scene.effects = {
        {.kind = "gravity", .groups = {}, .parameters = {{"acceleration", ballpark::Vector3d(0, 0, -heap.gravity)}}}};
    return scene;
  }
  ballpark::World world_;
};

/// Overlaps of ball pairs, in radii.
struct Overlaps {
  double worst = 0, mean = 0;
  std::size_t lost = 0;  ///< balls whose centre is outside the box
};

Overlaps overlaps(const HeapScene& scene, const std::vector<std::array<double, 3>>& x) {
  const double cell = 2 * scene.radius;
  const auto key = [&](double a, double b, double c) {
    const auto index = [&](double v) { return static_cast<std::int64_t>(std::floor(v / cell)) + 100000; };
    return (index(a) * 1000003 + index(b)) * 1000003 + index(c);
  };
  std::unordered_map<std::int64_t, std::vector<std::size_t>> cells;
  Overlaps all;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const auto& p = x[i];
    const bool inside = p[0] > 0 && p[1] > 0 && p[2] > 0 && p[0] < scene.width && p[1] < scene.width;
    all.lost += !inside;
    cells[key(p[0], p[1], p[2])].push_back(i);
  }
  double sum = 0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    for (int n = 0; n < 27; ++n) {
      const auto found =
          cells.find(key(x[i][0] + (n % 3 - 1) * cell, x[i][1] + (n / 3 % 3 - 1) * cell, x[i][2] + (n / 9 - 1) * cell));
      if (found == cells.end()) continue;
      for (const std::size_t j : found->second) {
        if (j <= i) continue;
        const double depth = 2 * scene.radius - std::hypot(x[j][0] - x[i][0], x[j][1] - x[i][1], x[j][2] - x[i][2]);
        if (!(depth > 0)) continue;
        all.worst = std::max(all.worst, depth / scene.radius);
        sum += depth / scene.radius;
        ++count;
      }
    }
  }
  if (count > 0) all.mean = sum / static_cast<double>(count);
  return all;
}

/// One engine on its way through the 600 steps.
struct Runner {
  std::string name;
  std::unique_ptr<HeapEngine> engine;
  double seconds = 0;
  std::vector<double> slices;  ///< seconds of each slice of steps
  double worst = 0, resting = 0;
  std::size_t lost = 0;

  void advance(const HeapScene& scene, int steps) {
    double slice = 0;
    for (int i = 0; i < steps; ++i) {
      const auto start = Clock::now();
      engine->step();
      slice += std::chrono::duration<double>(Clock::now() - start).count();
      const Overlaps now = overlaps(scene, engine->positions());
      worst = std::max(worst, now.worst);
      resting = now.mean;
      lost = now.lost;
    }
    slices.push_back(slice);
    seconds += slice;
  }
};

void report(const std::vector<Runner>& runners, std::size_t balls, int steps) {
  const double work = static_cast<double>(balls) * steps;
  fmt::print("{:<22}{:>10}{:>16}{:>12}{:>18}{:>16}{:>8}\n", "", "ms/step", "ball-steps/s", "to the 1st",
             "worst overlap/r", "at the end/r", "lost");
  for (const Runner& r : runners) {
    fmt::print("{:<22}{:>10.2f}{:>16.4g}{:>12.2f}{:>18.4f}{:>16.4f}{:>8}\n", r.name, 1e3 * r.seconds / steps,
               work / r.seconds, r.seconds / runners.front().seconds, r.worst, r.resting, r.lost);
  }
  for (std::size_t k = 1; k < runners.size(); ++k) {
    std::vector<double> ratios;
    for (std::size_t i = 0; i < runners[k].slices.size(); ++i) {
      ratios.push_back(runners[k].slices[i] / runners[0].slices[i]);
    }
    std::sort(ratios.begin(), ratios.end());
    fmt::print("  {} / {}: {:.2f} in all; slices of {} steps: least {:.2f}, median {:.2f}\n", runners[k].name,
               runners[0].name, runners[k].seconds / runners[0].seconds, steps / static_cast<int>(ratios.size()),
               ratios.front(), ratios[ratios.size() / 2]);
  }
  const auto& ours = static_cast<const BallparkHeap&>(*runners.front().engine).world();
  fmt::print(
      "  Ballpark: {:.0f} B a ball for columns and contacts; {} motions cut short\n",
      static_cast<double>(ours.explain().column_bytes + ours.explain().contact.bytes) / static_cast<double>(balls),
      ours.counters().held_back);
}

}  // namespace

void drop(const DropSettings& settings) {
  const std::size_t balls = settings.balls;
  const int steps = settings.steps, threads = settings.threads;
  const HeapScene scene = falling(balls);
  std::vector<Runner> runners;
  const auto add = [&](const std::string& name, std::unique_ptr<HeapEngine> engine) {
    if (engine) runners.push_back({name, std::move(engine), 0, {}, 0, 0, 0});
  };
  add("Ballpark", std::make_unique<BallparkHeap>(scene, 1));
  add(fmt::format("Ballpark, {} threads", threads), std::make_unique<BallparkHeap>(scene, threads));
  if (!settings.alone) {
    add("ODE QuickStep", ode_heap(scene));
    add("Bullet", bullet_heap(scene));
  }
  const Machine here = machine();
  fmt::print("DROP({}), {} steps of 1/60 s, one thread if not said, {}\n", balls, steps, here.processor);
  const int slices = 10;
  for (int slice = 0; slice < slices; ++slice) {
    for (Runner& runner : runners) runner.advance(scene, steps / slices);
  }
  report(runners, balls, steps / slices * slices);
}

}  // namespace ballpark::perf
