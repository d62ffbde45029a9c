// The traits of a message that filters use: its frame and its time. Specialize them for messages
// that have these elsewhere than in `header`.
#pragma once

#include <string>
#include <type_traits>

#include "rclcpp/rclcpp.hpp"
#include "std_msgs/msg/header.hpp"

namespace message_filters::message_traits {

template <typename M, typename = void>
struct HasHeader : public std::false_type {};

template <typename M>
struct HasHeader<M, std::enable_if_t<std::is_same_v<std_msgs::msg::Header, decltype(M().header)>>>
    : public std::true_type {};

template <typename M, typename Enable = void>
struct FrameId {
  static std::string* pointer(M&) { return nullptr; }
  static const std::string* pointer(const M&) { return nullptr; }
};

template <typename M>
struct FrameId<M, std::enable_if_t<HasHeader<M>::value>> {
  static std::string* pointer(M& m) { return &m.header.frame_id; }
  static const std::string* pointer(const M& m) { return &m.header.frame_id; }
  static std::string value(const M& m) { return m.header.frame_id; }
};

/// Zero for a message without a header.
template <typename M, typename Enable = void>
struct TimeStamp {
  static rclcpp::Time value(const M&) { return rclcpp::Time(); }
};

template <typename M>
struct TimeStamp<M, std::enable_if_t<HasHeader<M>::value>> {
  static rclcpp::Time value(const M& m) { return rclcpp::Time(m.header.stamp, RCL_ROS_TIME); }
};

}  // namespace message_filters::message_traits
