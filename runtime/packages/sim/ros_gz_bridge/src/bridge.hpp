// The node `ros_gz_bridge`: topics and services of its arguments and of its `config_file`.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "bridge_argument.hpp"
#include "bridge_watch.hpp"
#include "rclcpp/rclcpp.hpp"
#include "relay.hpp"
#include "rosgraph_msgs/msg/clock.hpp"

namespace ros_gz_bridge {

class Bridge : public rclcpp::Node {
 public:
  Bridge();

  void add(const BridgeArgument& argument);

 private:
  void add_topic(const BridgeEntry& entry);
  /// Throws when `pair` is null, or when a topic cannot have its name.
  void add_relay(const BridgeEntry& entry, const TypePair* pair, bool to_ros);
  void add_service(const ServiceEntry& entry);
  void read_config_file();
  /// Reads the file the first time, and looks after relays that are lazy.
  void beat();

  bool has_read_file_ = false;
  Time now_;  ///< of the simulation, when a relay needs it
  rclcpp::Subscription<rosgraph_msgs::msg::Clock>::SharedPtr clock_;
  std::vector<std::unique_ptr<Relay>> relays_;
  BridgeWatch watch_;
  std::vector<std::shared_ptr<void>> services_;
  rclcpp::TimerBase::SharedPtr heartbeat_;
};

/// Runs the node with the topics and services of the command line until it is stopped. Returns the
/// exit code.
int run_bridge(int argc, char** argv, bool needs_arguments);

}  // namespace ros_gz_bridge
