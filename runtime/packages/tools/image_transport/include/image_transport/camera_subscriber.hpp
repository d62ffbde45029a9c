// Subscribes to images, each with what is known of the camera at the same time.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "image_transport/subscriber.hpp"
#include "rclcpp/node.hpp"
#include "sensor_msgs/msg/camera_info.hpp"
#include "sensor_msgs/msg/image.hpp"

namespace image_transport {

class CameraSubscriber {
 public:
  using Callback = std::function<void(const sensor_msgs::msg::Image::ConstSharedPtr&,
                                      const sensor_msgs::msg::CameraInfo::ConstSharedPtr&)>;

  CameraSubscriber() = default;
  CameraSubscriber(rclcpp::Node* node, const std::string& base_topic, const Callback& callback,
                   const std::string& transport,
                   rmw_qos_profile_t custom_qos = rmw_qos_profile_default);

  std::string getTopic() const;
  std::string getInfoTopic() const;
  /// The greater of both topics' numbers.
  size_t getNumPublishers() const;
  std::string getTransport() const;

  void shutdown();

  operator void*() const;
  bool operator<(const CameraSubscriber& other) const { return impl_ < other.impl_; }
  bool operator!=(const CameraSubscriber& other) const { return impl_ != other.impl_; }
  bool operator==(const CameraSubscriber& other) const { return impl_ == other.impl_; }

 private:
  struct Impl;
  std::shared_ptr<Impl> impl_;
};

}  // namespace image_transport
