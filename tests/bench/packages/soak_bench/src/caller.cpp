// Calls the adder `hz` times a second. Every `report_s` seconds two JSON lines; a wrong sum does not count as come.
#include <chrono>

#include "example_interfaces/srv/add_two_ints.hpp"
#include "latencies.hpp"
#include "rclcpp/rclcpp.hpp"

using Add = example_interfaces::srv::AddTwoInts;

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto node = std::make_shared<rclcpp::Node>("caller");
  const auto hz = node->declare_parameter("hz", 20);
  const auto report_s = node->declare_parameter("report_s", 60);
  auto client = node->create_client<Add>("add");
  client->wait_for_service();
  Latencies latencies;
  std::int64_t number = 0;
  auto calls = node->create_wall_timer(std::chrono::nanoseconds(1'000'000'000 / hz), [&] {
    auto request = std::make_shared<Add::Request>();
    request->a = ++number;
    request->b = 1;
    const std::int64_t time = now_ns();
    ++latencies.sent;
    client->async_send_request(request, [&latencies, time, sum = number + 1](rclcpp::Client<Add>::SharedFuture future) {
      if (future.get()->sum == sum) {latencies.add(time);}
    });
  });
  auto reports = node->create_wall_timer(std::chrono::seconds(report_s), [&] {
    report_published("calls", latencies.sent);
    latencies.report("calls");
  });
  rclcpp::spin(node);
  rclcpp::shutdown();
  return 0;
}
