// Threads for parallel passes. The only place that knows TBB; without it, a pool of std::thread does the same.
#pragma once

#include <cstddef>
#include <memory>

#include "engine/core/function_ref.h"

namespace ballpark {

class Workers {
 public:
  /// threads: how many work at once, the caller's included; 0: all cores.
  explicit Workers(int threads);
  ~Workers();
  Workers(Workers&&) noexcept;
  int threads() const { return threads_; }

  /// Runs task(i) once for each i in [0, count), on all threads (or the caller's alone: `at_most` = 1), each with
  /// denormals flushed; returns when all are done. Threads take fixed, contiguous shares.
  void for_each(std::size_t count, FunctionRef<void(std::size_t)> task, int at_most);
  void for_each(std::size_t count, FunctionRef<void(std::size_t)> task) { for_each(count, task, threads_); }

 private:
  struct Pool;
  int threads_;
  std::unique_ptr<Pool> pool_;
};

}  // namespace ballpark
