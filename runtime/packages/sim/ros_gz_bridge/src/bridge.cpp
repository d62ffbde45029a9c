// See bridge.hpp. The lines of the log are those of ros_gz_bridge.
#include "bridge.hpp"

#include <iostream>
#include <stdexcept>
#include <utility>
#include <variant>

#include "bridge_config.hpp"
#include "rclcpp/expand_topic_or_service_name.hpp"
#include "ros2wasm_sim/gz_names.hpp"
#include "service_relay.hpp"

namespace ros_gz_bridge {

Bridge::Bridge() : rclcpp::Node("ros_gz_bridge") {
  const auto heartbeat_ms = declare_parameter("subscription_heartbeat", 1000);
  declare_parameter("config_file", "");
  declare_parameter("expand_gz_topic_names", false);
  declare_parameter("override_timestamps_with_wall_time", false);
  declare_parameter("lazy", false);
  heartbeat_ = create_wall_timer(std::chrono::milliseconds(heartbeat_ms), [this] { beat(); });
}

void Bridge::add(const BridgeArgument& argument) {
  if (const auto* service = std::get_if<ServiceEntry>(&argument)) {
    add_service(*service);
  } else {
    add_topic(std::get<BridgeEntry>(argument));
  }
}

void Bridge::add_topic(const BridgeEntry& entry) {
  const TypePair* const pair = find_type_pair(entry.ros_type, entry.gz_type);
  const auto report = [&](const char* way, const std::string& from, const std::string& to) {
    RCLCPP_INFO(get_logger(), "Creating %s Bridge: [%s -> %s] (Lazy %d)", way, from.c_str(),
                to.c_str(), static_cast<int>(entry.is_lazy));
  };
  const std::string ros = entry.ros_topic + " (" + entry.ros_type + ")";
  const std::string gz = entry.gz_topic + " (" + entry.gz_type + ")";
  try {
    if (entry.direction != Direction::kRosToGz) {
      report("GZ->ROS", gz, ros);
      add_relay(entry, pair, true);
    }
    if (entry.direction != Direction::kGzToRos) {
      report("ROS->GZ", ros, gz);
      add_relay(entry, pair, false);
    }
    watch_.add(entry, *pair);
  } catch (const std::exception&) {
    RCLCPP_WARN(get_logger(),
                "Failed to create a bridge for topic [%s] with ROS2 type [%s] to topic [%s] with "
                "Gazebo Transport type [%s]",
                entry.ros_topic.c_str(), entry.ros_type.c_str(), entry.gz_topic.c_str(),
                entry.gz_type.c_str());
  }
}

void Bridge::add_relay(const BridgeEntry& entry, const TypePair* pair, bool to_ros) {
  if (pair == nullptr) throw std::runtime_error("no such pair of types");
  if (to_ros && pair->conversion != nullptr && pair->begins_with_header && !clock_)
    clock_ = create_subscription<rosgraph_msgs::msg::Clock>(
        ros2wasm_sim::hidden_name("/clock"), rclcpp::QoS(1).best_effort(),
        [this](const rosgraph_msgs::msg::Clock& message) { now_ = message.clock; });
  RelayOptions options;
  options.to_ros = to_ros;
  options.stamps_with_wall_time = get_parameter("override_timestamps_with_wall_time").as_bool();
  options.now = [this] { return now_; };
  relays_.push_back(std::make_unique<Relay>(*this, entry, *pair, std::move(options)));
}

void Bridge::add_service(const ServiceEntry& entry) {
  try {
    services_.push_back(relay_service(*this, entry));
    RCLCPP_INFO(get_logger(), "Creating ROS->GZ service bridge [%s (%s -> gz.msgs)]",
                entry.service.c_str(), entry.ros_type.c_str());
  } catch (const std::exception& fault) {
    std::cerr << fault.what() << std::endl;
  }
}

void Bridge::read_config_file() {
  const std::string path = get_parameter("config_file").as_string();
  if (path.empty()) return;
  const bool expands = get_parameter("expand_gz_topic_names").as_bool();
  const auto config = read_bridge_config_file(path);
  for (const std::string& fault : config.faults)
    RCLCPP_ERROR(rclcpp::get_logger("BridgeConfig"), "%s", fault.c_str());
  for (BridgeArgument one : config.entries) {
    auto* const entry = std::get_if<BridgeEntry>(&one);
    if (entry != nullptr && expands)
      entry->gz_topic =
          rclcpp::expand_topic_or_service_name(entry->gz_topic, get_name(), get_namespace(), false);
    add(one);
  }
}

void Bridge::beat() {
  if (!std::exchange(has_read_file_, true) && relays_.empty()) read_config_file();
  for (const auto& relay : relays_) relay->look();
  watch_.look(*this);
}

int run_bridge(int argc, char** argv, bool needs_arguments) {
  if (needs_arguments && argc < 2) {
    std::cout << bridge_usage() << std::endl;
    return -1;
  }
  auto words = rclcpp::init_and_remove_ros_arguments(argc, argv);
  if (!words.empty()) words.erase(words.begin());
  const auto node = std::make_shared<Bridge>();
  int exit_code = 0;
  for (const std::string& word : words) {
    const auto argument = read_bridge_argument(word);
    if (!argument) {
      std::cout << bridge_usage() << std::endl;
      exit_code = -1;
      break;
    }
    node->add(*argument);
  }
  if (exit_code == 0) rclcpp::spin(node);
  rclcpp::shutdown();
  return exit_code;
}

}  // namespace ros_gz_bridge
