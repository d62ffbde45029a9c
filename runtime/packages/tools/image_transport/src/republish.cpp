// A component.
#include "image_transport/republish.hpp"

#include <string>

#include "rclcpp_components/register_node_macro.hpp"

namespace image_transport {

Republisher::Republisher(const rclcpp::NodeOptions& options) : Node("image_republisher", options) {
  in_transport_ = declare_parameter<std::string>("in_transport", "raw");
  RCLCPP_INFO(get_logger(), "The 'in_transport' parameter is set to: %s", in_transport_.c_str());
  const auto out_transport = declare_parameter<std::string>("out_transport", "");
  RCLCPP_INFO(get_logger(), "The 'out_transport' parameter is set to: %s", out_transport.c_str());
  if (!out_transport.empty() && out_transport != "raw") {
    throw TransportLoadException(out_transport, "a site has the transport raw only");
  }
  const rclcpp::QosOverridingOptions overrides{
      rclcpp::QosPolicyKind::Depth, rclcpp::QosPolicyKind::Durability,
      rclcpp::QosPolicyKind::History, rclcpp::QosPolicyKind::Reliability};
  subscription_options_.qos_overriding_options = overrides;
  rclcpp::PublisherOptions publisher_options;
  publisher_options.qos_overriding_options = overrides;
  publisher_options.event_callbacks.matched_callback = [this](rclcpp::MatchedInfo&) {
    follow_demand();
  };
  publisher_ =
      image_transport::create_publisher(this, "out", rmw_qos_profile_default, publisher_options);
}

void Republisher::follow_demand() {
  if (publisher_.getNumSubscribers() == 0) {
    subscriber_.shutdown();
  } else if (!subscriber_) {
    subscriber_ = image_transport::create_subscription(
        this, "in",
        [this](const sensor_msgs::msg::Image::ConstSharedPtr& image) { publisher_.publish(image); },
        in_transport_, rmw_qos_profile_default, subscription_options_);
  }
}

}  // namespace image_transport

RCLCPP_COMPONENTS_REGISTER_NODE(image_transport::Republisher)
