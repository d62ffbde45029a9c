// Which types of ROS and Gazebo belong to each other: one row per pair.
//
// On Gazebo's side a message is one of ROS too, of the type that the simulator uses for that type
// of Gazebo. Where the bridge's ROS type is that one, bytes pass as they are.
#pragma once

#include <string>

#include "builtin_interfaces/msg/time.hpp"
#include "rclcpp/serialized_message.hpp"

namespace ros_gz_bridge {

using Time = builtin_interfaces::msg::Time;
using Bytes = rclcpp::SerializedMessage;

/// From the message on Gazebo's side to the one of the bridge, and back. Throws for bytes that are
/// not such a message. `now`: the time of the simulation, for types of Gazebo without a header
/// here.
struct Conversion {
  Bytes (*to_ros)(const Bytes& bytes, const Time& now);
  Bytes (*to_gz)(const Bytes& bytes, const Time& now);
};

struct TypePair {
  const char* ros_type;
  const char* gz_type;                     ///< without `gz.msgs.`
  const char* hidden_type;                 ///< of ROS, on Gazebo's side
  const Conversion* conversion = nullptr;  ///< null: bytes pass as they are
  bool begins_with_header = false;         ///< the ROS type: its first bytes are the stamp
};

/// `gz_type` as the user writes it: `gz.msgs.Twist` or `ignition.msgs.Twist`. Null: they do not
/// belong to each other.
const TypePair* find_type_pair(const std::string& ros_type, const std::string& gz_type);

}  // namespace ros_gz_bridge
