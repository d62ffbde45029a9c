// Publishes images. Copies share one publisher.
#pragma once

#include <memory>
#include <string>

#include "rclcpp/node.hpp"
#include "rclcpp/publisher.hpp"
#include "sensor_msgs/msg/image.hpp"

namespace image_transport {

class Publisher {
 public:
  Publisher() = default;
  Publisher(rclcpp::Node* node, const std::string& base_topic, rmw_qos_profile_t custom_qos,
            rclcpp::PublisherOptions options = rclcpp::PublisherOptions());

  size_t getNumSubscribers() const;
  /// With its namespace and remapped; empty for a Publisher of nothing.
  std::string getTopic() const;

  void publish(const sensor_msgs::msg::Image& message) const;
  void publish(const sensor_msgs::msg::Image::ConstSharedPtr& message) const;
  void publish(sensor_msgs::msg::Image::UniquePtr message) const;

  /// For all copies.
  void shutdown();

  operator void*() const;
  bool operator<(const Publisher& other) const { return shared_ < other.shared_; }
  bool operator!=(const Publisher& other) const { return shared_ != other.shared_; }
  bool operator==(const Publisher& other) const { return shared_ == other.shared_; }

 private:
  using ImagePublisher = rclcpp::Publisher<sensor_msgs::msg::Image>;

  /// The publisher inside; null, and a message in the log, if there is none.
  ImagePublisher* opened() const;

  std::shared_ptr<ImagePublisher::SharedPtr> shared_;
};

}  // namespace image_transport
