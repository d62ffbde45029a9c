// The topics and services that a bridge carries.
#pragma once

#include <cstddef>
#include <string>

namespace ros_gz_bridge {

enum class Direction { kBoth, kGzToRos, kRosToGz };

struct BridgeEntry {
  std::string ros_topic, gz_topic;
  std::string ros_type, gz_type;  ///< `std_msgs/msg/String` and `gz.msgs.StringMsg`
  Direction direction = Direction::kBoth;
  std::size_t publisher_queue = 10, subscriber_queue = 10;  ///< messages
  bool is_lazy = false;  ///< carry only while somebody listens on the other side
};

/// A service of Gazebo that ROS may call.
struct ServiceEntry {
  std::string service;                ///< on both sides
  std::string ros_type;               ///< `ros_gz_interfaces/srv/ControlWorld`
  std::string gz_request, gz_answer;  ///< may be empty
};

}  // namespace ros_gz_bridge
