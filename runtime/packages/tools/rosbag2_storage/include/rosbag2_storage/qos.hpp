// The QoS that bags keep of publishers: as text, and what to ask for and to offer because of it.
#pragma once

#include <string>
#include <vector>

#include "rclcpp/node_interfaces/node_graph_interface.hpp"
#include "rclcpp/qos.hpp"
#include "rosbag2_storage/visibility_control.hpp"

namespace rosbag2_storage {

class Rosbag2QoS : public rclcpp::QoS {
 public:
  Rosbag2QoS() : rclcpp::QoS(rmw_qos_profile_default.depth) {}
  explicit Rosbag2QoS(const rclcpp::QoS& value) : rclcpp::QoS(value) {}

  Rosbag2QoS& default_history() {
    keep_last(rmw_qos_profile_default.depth);
    return *this;
  }
  /// The QoS with which a subscription receives the messages of all publishers.
  static Rosbag2QoS adapt_request_to_offers(
      const std::string& topic_name, const std::vector<rclcpp::TopicEndpointInfo>& endpoints);
  /// The QoS of a publisher that replays the messages of all recorded publishers.
  static Rosbag2QoS adapt_offer_to_recorded_offers(const std::string& topic_name,
                                                   const std::vector<Rosbag2QoS>& profiles);
};

std::vector<Rosbag2QoS> from_rclcpp_qos_vector(const std::vector<rclcpp::QoS>& in);
/// Returns YAML. Versions before 9 have numbers for policies.
std::string serialize_rclcpp_qos_vector(const std::vector<rclcpp::QoS>& in, int version = 9);
/// Throws std::runtime_error for other texts.
std::vector<rclcpp::QoS> to_rclcpp_qos_vector(const std::string& serialized, int version);

}  // namespace rosbag2_storage
