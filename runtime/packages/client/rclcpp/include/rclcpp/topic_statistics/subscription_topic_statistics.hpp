// How old the messages of a subscription are and how far apart they come, published once a period.
#pragma once

#include <memory>
#include <mutex>
#include <string>

#include "rclcpp/publisher.hpp"
#include "rclcpp/time.hpp"
#include "rclcpp/timer.hpp"
#include "rmw/types.h"
#include "statistics_msgs/msg/metrics_message.hpp"

namespace rclcpp {
namespace topic_statistics {

constexpr char kDefaultPublishTopicName[]{"/statistics"};
constexpr std::chrono::milliseconds kDefaultPublishingPeriod{std::chrono::seconds(1)};

class SubscriptionTopicStatistics {
 public:
  using Publisher = rclcpp::Publisher<statistics_msgs::msg::MetricsMessage>;

  /// Throws std::invalid_argument without a publisher.
  SubscriptionTopicStatistics(const std::string& node_name, Publisher::SharedPtr publisher);
  virtual ~SubscriptionTopicStatistics();

  /// Counts a message that was received at `now_nanoseconds`.
  virtual void handle_message(const rmw_message_info_t& message_info,
                              rclcpp::Time now_nanoseconds) const;
  /// The timer lives as long as this.
  void set_publisher_timer(rclcpp::TimerBase::SharedPtr publisher_timer);
  virtual void publish_message_and_reset_measurements();

 private:
  /// Statistics of samples in milliseconds; not a number while there are no samples.
  struct Samples {
    uint64_t count = 0;
    double average = 0;
    double minimum = 0;
    double maximum = 0;
    double squares = 0;  ///< sum of the squares of the distances from the average
    void add(double sample);
  };
  statistics_msgs::msg::MetricsMessage message_of(const char* source, const Samples& samples,
                                                  const rclcpp::Time& window_stop) const;

  const std::string node_name_;
  const Publisher::SharedPtr publisher_;
  rclcpp::TimerBase::SharedPtr publisher_timer_;
  mutable std::mutex mutex_;
  mutable Samples ages_;
  mutable Samples periods_;
  mutable int64_t last_received_ns_ = 0;
  rclcpp::Time window_start_;
};

}  // namespace topic_statistics
}  // namespace rclcpp
