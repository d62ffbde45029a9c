#include <chrono>
#include <iostream>
#include <memory>

#include "rclcpp/rclcpp.hpp"

using namespace std::chrono_literals;

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto node = rclcpp::Node::make_shared("setter");
  auto client = std::make_shared<rclcpp::SyncParametersClient>(node, "minimal_param_node");
  while (!client->wait_for_service(1s)) {
    if (!rclcpp::ok()) {
      return 1;
    }
  }
  while (client->get_parameter<std::string>("my_parameter") != "moon") {
    rclcpp::sleep_for(50ms);
  }
  for (auto & result : client->set_parameters({rclcpp::Parameter("my_parameter", "sun")})) {
    std::cout << "set: " << (result.successful ? "yes" : "no") << std::endl;
  }
  std::cout << "value: " << client->get_parameter<std::string>("my_parameter") << std::endl;
  std::cout << "has: " << client->has_parameter("gains") << client->has_parameter("colour") << std::endl;
  for (auto & descriptor : client->describe_parameters({"my_parameter"})) {
    std::cout << "described: " << descriptor.description << std::endl;
  }
  rclcpp::shutdown();
  return 0;
}
