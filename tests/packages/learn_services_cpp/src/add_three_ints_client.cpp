#include <chrono>
#include <cstdlib>
#include <memory>

#include "learn_interfaces/srv/add_three_ints.hpp"
#include "rclcpp/rclcpp.hpp"

using namespace std::chrono_literals;
using learn_interfaces::srv::AddThreeInts;

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  if (argc != 4) {
    RCLCPP_INFO(rclcpp::get_logger("rclcpp"), "usage: add_three_ints_client X Y Z");
    return 1;
  }
  std::shared_ptr<rclcpp::Node> node = rclcpp::Node::make_shared("add_three_ints_client");
  rclcpp::Client<AddThreeInts>::SharedPtr client = node->create_client<AddThreeInts>("add_three_ints");
  auto request = std::make_shared<AddThreeInts::Request>();
  request->a = atoll(argv[1]);
  request->b = atoll(argv[2]);
  request->c = atoll(argv[3]);
  while (!client->wait_for_service(1s)) {
    if (!rclcpp::ok()) {
      RCLCPP_ERROR(rclcpp::get_logger("rclcpp"), "Interrupted while waiting for the service. Exiting.");
      return 1;
    }
    RCLCPP_INFO(rclcpp::get_logger("rclcpp"), "service not available, waiting again...");
  }
  auto result = client->async_send_request(request);
  if (rclcpp::spin_until_future_complete(node, result) == rclcpp::FutureReturnCode::SUCCESS) {
    RCLCPP_INFO(rclcpp::get_logger("rclcpp"), "Sum: %ld", static_cast<long>(result.get()->sum));
  } else {
    RCLCPP_ERROR(rclcpp::get_logger("rclcpp"), "Failed to call service add_three_ints");
  }

  bool answered = false;
  client->async_send_request(request, [&answered](rclcpp::Client<AddThreeInts>::SharedFuture future) {
      RCLCPP_INFO(rclcpp::get_logger("rclcpp"), "Again: %ld", static_cast<long>(future.get()->sum));
      answered = true;
    });
  while (rclcpp::ok() && !answered) {
    rclcpp::spin_some(node);
  }
  rclcpp::shutdown();
  return 0;
}
