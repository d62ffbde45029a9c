// Plans across a map of 1000 x 1000 cells without obstacles, the longest way of all.
#pragma once

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <string>
#include <vector>

#include "nav2_navfn_planner/navfn.hpp"

/// The line with the times of all rounds in ms, sorted.
inline std::string measured_navfn() {
  using Clock = std::chrono::steady_clock;
  constexpr int kSide = 1000;
  constexpr int kRounds = 10;
  nav2_navfn_planner::NavFn planner(kSide, kSide);
  const std::vector<unsigned char> costs(static_cast<size_t>(kSide) * kSide, 0);
  std::vector<double> times;
  size_t poses = 0;
  for (int round = 0; round < kRounds; ++round) {
    const auto begin = Clock::now();
    planner.setCostmap(costs.data(), true);
    planner.computePotential({10, 10}, {990, 990}, false, nullptr);
    poses = planner.path({990, 990}, 4 * kSide).size();
    times.push_back(std::chrono::duration<double, std::milli>(Clock::now() - begin).count());
  }
  std::sort(times.begin(), times.end());
  std::string line = "navfn " + std::to_string(poses) + " poses";
  for (const double time : times) line += " " + std::to_string(time);
  return line;
}
