// See costmap_filter_info_server.hpp.
#include "nav2_map_server/costmap_filter_info_server.hpp"

#include "rclcpp_components/register_node_macro.hpp"

namespace nav2_map_server {

using nav2_util::CallbackReturn;

CostmapFilterInfoServer::CostmapFilterInfoServer(const rclcpp::NodeOptions& options)
    : nav2_util::LifecycleNode("costmap_filter_info_server", "", options) {
  declare_parameter("filter_info_topic", "costmap_filter_info");
  declare_parameter("type", 0);
  declare_parameter("mask_topic", "filter_mask");
  declare_parameter("base", 0.0);
  declare_parameter("multiplier", 1.0);
}

CostmapFilterInfoServer::~CostmapFilterInfoServer() = default;

CallbackReturn CostmapFilterInfoServer::on_configure(const rclcpp_lifecycle::State&) {
  RCLCPP_INFO(get_logger(), "Configuring");
  publisher_ = create_publisher<nav2_msgs::msg::CostmapFilterInfo>(
      get_parameter("filter_info_topic").as_string(),
      rclcpp::QoS(rclcpp::KeepLast(1)).transient_local().reliable());
  msg_ = nav2_msgs::msg::CostmapFilterInfo();
  msg_.header.stamp = now();
  msg_.type = static_cast<uint8_t>(get_parameter("type").as_int());
  msg_.filter_mask_topic = get_parameter("mask_topic").as_string();
  msg_.base = static_cast<float>(get_parameter("base").as_double());
  msg_.multiplier = static_cast<float>(get_parameter("multiplier").as_double());
  return CallbackReturn::SUCCESS;
}

CallbackReturn CostmapFilterInfoServer::on_activate(const rclcpp_lifecycle::State&) {
  RCLCPP_INFO(get_logger(), "Activating");
  publisher_->on_activate();
  publisher_->publish(msg_);
  createBond();
  return CallbackReturn::SUCCESS;
}

CallbackReturn CostmapFilterInfoServer::on_deactivate(const rclcpp_lifecycle::State&) {
  RCLCPP_INFO(get_logger(), "Deactivating");
  publisher_->on_deactivate();
  destroyBond();
  return CallbackReturn::SUCCESS;
}

CallbackReturn CostmapFilterInfoServer::on_cleanup(const rclcpp_lifecycle::State&) {
  RCLCPP_INFO(get_logger(), "Cleaning up");
  publisher_.reset();
  return CallbackReturn::SUCCESS;
}

CallbackReturn CostmapFilterInfoServer::on_shutdown(const rclcpp_lifecycle::State&) {
  RCLCPP_INFO(get_logger(), "Shutting down");
  return CallbackReturn::SUCCESS;
}

}  // namespace nav2_map_server

RCLCPP_COMPONENTS_REGISTER_NODE(nav2_map_server::CostmapFilterInfoServer)
