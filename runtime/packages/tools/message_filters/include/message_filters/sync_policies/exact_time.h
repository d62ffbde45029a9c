// Puts together messages with the same time.
#pragma once

#include <cstdint>

#include "message_filters/detail/match_policy.hpp"

namespace message_filters::sync_policies {

template <typename... Ms>
class ExactTime : public detail::MatchPolicy<detail::ExactMatch, Ms...> {
  using Base = detail::MatchPolicy<detail::ExactMatch, Ms...>;

 public:
  using Sync = Synchronizer<ExactTime>;

  /// Keeps messages of so many times; 0: of all since the last set.
  explicit ExactTime(uint32_t queue_size) : Base(detail::ExactMatch(sizeof...(Ms), queue_size)) {}

  /// Called with what is dropped; the pointers to messages that never came are null.
  template <class... C>
  Connection registerDropCallback(C... callback) {
    return this->dropped_.addCallback(callback...);
  }

  /// The time of the last set; zero before the first.
  rclcpp::Time getLastSignalTime() const {
    const auto last = this->match_.last();
    return last ? rclcpp::Time(*last, RCL_ROS_TIME) : rclcpp::Time();
  }
};

}  // namespace message_filters::sync_policies
