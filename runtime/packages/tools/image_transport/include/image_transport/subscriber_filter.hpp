// A subscription to images as a filter.
#pragma once

#include <string>
#include <utility>

#include "image_transport/image_transport.hpp"
#include "message_filters/simple_filter.h"
#include "rclcpp/rclcpp.hpp"
#include "sensor_msgs/msg/image.hpp"

namespace image_transport {

class SubscriberFilter : public message_filters::SimpleFilter<sensor_msgs::msg::Image> {
 public:
  SubscriberFilter() = default;
  SubscriberFilter(rclcpp::Node* node, const std::string& base_topic,
                   const std::string& transport) {
    subscribe(node, base_topic, transport);
  }
  ~SubscriberFilter() { unsubscribe(); }

  /// Ends an earlier subscription first.
  void subscribe(rclcpp::Node* node, const std::string& base_topic, const std::string& transport,
                 rmw_qos_profile_t custom_qos = rmw_qos_profile_default,
                 rclcpp::SubscriptionOptions options = rclcpp::SubscriptionOptions()) {
    unsubscribe();
    subscriber_ = create_subscription(
        node, base_topic,
        [this](const sensor_msgs::msg::Image::ConstSharedPtr& image) { signalMessage(image); },
        transport, custom_qos, std::move(options));
  }
  void unsubscribe() { subscriber_.shutdown(); }

  std::string getTopic() const { return subscriber_.getTopic(); }
  size_t getNumPublishers() const { return subscriber_.getNumPublishers(); }
  std::string getTransport() const { return subscriber_.getTransport(); }
  const Subscriber& getSubscriber() const { return subscriber_; }

 private:
  Subscriber subscriber_;
};

}  // namespace image_transport
