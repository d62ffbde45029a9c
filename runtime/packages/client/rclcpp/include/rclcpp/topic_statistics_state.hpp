// Whether a subscription publishes statistics about what it receives.
#pragma once

namespace rclcpp {

enum class TopicStatisticsState { Enable, Disable, NodeDefault };

}  // namespace rclcpp
