// How fast this machine streams memory: the bound of every pass that computes little.
#pragma once

#include <cstddef>
#include <memory>

namespace ballpark::perf {

/// The STREAM triad a[i] = b[i] + s c[i] over three arrays, each much larger than the last-level cache. Its threads are
/// not pinned; each always sweeps the same slice, which it also was the first to touch.
class Triad {
 public:
  /// threads: at least 1. Arrays of twice the last-level cache, but 64 to 256 MB, and less where memory is tight.
  explicit Triad(int threads);
  std::size_t elements() const { return elements_; }
  /// Sweeps all elements `times` times.
  void sweep(int times);

  static constexpr double bytes_per_element = 24;  ///< as STREAM counts: the read that a write may cause is left out

 private:
  template <class Work>
  void on_slices(const Work& work);  // work(first, last), once per thread

  int threads_;
  std::size_t elements_;
  std::unique_ptr<double[]> a_, b_, c_;
};

struct Bandwidth {
  double bytes_per_second;
};

/// Of the triad, the best of several sweeps; about a quarter of a second.
Bandwidth streaming_bandwidth(int threads);

}  // namespace ballpark::perf
