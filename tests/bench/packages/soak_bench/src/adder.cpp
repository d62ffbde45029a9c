// The server that the caller calls.
#include "example_interfaces/srv/add_two_ints.hpp"
#include "rclcpp/rclcpp.hpp"

using Add = example_interfaces::srv::AddTwoInts;

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto node = std::make_shared<rclcpp::Node>("adder");
  auto service = node->create_service<Add>(
    "add", [](const Add::Request::SharedPtr request, Add::Response::SharedPtr response) {
      response->sum = request->a + request->b;
    });
  rclcpp::spin(node);
  rclcpp::shutdown();
  return 0;
}
