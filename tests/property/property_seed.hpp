// The first seed of a property test: printed, and taken from R2W_PROPERTY_SEED to repeat a run.
#pragma once

#include <cstdlib>
#include <iostream>

namespace ros2wasm::testing {

inline unsigned first_seed() {
  const char* given = std::getenv("R2W_PROPERTY_SEED");
  const unsigned seed =
      given == nullptr ? 1U : static_cast<unsigned>(std::strtoul(given, nullptr, 10));
  std::cout << "R2W_PROPERTY_SEED=" << seed << "\n";
  return seed;
}

}  // namespace ros2wasm::testing
