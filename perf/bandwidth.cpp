#include "perf/bandwidth.h"

#include <algorithm>
#include <thread>
#include <vector>

#include "perf/machine.h"
#include "perf/timing.h"

namespace ballpark::perf {

namespace {

constexpr std::size_t megabyte = std::size_t{1} << 20;

// Twice the last-level cache, within reason; all three must fit into a quarter of the memory.
std::size_t array_bytes() {
  const Machine here = machine();
  const std::size_t wanted = std::clamp(2 * here.level3_bytes, 64 * megabyte, 256 * megabyte);
  return here.memory_bytes == 0 ? wanted : std::min(wanted, here.memory_bytes / 12);
}

// Not inlined: repeated sweeps must not be merged into one.
[[gnu::noinline]] void triad(double* __restrict a, const double* __restrict b, const double* __restrict c,
                             std::size_t first, std::size_t last) {
  constexpr double s = 0.5;
  for (std::size_t i = first; i < last; ++i) a[i] = b[i] + s * c[i];
}

}  // namespace

template <class Work>
void Triad::on_slices(const Work& work) {
  const auto count = static_cast<std::size_t>(threads_);
  const auto slice = [&](std::size_t t) { work(elements_ * t / count, elements_ * (t + 1) / count); };
  std::vector<std::thread> others;
  for (std::size_t t = 1; t < count; ++t) others.emplace_back(slice, t);
  slice(0);
  for (std::thread& other : others) other.join();
}

Triad::Triad(int threads)
    : threads_(std::max(threads, 1)),
      elements_(array_bytes() / sizeof(double)),
      a_(std::make_unique_for_overwrite<double[]>(elements_)),
      b_(std::make_unique_for_overwrite<double[]>(elements_)),
      c_(std::make_unique_for_overwrite<double[]>(elements_)) {
  on_slices([this](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      a_[i] = 0;
      b_[i] = 1;
      c_[i] = 2;
    }
  });
}

void Triad::sweep(int times) {
  on_slices([this, times](std::size_t first, std::size_t last) {
    for (int i = 0; i < times; ++i) triad(a_.get(), b_.get(), c_.get(), first, last);
  });
}

Bandwidth streaming_bandwidth(int threads) {
  constexpr int rounds = 10, sweeps = 2;  // two at a time: starting the threads must not count
  Triad triad_of_threads(threads);
  const Task sweep = [&] { triad_of_threads.sweep(sweeps); };
  const Samples samples = time_interleaved({&sweep, 1}, {.seconds = 0, .rounds = rounds}).front();
  const double bytes = sweeps * Triad::bytes_per_element * static_cast<double>(triad_of_threads.elements());
  return {bytes / samples.minimum()};
}

}  // namespace ballpark::perf
