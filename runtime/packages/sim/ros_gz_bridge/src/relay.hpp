// Carries messages from one topic to another, one way.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "bridge_entry.hpp"
#include "rclcpp/rclcpp.hpp"
#include "type_pairs.hpp"

namespace ros_gz_bridge {

struct RelayOptions {
  bool to_ros = false;  ///< else to Gazebo
  /// The stamps of messages for ROS become the wall's time.
  bool stamps_with_wall_time = false;
  /// The time of the simulation.
  std::function<Time()> now;
};

class Relay {
 public:
  Relay(rclcpp::Node& node, const BridgeEntry& entry, const TypePair& pair, RelayOptions options);

  /// Starts and stops listening, of a lazy entry: to be called from time to time.
  void look();

 private:
  void listen();
  void carry(const std::shared_ptr<Bytes>& bytes);

  rclcpp::Node& node_;
  BridgeEntry entry_;
  const TypePair& pair_;
  RelayOptions options_;
  bool has_reported_ = false;
  rclcpp::GenericPublisher::SharedPtr publisher_;
  rclcpp::GenericSubscription::SharedPtr subscription_;
};

}  // namespace ros_gz_bridge
