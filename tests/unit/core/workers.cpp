// Workers: every task once, on as many threads as asked for, whatever the machine has.
#include "engine/core/workers.h"

#include <atomic>
#include <chrono>
#include <numeric>
#include <set>
#include <thread>
#include <vector>

#include "tests/catch.h"

using ballpark::Workers;

TEST_CASE("Workers: every task runs once, for any number of tasks and threads", "[workers]") {
  for (const int threads : {1, 2, 3, 8}) {
    Workers workers(threads);
    CHECK(workers.threads() == threads);
    for (const std::size_t count : {0u, 1u, 2u, 7u, 8u, 1000u}) {
      std::vector<std::atomic<int>> runs(count);
      workers.for_each(count, [&](std::size_t i) { ++runs[i]; });
      for (const std::atomic<int>& n : runs) CHECK(n == 1);
    }
  }
}

TEST_CASE("Workers: asked for more threads than there are cores, all of them work at once", "[workers]") {
  const int threads = static_cast<int>(std::thread::hardware_concurrency()) + 3;
  Workers workers(threads);
  std::atomic<int> waiting = 0;
  std::vector<std::thread::id> who(static_cast<std::size_t>(threads));
  const auto give_up = std::chrono::steady_clock::now() + std::chrono::seconds(60);
  workers.for_each(who.size(), [&](std::size_t i) {
    who[i] = std::this_thread::get_id();
    for (++waiting; waiting < threads && std::chrono::steady_clock::now() < give_up;) std::this_thread::yield();
  });
  CHECK(std::set<std::thread::id>(who.begin(), who.end()).size() == who.size());
}

TEST_CASE("Workers: at most one thread is the caller", "[workers]") {
  Workers workers(4);
  const auto caller = std::this_thread::get_id();
  std::size_t others = 0;
  workers.for_each(
      100, [&](std::size_t) { others += std::this_thread::get_id() != caller; }, 1);
  CHECK(others == 0);
}

TEST_CASE("Workers: several pools live and work side by side", "[workers]") {
  std::vector<std::size_t> sums(4);
  std::vector<std::thread> callers;
  for (std::size_t& sum : sums) {
    callers.emplace_back([&sum] {
      Workers workers(3);
      std::vector<std::size_t> squares(64);
      for (int round = 0; round < 50; ++round) workers.for_each(64, [&](std::size_t i) { squares[i] = i * i; });
      sum = std::accumulate(squares.begin(), squares.end(), std::size_t{0});
    });
  }
  for (std::thread& caller : callers) caller.join();
  for (const std::size_t sum : sums) CHECK(sum == 63 * 64 * 127 / 6);
}
