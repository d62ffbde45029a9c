// Puts together messages at most a given time apart.
#pragma once

#include <cstdint>

#include "message_filters/detail/match_policy.hpp"

namespace message_filters::sync_policies {

template <typename... Ms>
class ApproximateEpsilonTime : public detail::MatchPolicy<detail::EpsilonMatch, Ms...> {
  using Base = detail::MatchPolicy<detail::EpsilonMatch, Ms...>;

 public:
  using Sync = Synchronizer<ApproximateEpsilonTime>;

  /// Keeps so many messages of each topic.
  ApproximateEpsilonTime(uint32_t queue_size, rclcpp::Duration epsilon)
      : Base(detail::EpsilonMatch(sizeof...(Ms), queue_size, epsilon.nanoseconds())) {}
};

}  // namespace message_filters::sync_policies
