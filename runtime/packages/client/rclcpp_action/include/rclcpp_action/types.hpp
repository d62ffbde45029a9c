// The id of a goal, and its states.
#pragma once

#include <array>
#include <climits>
#include <cstdint>
#include <functional>
#include <string>

#include "action_msgs/msg/goal_info.hpp"
#include "action_msgs/msg/goal_status.hpp"

namespace rclcpp_action {

constexpr size_t kUuidSize = 16;
using GoalUUID = std::array<uint8_t, kUuidSize>;
using GoalStatus = action_msgs::msg::GoalStatus;
using GoalInfo = action_msgs::msg::GoalInfo;

/// 32 hexadecimal digits.
std::string to_string(const GoalUUID& goal_id);
/// A random one (version 4).
GoalUUID make_goal_id();

enum class GoalResponse : int8_t {
  REJECT = 1,
  ACCEPT_AND_EXECUTE = 2,
  ACCEPT_AND_DEFER = 3,
};

enum class CancelResponse : int8_t {
  REJECT = 1,
  ACCEPT = 2,
};

enum class ResultCode : int8_t {
  UNKNOWN = action_msgs::msg::GoalStatus::STATUS_UNKNOWN,
  SUCCEEDED = action_msgs::msg::GoalStatus::STATUS_SUCCEEDED,
  CANCELED = action_msgs::msg::GoalStatus::STATUS_CANCELED,
  ABORTED = action_msgs::msg::GoalStatus::STATUS_ABORTED
};

}  // namespace rclcpp_action

namespace std {

template <>
struct hash<rclcpp_action::GoalUUID> {
  size_t operator()(const rclcpp_action::GoalUUID& uuid) const noexcept {
    size_t result = 2166136261u;
    for (const uint8_t byte : uuid) {
      result = (result ^ byte) * 16777619u;
    }
    return result;
  }
};

}  // namespace std
