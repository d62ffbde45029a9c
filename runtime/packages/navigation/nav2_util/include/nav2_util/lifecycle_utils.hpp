// Starts and resets managed nodes from outside, in order.
#pragma once

#include <chrono>
#include <string>
#include <vector>

#include "nav2_util/string_utils.hpp"

namespace nav2_util {

/// Configures and activates each. A call that fails is repeated `retries` times.
void startup_lifecycle_nodes(
    const std::vector<std::string>& node_names,
    const std::chrono::seconds service_call_timeout = std::chrono::seconds::max(),
    const int retries = 3);
/// Deactivates and cleans up each.
void reset_lifecycle_nodes(
    const std::vector<std::string>& node_names,
    const std::chrono::seconds service_call_timeout = std::chrono::seconds::max(),
    const int retries = 3);

/// The same with names between colons: `/node1:/node2`.
inline void startup_lifecycle_nodes(
    const std::string& nodes,
    const std::chrono::seconds service_call_timeout = std::chrono::seconds::max(),
    const int retries = 3) {
  startup_lifecycle_nodes(split(nodes, ':'), service_call_timeout, retries);
}
inline void reset_lifecycle_nodes(
    const std::string& nodes,
    const std::chrono::seconds service_call_timeout = std::chrono::seconds::max(),
    const int retries = 3) {
  reset_lifecycle_nodes(split(nodes, ':'), service_call_timeout, retries);
}

}  // namespace nav2_util
