// Tasks in threads, and what they leave.
// Guarantee, robust: what packs do in several threads (archives are fetched and unpacked, packages
// are built) has no data race: its tests run under the thread sanitizer

#include "bundler/io/worker_pool.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <numeric>
#include <vector>

namespace ros2wasm {
namespace {

TEST(WorkerPool, WhatTasksWroteIsSeenWhenAllAreDone) {
  constexpr std::size_t kTasks = 2000;
  std::vector<std::size_t> results(kTasks);
  std::atomic<std::size_t> ran = 0;
  {
    WorkerPool pool;
    for (std::size_t i = 0; i < kTasks; ++i) {
      pool.add([&results, &ran, i] {
        results[i] = i;
        ++ran;
      });
    }
    while (!pool.wait(1000)) {
    }
    EXPECT_EQ(ran, kTasks);
    EXPECT_EQ(std::accumulate(results.begin(), results.end(), std::size_t{0}),
              kTasks * (kTasks - 1) / 2);
  }
}

}  // namespace
}  // namespace ros2wasm
