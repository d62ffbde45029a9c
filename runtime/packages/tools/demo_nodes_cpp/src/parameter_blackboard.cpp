// Keeps whatever parameters it is given, for other nodes to read.
#include <memory>
#include <rclcpp/rclcpp.hpp>

#include "rcl_interfaces/srv/list_parameters.hpp"

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  const auto node = std::make_shared<rclcpp::Node>(
      "parameter_blackboard", rclcpp::NodeOptions()
                                  .allow_undeclared_parameters(true)
                                  .automatically_declare_parameters_from_overrides(true));
  RCLCPP_INFO(
      node->get_logger(),
      "Parameter blackboard node named '%s' ready, and serving '%zu' parameters already!",
      node->get_fully_qualified_name(),
      node->list_parameters({}, rcl_interfaces::srv::ListParameters::Request::DEPTH_RECURSIVE)
          .names.size());
  rclcpp::spin(node);
  rclcpp::shutdown();
  return 0;
}
