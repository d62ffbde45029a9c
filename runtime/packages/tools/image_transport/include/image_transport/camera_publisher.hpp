// Publishes images, each with what is known of the camera.
#pragma once

#include <memory>
#include <string>

#include "image_transport/publisher.hpp"
#include "rclcpp/node.hpp"
#include "rclcpp/time.hpp"
#include "sensor_msgs/msg/camera_info.hpp"
#include "sensor_msgs/msg/image.hpp"

namespace image_transport {

class CameraPublisher {
 public:
  CameraPublisher() = default;
  CameraPublisher(rclcpp::Node* node, const std::string& base_topic,
                  rmw_qos_profile_t custom_qos = rmw_qos_profile_default,
                  rclcpp::PublisherOptions options = rclcpp::PublisherOptions());

  /// The greater of both topics' numbers.
  size_t getNumSubscribers() const;
  std::string getTopic() const;
  std::string getInfoTopic() const;

  void publish(const sensor_msgs::msg::Image& image,
               const sensor_msgs::msg::CameraInfo& info) const;
  void publish(const sensor_msgs::msg::Image::ConstSharedPtr& image,
               const sensor_msgs::msg::CameraInfo::ConstSharedPtr& info) const;
  void publish(sensor_msgs::msg::Image::UniquePtr image,
               sensor_msgs::msg::CameraInfo::UniquePtr info) const;
  /// Stamps both.
  void publish(sensor_msgs::msg::Image& image, sensor_msgs::msg::CameraInfo& info,
               rclcpp::Time stamp) const;

  void shutdown();

  operator void*() const { return image_; }
  bool operator<(const CameraPublisher& other) const { return image_ < other.image_; }
  bool operator!=(const CameraPublisher& other) const { return image_ != other.image_; }
  bool operator==(const CameraPublisher& other) const { return image_ == other.image_; }

 private:
  using InfoPublisher = rclcpp::Publisher<sensor_msgs::msg::CameraInfo>;

  Publisher image_;
  std::shared_ptr<InfoPublisher::SharedPtr> info_;
};

}  // namespace image_transport
