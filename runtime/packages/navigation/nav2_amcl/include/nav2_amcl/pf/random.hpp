// The random numbers of one filter. A seed gives the same numbers with every standard library.
#pragma once

#include <cstdint>
#include <random>

namespace nav2_amcl {

class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}

  /// In [0, 1).
  double uniform() { return static_cast<double>(engine_() >> 11) * 0x1.0p-53; }
  /// With mean 0 and deviation 1 (Marsaglia's polar method, which makes two numbers at a time).
  double gaussian();

 private:
  std::mt19937_64 engine_;
  bool has_second_ = false;
  double second_ = 0.0;
};

}  // namespace nav2_amcl
