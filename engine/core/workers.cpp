#include "engine/core/workers.h"

#include <algorithm>
#include <thread>

#include "engine/core/flush_denormals.h"

#ifdef BALLPARK_TBB
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

#include <mutex>
#else
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <vector>
#endif

namespace ballpark {

namespace {

void run_range(std::size_t first, std::size_t last, FunctionRef<void(std::size_t)> task) {
  FlushDenormals flush;
  for (std::size_t i = first; i < last; ++i) task(i);
}

#ifdef BALLPARK_TBB
/// TBB makes no more workers than there are cores unless told so, and of several limits the smallest counts: one limit
/// for the process, which only grows.
void allow(int threads) {
  using tbb::global_control;
  static std::mutex mutex;
  static std::unique_ptr<global_control> limit;
  const auto wanted = static_cast<std::size_t>(threads);
  const std::lock_guard lock(mutex);
  if (wanted <= global_control::active_value(global_control::max_allowed_parallelism)) return;
  limit.reset();
  limit = std::make_unique<global_control>(global_control::max_allowed_parallelism, wanted);
}
#endif

}  // namespace

#ifdef BALLPARK_TBB

struct Workers::Pool {
  explicit Pool(int threads) : arena(threads) { allow(threads); }
  void run(int, std::size_t count, FunctionRef<void(std::size_t)> task) {
    arena.execute([&] {
      tbb::parallel_for(
          tbb::blocked_range<std::size_t>(0, count),
          [&](const tbb::blocked_range<std::size_t>& range) { run_range(range.begin(), range.end(), task); },
          tbb::static_partitioner{});
    });
  }
  tbb::task_arena arena;
};

#else

struct Workers::Pool {
  explicit Pool(int threads) {
    for (int t = 1; t < threads; ++t) team.emplace_back([this, t, threads] { work(t, threads); });
  }
  ~Pool() {
    {
      std::lock_guard lock(mutex);
      stopping = true;
    }
    begin.notify_all();
    for (std::thread& thread : team) thread.join();
  }
  void run(int threads, std::size_t n, FunctionRef<void(std::size_t)> f) {
    {
      std::lock_guard lock(mutex);
      count = n;
      task = &f;
      busy = threads - 1;
      ++round;
    }
    begin.notify_all();
    share(0, threads);
    std::unique_lock lock(mutex);
    end.wait(lock, [this] { return busy == 0; });
  }
  void work(int index, int threads) {
    std::uint64_t seen = 0;
    for (;;) {
      {
        std::unique_lock lock(mutex);
        begin.wait(lock, [&] { return stopping || round != seen; });
        if (stopping) return;
        seen = round;
      }
      share(index, threads);
      std::lock_guard lock(mutex);
      if (--busy == 0) end.notify_one();
    }
  }
  void share(int index, int threads) {
    const std::size_t i = static_cast<std::size_t>(index), n = static_cast<std::size_t>(threads);
    run_range(count * i / n, count * (i + 1) / n, *task);
  }

  std::mutex mutex;
  std::condition_variable begin, end;
  std::size_t count = 0;
  FunctionRef<void(std::size_t)>* task = nullptr;
  int busy = 0;
  std::uint64_t round = 0;
  bool stopping = false;
  std::vector<std::thread> team;
};

#endif

Workers::Workers(int threads)
    : threads_(threads > 0 ? threads : std::max(1, static_cast<int>(std::thread::hardware_concurrency()))) {
  if (threads_ > 1) pool_ = std::make_unique<Pool>(threads_);
}
Workers::~Workers() = default;
Workers::Workers(Workers&&) noexcept = default;

void Workers::for_each(std::size_t count, FunctionRef<void(std::size_t)> task, int at_most) {
  if (count <= 1 || at_most <= 1 || !pool_) {
    run_range(0, count, task);
  } else {
    pool_->run(threads_, count, task);
  }
}

}  // namespace ballpark
