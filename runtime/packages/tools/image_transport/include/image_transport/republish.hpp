// The component behind `ros2 run image_transport republish`: from topic `in` to topic `out`.
#pragma once

#include "image_transport/image_transport.hpp"
#include "rclcpp/rclcpp.hpp"

namespace image_transport {

class Republisher : public rclcpp::Node {
 public:
  explicit Republisher(const rclcpp::NodeOptions& options);

 private:
  /// Listens only while somebody listens to it.
  void follow_demand();

  std::string in_transport_;
  rclcpp::SubscriptionOptions subscription_options_;
  Subscriber subscriber_;
  Publisher publisher_;
};

}  // namespace image_transport
