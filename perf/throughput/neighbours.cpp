// Near pairs: the grid of the broad phase beside nanoflann's k-d tree, on the same balls.
#include "perf/throughput/neighbours.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <random>

#include "engine/collide/grid.h"
#include "perf/peers/nanoflann.h"

namespace ballpark::perf {

namespace {

constexpr double diameter = 1, packing = 0.3;
constexpr double reach = 1.1 * diameter;  // a skin of a tenth

/// Balls at most a quarter of a diameter off the sites of a cubic lattice, in the grid's own order.
struct Heap {
  std::vector<double> points[3];
  std::size_t count() const { return points[0].size(); }
  f64::Balls balls() const {
    f64::Balls b;
    for (int c = 0; c < 3; ++c) b.position[c] = points[c].data();
    b.radius.value = diameter / 2;
    b.margin = reach - diameter;
    b.count = count();
    return b;
  }
};

Heap heap_of(std::size_t count) {
  const double spacing = diameter * std::cbrt(std::numbers::pi / 6 / packing);
  const auto side = static_cast<std::size_t>(std::ceil(std::cbrt(static_cast<double>(count))));
  Heap heap;
  std::mt19937 random(1);
  for (std::size_t i = 0; i < count; ++i) {
    const double site[3] = {static_cast<double>(i % side), static_cast<double>(i / side % side),
                            static_cast<double>(i / side / side)};
    for (std::size_t c = 0; c < 3; ++c) {
      const double off = static_cast<double>(random()) / 4294967296.0 - 0.5;  // the same on every machine
      heap.points[c].push_back(spacing * site[c] + 0.5 * diameter * off);
    }
  }
  Workers caller(1);
  f64::Grid grid;
  grid.find(heap.balls(), {}, caller);
  Heap sorted;
  for (std::size_t c = 0; c < 3; ++c) {
    for (const std::uint32_t row : grid.order()) sorted.points[c].push_back(heap.points[c][row]);
  }
  return sorted;
}

/// Each ball's number of near ones: what two finders must agree on.
StateColumns counts_of(const RowPairs& pairs, std::size_t balls) {
  std::vector<double> counts(balls);
  for (const auto& [a, b] : pairs) {
    ++counts[a];
    ++counts[b];
  }
  return {counts};
}

Subject grid_subject(std::string name, std::shared_ptr<const Heap> heap, int threads) {
  struct Finder {
    Workers workers;
    f64::Grid grid;
  };
  const auto finder = std::make_shared<Finder>(Finder{Workers(threads), {}});
  const auto find = [heap, finder] { finder->grid.find(heap->balls(), {}, finder->workers); };
  const auto state = [heap, finder] {
    RowPairs pairs;
    for (std::size_t b = 0; b < finder->grid.block_count(); ++b) {
      for (const f64::Pair& pair : finder->grid.pairs(b)) pairs.emplace_back(pair.a, pair.b);
    }
    return counts_of(pairs, heap->count());
  };
  return {.name = std::move(name),
          .bodies = heap->count(),
          .units = static_cast<double>(heap->count()),
          .bytes_per_unit = 3 * sizeof(double),
          .run = find,
          .state = state};
}

Subject nanoflann_subject(std::string name, std::shared_ptr<const Heap> heap) {
  const auto pairs = std::make_shared<RowPairs>();
  return {.name = std::move(name),
          .bodies = heap->count(),
          .units = static_cast<double>(heap->count()),
          .bytes_per_unit = 3 * sizeof(double),
          .run = [heap, pairs] { nanoflann_pairs(heap->points, reach, *pairs); },
          .state = [heap, pairs] { return counts_of(*pairs, heap->count()); }};
}

}  // namespace

Comparison neighbours(const Settings& settings) {
  const auto pairs_for_each = [](const Heap& heap) {
    Workers caller(1);
    f64::Grid grid;
    grid.find(heap.balls(), {}, caller);
    return static_cast<double>(grid.pair_count()) / static_cast<double>(heap.count());
  };
  const auto small = std::make_shared<Heap>(heap_of(std::min<std::size_t>(settings.bodies, 100'000)));
  const auto large = std::make_shared<Heap>(heap_of(settings.bodies));
  const std::string many = "grid, largest", threads = "grid, " + std::to_string(settings.threads) + " threads";
  Comparison c;
  c.title =
      "Near pairs: sorting into cells (or building the tree) and finding each pair once, double, one thread if not "
      "said";
  c.note = fmt::format(
      "Balls in the order of space, packing 0.3, reach 1.1 diameters: {:.2f} pairs a ball. grid and nanoflann: {} "
      "balls; "
      "largest: {}. ns: per ball.",
      pairs_for_each(*small), small->count(), large->count());
  c.subjects = {grid_subject("grid", small, 1), grid_subject(threads, small, settings.threads),
                grid_subject(many, large, 1)};
  if (has_nanoflann()) c.subjects.push_back(nanoflann_subject("nanoflann", small));
  c.ratios = {{"nanoflann / grid", {"nanoflann"}, {"grid"}, Bar{.at_most = false, .limit = 7, .aim = 10.0}},
              {"gain of threads, grid", {"grid"}, {threads}, {}}};
  c.agreements = {{"grid", "nanoflann", 0}, {"grid", threads, 0}};
  return c;
}

}  // namespace ballpark::perf
