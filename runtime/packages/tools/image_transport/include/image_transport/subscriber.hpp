// Subscribes to images. Copies share one subscription.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "rclcpp/node.hpp"
#include "rclcpp/subscription.hpp"
#include "sensor_msgs/msg/image.hpp"

namespace image_transport {

class Subscriber {
 public:
  using Callback = std::function<void(const sensor_msgs::msg::Image::ConstSharedPtr&)>;

  Subscriber() = default;
  /// Throws TransportLoadException for a transport other than raw.
  Subscriber(rclcpp::Node* node, const std::string& base_topic, const Callback& callback,
             const std::string& transport, rmw_qos_profile_t custom_qos = rmw_qos_profile_default,
             rclcpp::SubscriptionOptions options = rclcpp::SubscriptionOptions());

  /// With its namespace and remapped; empty for a Subscriber to nothing.
  std::string getTopic() const;
  size_t getNumPublishers() const;
  std::string getTransport() const;

  /// For all copies.
  void shutdown();

  operator void*() const;
  bool operator<(const Subscriber& other) const { return shared_ < other.shared_; }
  bool operator!=(const Subscriber& other) const { return shared_ != other.shared_; }
  bool operator==(const Subscriber& other) const { return shared_ == other.shared_; }

 private:
  using ImageSubscription = rclcpp::Subscription<sensor_msgs::msg::Image>;

  std::shared_ptr<ImageSubscription::SharedPtr> shared_;
};

}  // namespace image_transport
