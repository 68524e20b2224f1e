#include "ballpark/watch.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace ballpark {

namespace {

/// Of a value that changes its sign in a step.
struct Zero {
  double time;
  const Watch* watch;
  bool rising;
};

double value_at(World& world, const Watch& watch, double t) {
  double value = 0;
  world.look_ahead(t, [&] { value = watch.value(); });
  return value;
}

/// Of the value that is fa at a and fb, of the other sign, at b. (Regula falsi as of Illinois: Dowell & Jarratt 1971,
/// BIT 11, 168; each third time the middle, so that the bracket shrinks whatever the value does.)
double zero_between(World& world, const Watch& watch, double a, double fa, double b, double fb) {
  constexpr int most = 200;
  const double close = 4 * std::numeric_limits<double>::epsilon() * std::max(std::abs(a), std::abs(b));
  int side = 0;
  const bool rising = fa < 0;
  for (int i = 0; i < most && b - a > close; ++i) {
    const double middle = a + (b - a) / 2, line = fb == 0 ? b - close : b - fb * ((b - a) / (fb - fa));
    const double t = i % 3 != 2 && line > a && line < b ? line : middle;
    const double value = value_at(world, watch, t);
    if (rising ? value >= 0 : value <= 0) {
      b = t, fb = value;
      if (side == 1) fa /= 2;
      side = 1;
    } else {
      a = t, fa = value;
      if (side == -1) fb /= 2;
      side = -1;
    }
  }
  return b;
}

void tell(World& world, std::vector<Zero> zeros) {
  std::stable_sort(zeros.begin(), zeros.end(), [](const Zero& x, const Zero& y) { return x.time < y.time; });
  for (const Zero& zero : zeros) {
    world.look_ahead(zero.time, [&] { zero.watch->seen(zero.time, zero.rising); });
  }
}

}  // namespace

void advance_watching(World& world, double end, std::span<const Watch> watches, std::uint64_t most_steps) {
  std::vector<double> before(watches.size()), after(watches.size());
  for (std::size_t w = 0; w < watches.size(); ++w) before[w] = watches[w].value();
  for (std::uint64_t i = 0; i < most_steps; ++i) {
    const double from = world.time();
    const std::uint64_t steps = world.steps();
    const Snapshot start = world.snapshot();
    world.approach(end, end, 1);
    if (world.steps() == steps) return;  // at the end, or as far as it goes
    std::vector<std::size_t> changed;
    for (std::size_t w = 0; w < watches.size(); ++w) {
      after[w] = watches[w].value();
      if ((before[w] < 0 && after[w] >= 0) || (before[w] > 0 && after[w] <= 0)) changed.push_back(w);
    }
    if (!changed.empty()) {
      const Snapshot done = world.snapshot();
      const double to = world.time();
      world.restore(start);
      std::vector<Zero> zeros;
      for (const std::size_t w : changed) {
        const double t = zero_between(world, watches[w], from, before[w], to, after[w]);
        zeros.push_back({t, &watches[w], before[w] < 0});
      }
      tell(world, std::move(zeros));
      world.restore(done);
    }
    std::swap(before, after);
  }
}

}  // namespace ballpark
