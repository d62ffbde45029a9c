// Asks for 2 + 3, and waits for the answer.
#include "services.hpp"

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  const auto node = rclcpp::Node::make_shared("add_two_ints_client");
  const auto client = node->create_client<demo_nodes_cpp::AddTwoInts>("add_two_ints");
  if (!demo_nodes_cpp::wait_for(*client, node->get_logger())) return 0;
  auto answer = client->async_send_request(demo_nodes_cpp::two_and_three());
  if (rclcpp::spin_until_future_complete(node, answer) == rclcpp::FutureReturnCode::SUCCESS) {
    RCLCPP_INFO(node->get_logger(), "Result of add_two_ints: %" PRId64, answer.get()->sum);
  } else {
    RCLCPP_ERROR(node->get_logger(), "Interrupted while waiting for response. Exiting.");
  }
  rclcpp::shutdown();
  return 0;
}
