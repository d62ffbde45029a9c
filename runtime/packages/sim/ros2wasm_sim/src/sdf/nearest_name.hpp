// The name that was meant by one that does not exist.
#pragma once

#include <string>
#include <vector>

namespace ros2wasm_sim {

/// The one with the fewest changes of a letter, or nothing when all are too different.
std::string nearest_name(const std::string& wrong, const std::vector<std::string>& names);

}  // namespace ros2wasm_sim
