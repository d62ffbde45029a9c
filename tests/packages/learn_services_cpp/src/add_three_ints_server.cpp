#include <memory>

#include "learn_interfaces/srv/add_three_ints.hpp"
#include "rclcpp/rclcpp.hpp"

void add(
  const std::shared_ptr<learn_interfaces::srv::AddThreeInts::Request> request,
  std::shared_ptr<learn_interfaces::srv::AddThreeInts::Response> response)
{
  response->sum = request->a + request->b + request->c;
  RCLCPP_INFO(
    rclcpp::get_logger("rclcpp"), "Incoming request a: %ld b: %ld c: %ld", static_cast<long>(request->a),
    static_cast<long>(request->b), static_cast<long>(request->c));
}

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  std::shared_ptr<rclcpp::Node> node = rclcpp::Node::make_shared("add_three_ints_server");
  rclcpp::Service<learn_interfaces::srv::AddThreeInts>::SharedPtr service =
    node->create_service<learn_interfaces::srv::AddThreeInts>("add_three_ints", &add);
  RCLCPP_INFO(rclcpp::get_logger("rclcpp"), "Ready to add three ints.");
  rclcpp::spin(node);
  rclcpp::shutdown();
}
