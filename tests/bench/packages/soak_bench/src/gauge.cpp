// Takes what the pulses on `topics` publish. Every `report_s` seconds one JSON line per topic.
#include <chrono>
#include <cstring>
#include <map>
#include <string>
#include <vector>

#include "latencies.hpp"
#include "rclcpp/rclcpp.hpp"
#include "std_msgs/msg/u_int8_multi_array.hpp"

using Bytes = std_msgs::msg::UInt8MultiArray;

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto node = std::make_shared<rclcpp::Node>("gauge");
  const auto topics = node->declare_parameter("topics", std::vector<std::string>{});
  const auto report_s = node->declare_parameter("report_s", 60);
  std::map<std::string, Latencies> latencies;
  std::map<std::string, std::uint64_t> newest;
  std::vector<rclcpp::SubscriptionBase::SharedPtr> subscriptions;
  for (const auto & topic : topics) {
    auto take = [&of = latencies[topic], &last = newest[topic]](const Bytes & message) {
      std::int64_t time = 0;
      std::uint64_t number = 0;
      std::memcpy(&time, message.data.data(), sizeof time);
      std::memcpy(&number, message.data.data() + sizeof time, sizeof number);
      of.add(time);
      of.sent += last == 0 ? 1 : number - last;
      last = number;
    };
    subscriptions.push_back(node->create_subscription<Bytes>(topic, 50, take));
  }
  auto timer = node->create_wall_timer(std::chrono::seconds(report_s), [&] {
    for (auto & [topic, of] : latencies) {of.report(topic.c_str());}
  });
  rclcpp::spin(node);
  rclcpp::shutdown();
  return 0;
}
