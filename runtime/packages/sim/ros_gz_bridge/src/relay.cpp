// See relay.hpp.
#include "relay.hpp"

#include <chrono>
#include <cstring>
#include <set>
#include <stdexcept>
#include <utility>

#include "ros2wasm_sim/gz_names.hpp"

namespace ros_gz_bridge {
namespace {

/// Bytes of CDR before the message; the numbers behind are little-endian.
constexpr std::size_t kCdrHeader = 4;
/// A simulator may offer sensors as best effort; this fits every offer.
const rclcpp::QoS kOfGazebo = rclcpp::QoS(10).best_effort();

void set_wall_time(Bytes& message) {
  const auto since_epoch = std::chrono::system_clock::now().time_since_epoch();
  const auto ns = std::chrono::duration_cast<std::chrono::nanoseconds>(since_epoch).count();
  const std::int32_t seconds = static_cast<std::int32_t>(ns / 1'000'000'000);
  const std::uint32_t rest = static_cast<std::uint32_t>(ns % 1'000'000'000);
  auto& raw = message.get_rcl_serialized_message();
  if (raw.buffer_length < kCdrHeader + sizeof(seconds) + sizeof(rest)) return;
  std::memcpy(raw.buffer + kCdrHeader, &seconds, sizeof(seconds));
  std::memcpy(raw.buffer + kCdrHeader + sizeof(seconds), &rest, sizeof(rest));
}

template <typename Options>
Options with_overrides(Options options = {}) {
  options.qos_overriding_options = rclcpp::QosOverridingOptions::with_default_policies();
  return options;
}

}  // namespace

Relay::Relay(rclcpp::Node& node, const BridgeEntry& entry, const TypePair& pair,
             RelayOptions options)
    : node_(node), entry_(entry), pair_(pair), options_(std::move(options)) {
  publisher_ =
      options_.to_ros
          ? node_.create_generic_publisher(entry_.ros_topic, pair_.ros_type,
                                           rclcpp::QoS(entry_.publisher_queue),
                                           with_overrides<rclcpp::PublisherOptions>())
          : node_.create_generic_publisher(ros2wasm_sim::hidden_name(entry_.gz_topic),
                                           pair_.hidden_type, rclcpp::QoS(entry_.publisher_queue));
  if (!entry_.is_lazy) listen();
}

void Relay::look() {
  if (!entry_.is_lazy) return;
  const bool is_wanted = publisher_->get_subscription_count() > 0;
  if (is_wanted && !subscription_) listen();
  if (!is_wanted) subscription_.reset();
}

void Relay::listen() {
  // A bridge both ways does not hear itself.
  rclcpp::SubscriptionOptions options;
  options.ignore_local_publications = true;
  const auto callback = [this](std::shared_ptr<Bytes> bytes) { carry(bytes); };
  subscription_ =
      options_.to_ros
          ? node_.create_generic_subscription(ros2wasm_sim::hidden_name(entry_.gz_topic),
                                              pair_.hidden_type, kOfGazebo, callback, options)
          : node_.create_generic_subscription(entry_.ros_topic, pair_.ros_type,
                                              rclcpp::QoS(entry_.subscriber_queue), callback,
                                              with_overrides(options));
}

void Relay::carry(const std::shared_ptr<Bytes>& bytes) {
  if (!options_.to_ros && !std::exchange(has_reported_, true)) {
    static std::set<std::pair<std::string, std::string>> reported;
    if (reported.emplace(entry_.ros_type, entry_.gz_type).second)
      RCLCPP_INFO(node_.get_logger(),
                  "Passing message from ROS %s to Gazebo %s (showing msg only once per type)",
                  entry_.ros_type.c_str(), entry_.gz_type.c_str());
  }
  const bool sets_stamp =
      options_.to_ros && options_.stamps_with_wall_time && pair_.begins_with_header;
  if (pair_.conversion == nullptr && !sets_stamp) {
    publisher_->publish(*bytes);
    return;
  }
  try {
    Bytes message = *bytes;
    if (pair_.conversion != nullptr)
      message = (options_.to_ros ? pair_.conversion->to_ros : pair_.conversion->to_gz)(
          message, options_.now());
    if (sets_stamp) set_wall_time(message);
    publisher_->publish(message);
  } catch (const std::exception& fault) {
    RCLCPP_ERROR(node_.get_logger(), "Failed to convert a message of topic [%s]: %s",
                 entry_.ros_topic.c_str(), fault.what());
  }
}

}  // namespace ros_gz_bridge
