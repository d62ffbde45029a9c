// Whether the simulation keeps up with time. Pure: both times come in.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "world/world.hpp"

namespace ros2wasm_sim {

class RealTimeWatch {
 public:
  /// Takes the time that passed and that was simulated since the last call. Returns the factor,
  /// once, when it was below 0.9 of `wanted` for 5 s without a break.
  std::optional<double> add(std::int64_t passed_ns, std::int64_t simulated_ns, double wanted);
  /// The time until the next call does not count: the world was paused.
  void restart() { passed_ns_ = simulated_ns_ = 0; }

 private:
  std::int64_t passed_ns_ = 0, simulated_ns_ = 0;
  bool has_said_ = false;
};

/// The parts of a world that take time: cameras, lidars, links that move, meshes.
std::string costs_of(const World& world);

}  // namespace ros2wasm_sim
