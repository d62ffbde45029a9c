// Puts together messages whose times are as close to each other as may be.
#pragma once

#include <cstdint>

#include "message_filters/detail/match_policy.hpp"

namespace message_filters::sync_policies {

template <typename... Ms>
class ApproximateTime : public detail::MatchPolicy<detail::ApproximateMatch, Ms...> {
  using Base = detail::MatchPolicy<detail::ApproximateMatch, Ms...>;

 public:
  using Sync = Synchronizer<ApproximateTime>;

  /// Keeps so many messages of each topic; with fewer than two, many are dropped.
  explicit ApproximateTime(uint32_t queue_size)
      : Base(detail::ApproximateMatch(sizeof...(Ms), queue_size)) {}

  /// A later set counts as so much longer; 0.1 when not set, not negative.
  void setAgePenalty(double age_penalty) { this->match_.set_age_penalty(age_penalty); }
  /// Messages of topic `i` come at least so far apart: sets need not wait for closer ones.
  void setInterMessageLowerBound(int i, rclcpp::Duration lower_bound) {
    this->match_.set_lower_bound(static_cast<size_t>(i), lower_bound.nanoseconds());
  }
  /// Sets that span more are not made.
  void setMaxIntervalDuration(rclcpp::Duration max_interval_duration) {
    this->match_.set_longest_interval(max_interval_duration.nanoseconds());
  }
};

}  // namespace message_filters::sync_policies
