// Arguments of parameter_bridge: `/scan@sensor_msgs/msg/LaserScan[gz.msgs.LaserScan`. Pure.
#pragma once

#include <optional>
#include <string>
#include <variant>

#include "bridge_entry.hpp"

namespace ros_gz_bridge {

using BridgeArgument = std::variant<BridgeEntry, ServiceEntry>;

/// Nothing for a text that is not one.
std::optional<BridgeArgument> read_bridge_argument(const std::string& text);

/// How parameter_bridge is called.
std::string bridge_usage();

}  // namespace ros_gz_bridge
