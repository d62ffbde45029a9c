// Says when a wait begins and ends, for a test that holds the time meanwhile.
#pragma once

#include <chrono>
#include <cstdio>

constexpr std::chrono::milliseconds kWhile{100};

/// The wait must take kWhile.
template <typename WaitT>
void wait_by(const char* way, WaitT&& wait) {
  std::printf("%s begins\n", way);
  const auto before = std::chrono::steady_clock::now();
  wait();
  const auto passed = std::chrono::steady_clock::now() - before;
  std::printf("%s ends after %.3f ms\n", way,
              std::chrono::duration<double, std::milli>(passed).count());
}
