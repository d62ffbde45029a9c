// See subscription_topic_statistics.hpp.
#include "rclcpp/detail/topic_statistics.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "rclcpp/create_timer.hpp"
#include "rclcpp/topic_statistics/subscription_topic_statistics.hpp"
#include "ros2wasm/endpoint.hpp"
#include "statistics_msgs/msg/statistic_data_type.hpp"

namespace rclcpp {
namespace topic_statistics {
namespace {

using statistics_msgs::msg::MetricsMessage;
using Kind = statistics_msgs::msg::StatisticDataType;

double milliseconds(int64_t duration_ns) {
  return static_cast<double>(duration_ns) / 1e6;
}

rclcpp::Time now() {
  return rclcpp::Time(ros2wasm::system_now_ns());
}

}  // namespace

void SubscriptionTopicStatistics::Samples::add(double sample) {
  minimum = count == 0 ? sample : std::min(minimum, sample);
  maximum = count == 0 ? sample : std::max(maximum, sample);
  ++count;
  const double distance = sample - average;
  average += distance / static_cast<double>(count);
  squares += distance * (sample - average);
}

SubscriptionTopicStatistics::SubscriptionTopicStatistics(const std::string& node_name,
                                                         Publisher::SharedPtr publisher)
    : node_name_(node_name), publisher_(std::move(publisher)), window_start_(now()) {
  if (publisher_ == nullptr) {
    throw std::invalid_argument("publisher pointer is nullptr");
  }
}

SubscriptionTopicStatistics::~SubscriptionTopicStatistics() {
  if (publisher_timer_ != nullptr) {
    publisher_timer_->cancel();
  }
}

void SubscriptionTopicStatistics::handle_message(const rmw_message_info_t& message_info,
                                                 rclcpp::Time now_nanoseconds) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  const int64_t received_ns = now_nanoseconds.nanoseconds();
  if (message_info.source_timestamp != 0) {
    ages_.add(milliseconds(received_ns - message_info.source_timestamp));
  }
  if (last_received_ns_ != 0) {
    periods_.add(milliseconds(received_ns - last_received_ns_));
  }
  last_received_ns_ = received_ns;
}

void SubscriptionTopicStatistics::set_publisher_timer(
    rclcpp::TimerBase::SharedPtr publisher_timer) {
  publisher_timer_ = std::move(publisher_timer);
}

MetricsMessage SubscriptionTopicStatistics::message_of(const char* source, const Samples& samples,
                                                       const rclcpp::Time& window_stop) const {
  MetricsMessage message;
  message.measurement_source_name = node_name_;
  message.metrics_source = source;
  message.unit = "ms";
  message.window_start = window_start_;
  message.window_stop = window_stop;
  const auto add = [&message](uint8_t kind, double data) {
    auto& point = message.statistics.emplace_back();
    point.data_type = kind;
    point.data = data;
  };
  const auto count = static_cast<double>(samples.count);
  const auto known = [&samples](double value) {
    return samples.count == 0 ? std::numeric_limits<double>::quiet_NaN() : value;
  };
  add(Kind::STATISTICS_DATA_TYPE_AVERAGE, known(samples.average));
  add(Kind::STATISTICS_DATA_TYPE_MINIMUM, known(samples.minimum));
  add(Kind::STATISTICS_DATA_TYPE_MAXIMUM, known(samples.maximum));
  add(Kind::STATISTICS_DATA_TYPE_STDDEV, known(std::sqrt(samples.squares / std::max(1.0, count))));
  add(Kind::STATISTICS_DATA_TYPE_SAMPLE_COUNT, count);
  return message;
}

void SubscriptionTopicStatistics::publish_message_and_reset_measurements() {
  MetricsMessage age;
  MetricsMessage period;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    const rclcpp::Time window_stop = now();
    age = message_of("message_age", ages_, window_stop);
    period = message_of("message_period", periods_, window_stop);
    ages_ = {};
    periods_ = {};
    window_start_ = window_stop;
  }
  publisher_->publish(age);
  publisher_->publish(period);
}

}  // namespace topic_statistics

namespace detail {

void add_topic_statistics(SubscriptionBase& subscription, const SubscriptionOptionsBase& options,
                          node_interfaces::NodeTopicsInterface& topics) {
  using topic_statistics::SubscriptionTopicStatistics;
  node_interfaces::NodeBaseInterface* node = topics.get_node_base_interface();
  const auto& asked = options.topic_stats_options;
  const bool wanted = asked.state == TopicStatisticsState::NodeDefault
                          ? node->get_enable_topic_statistics_default()
                          : asked.state == TopicStatisticsState::Enable;
  if (!wanted) {
    return;
  }
  if (asked.publish_period <= std::chrono::milliseconds(0)) {
    throw std::invalid_argument(
        "topic_stats_options.publish_period must be greater than 0, specified value of " +
        std::to_string(asked.publish_period.count()) + " ms");
  }
  const auto publisher = std::make_shared<SubscriptionTopicStatistics::Publisher>(
      node, asked.publish_topic, asked.qos, PublisherOptions());
  topics.add_publisher(publisher, options.callback_group);
  const auto statistics =
      std::make_shared<SubscriptionTopicStatistics>(node->get_name(), publisher);
  const std::weak_ptr<SubscriptionTopicStatistics> weak = statistics;
  statistics->set_publisher_timer(create_wall_timer(
      std::chrono::duration_cast<std::chrono::nanoseconds>(asked.publish_period),
      [weak] {
        if (const auto alive = weak.lock()) {
          alive->publish_message_and_reset_measurements();
        }
      },
      options.callback_group, node, topics.get_node_timers_interface()));
  subscription.set_topic_statistics(statistics);
}

}  // namespace detail
}  // namespace rclcpp
