// Topic statistics: what a subscription publishes about the messages that it receives.

// Compatibility, works: topic statistics of subscriptions: age and period of messages, asked for
// by options or by the node

#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "checks.hpp"
#include "rclcpp/topic_statistics/subscription_topic_statistics.hpp"
#include "statistics_msgs/msg/metrics_message.hpp"
#include "std_msgs/msg/string.hpp"

using rclcpp::topic_statistics::SubscriptionTopicStatistics;
using statistics_msgs::msg::MetricsMessage;
using std_msgs::msg::String;
using namespace std::chrono_literals;

namespace {

std::vector<double> data_of(const MetricsMessage& message) {
  std::vector<double> data;
  for (const auto& point : message.statistics) {
    data.push_back(point.data);
  }
  return data;
}

// Three messages, 10 ms and 30 ms apart, each 5 ms old.
void check_figures(Checks& checks) {
  auto node = std::make_shared<rclcpp::Node>("figures");
  std::vector<MetricsMessage> heard;
  auto subscription = node->create_subscription<MetricsMessage>(
      "figures", 10, [&](const MetricsMessage& message) { heard.push_back(message); });
  auto publisher = node->create_publisher<MetricsMessage>("figures", 10);
  SubscriptionTopicStatistics statistics("meter", publisher);
  constexpr int64_t kMs = 1000000;
  for (const int64_t at : {100, 110, 140}) {
    rmw_message_info_t info{};
    info.source_timestamp = (at - 5) * kMs;
    statistics.handle_message(info, rclcpp::Time(at * kMs));
  }
  statistics.publish_message_and_reset_measurements();
  statistics.publish_message_and_reset_measurements();
  rclcpp::executors::SingleThreadedExecutor executor;
  executor.add_node(node);
  while (heard.size() < 4 && rclcpp::ok()) {
    executor.spin_some(10ms);
  }
  CHECK(heard[0].measurement_source_name == "meter");
  CHECK(heard[0].metrics_source == "message_age");
  CHECK(heard[0].unit == "ms");
  CHECK((data_of(heard[0]) == std::vector<double>{5, 5, 5, 0, 3}));
  CHECK(heard[1].metrics_source == "message_period");
  CHECK((data_of(heard[1]) == std::vector<double>{20, 10, 30, 10, 2}));
  CHECK(heard[2].window_start == heard[0].window_stop);
  CHECK(std::isnan(data_of(heard[2])[0]) && data_of(heard[2])[4] == 0);
  CHECK_THROWS(std::invalid_argument, SubscriptionTopicStatistics("meter", nullptr));
}

void check_subscription(Checks& checks) {
  auto node = std::make_shared<rclcpp::Node>("statistics_node",
                                             rclcpp::NodeOptions().enable_topic_statistics(true));
  double ages = 0;
  double periods = 0;
  rclcpp::SubscriptionOptions off;
  off.topic_stats_options.state = rclcpp::TopicStatisticsState::Disable;
  auto listener = node->create_subscription<MetricsMessage>(
      "about_counted", 10,
      [&](const MetricsMessage& message) {
        (message.metrics_source == "message_age" ? ages : periods) += message.statistics[4].data;
      },
      off);
  rclcpp::SubscriptionOptions options;
  options.topic_stats_options.publish_topic = "about_counted";
  options.topic_stats_options.publish_period = 20ms;
  auto counted = node->create_subscription<String>(
      "counted", 10, [](const String&) {}, options);
  CHECK(node->count_publishers("about_counted") == 1);
  auto publisher = node->create_publisher<String>("counted", 10);
  rclcpp::executors::SingleThreadedExecutor executor;
  executor.add_node(node);
  constexpr int kMessages = 5;
  for (int i = 0; i < kMessages; ++i) {
    publisher->publish(String());
  }
  while ((ages < kMessages || periods < kMessages - 1) && rclcpp::ok()) {
    executor.spin_some(10ms);
  }
  CHECK(ages == kMessages);
  CHECK(periods == kMessages - 1);
  options.topic_stats_options.publish_period = 0ms;
  CHECK_THROWS(std::invalid_argument, node->create_subscription<String>(
                                          "counted", 10, [](const String&) {}, options));
  counted.reset();
  CHECK(node->count_publishers("about_counted") == 0);
}

}  // namespace

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  Checks checks("statistics");
  check_figures(checks);
  check_subscription(checks);
  return checks.finish();
}
