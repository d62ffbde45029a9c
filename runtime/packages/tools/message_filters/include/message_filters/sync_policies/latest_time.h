// Puts together the newest messages, at the rate of the fastest topic that is not late.
#pragma once

#include <memory>
#include <tuple>
#include <utility>
#include <vector>

#include "message_filters/detail/match_policy.hpp"

namespace message_filters::sync_policies {

template <typename... Ms>
class LatestTime : public detail::MatchPolicy<detail::LatestMatch, Ms...> {
  using Base = detail::MatchPolicy<detail::LatestMatch, Ms...>;

 public:
  using Sync = Synchronizer<LatestTime>;
  /// How fast the mean rate and its mean error follow (0 to 1), and how many mean errors away from
  /// the mean a rate has changed.
  using RateConfig = std::tuple<double, double, double>;

  /// Rates are those of arrival, by this clock.
  explicit LatestTime(
      rclcpp::Clock::SharedPtr clock = std::make_shared<rclcpp::Clock>(RCL_ROS_TIME))
      : Base(detail::LatestMatch(sizeof...(Ms))), clock_(std::move(clock)) {}

  template <int i>
  void add(const std::tuple_element_t<i, typename Base::Events>& evt) {
    this->template match<i>(clock_->now().nanoseconds(), evt);
  }

  /// For topics of which nothing has come yet.
  void setRateConfigPerMessage(const std::vector<RateConfig>& configs) {
    std::vector<detail::LatestMatch::Smoothing> smoothing;
    for (const auto& [rate, error, margin] : configs) {
      smoothing.push_back({rate, error, margin});
    }
    this->match_.set_smoothing(std::move(smoothing));
  }
  void setRateConfig(const RateConfig& config) { setRateConfigPerMessage({config}); }
  void setClock(rclcpp::Clock::SharedPtr clock) { clock_ = std::move(clock); }

 private:
  rclcpp::Clock::SharedPtr clock_;
};

}  // namespace message_filters::sync_policies
