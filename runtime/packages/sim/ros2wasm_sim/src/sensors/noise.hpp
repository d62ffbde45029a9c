// The noise of sensors, from a generator of its own for each sensor, so that a seed gives the same
// values whatever else runs.
#pragma once

#include <cmath>
#include <cstdint>
#include <string>

#include "world/world.hpp"

namespace ros2wasm_sim {

/// xoshiro-like generators differ between libraries; this one (SplitMix64) is the same everywhere.
class Random {
 public:
  Random(std::uint64_t seed, const std::string& name) : state_(seed) {
    for (const char sign : name)
      state_ = (state_ ^ static_cast<unsigned char>(sign)) * 1099511628211ULL;
  }

  /// 64 random bits.
  std::uint64_t bits() {
    state_ += 0x9e3779b97f4a7c15ULL;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
    return z ^ (z >> 31);
  }

  /// In [0, 1).
  double uniform() { return static_cast<double>(bits() >> 11) * 0x1.0p-53; }

  /// With mean 0 and deviation 1 (Box and Muller).
  double gaussian() {
    const double radius = std::sqrt(-2 * std::log(1 - uniform()));
    return radius * std::cos(6.283185307179586 * uniform());
  }

 private:
  std::uint64_t state_;
};

/// <noise> of SDF: out = in + bias + N(mean, stddev). The bias is drawn once, with either sign.
class Noise {
 public:
  Noise() = default;
  /// `element` has the parameters, or is null.
  static Noise read(const XmlView& xml, const ros2wasm_xml::XmlElement* element, Random& random);

  bool exists() const { return exists_; }
  double stddev() const { return stddev_; }
  double apply(double value, Random& random) const {
    if (!exists_) return value;
    const double out = value + bias_ + mean_ + stddev_ * random.gaussian();
    return precision_ > 0 ? std::round(out / precision_) * precision_ : out;
  }

 private:
  bool exists_ = false;
  double mean_ = 0;
  double stddev_ = 0;
  double bias_ = 0;
  double precision_ = 0;
};

}  // namespace ros2wasm_sim
