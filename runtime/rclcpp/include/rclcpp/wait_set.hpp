// The kinds of wait sets.
#pragma once

#include <array>
#include <cstddef>
#include <memory>

#include "rclcpp/wait_set_template.hpp"

namespace rclcpp {

/// Entities may be added and removed between waits.
using WaitSet = BasicWaitSet<false, false>;
/// As WaitSet; entities may also be added and removed by other threads.
using ThreadSafeWaitSet = BasicWaitSet<false, true>;

/// Entities, in these numbers, are given to the constructor.
template <std::size_t NumberOfSubscriptions, std::size_t NumberOfGuardCondtions,
          std::size_t NumberOfTimers, std::size_t NumberOfClients, std::size_t NumberOfServices,
          std::size_t NumberOfWaitables>
class StaticWaitSet {
  using Base = BasicWaitSet<true, false>;

 public:
  RCLCPP_SMART_PTR_DEFINITIONS_NOT_COPYABLE(StaticWaitSet)
  using SubscriptionEntry = Base::SubscriptionEntry;
  using WaitableEntry = Base::WaitableEntry;

  explicit StaticWaitSet(
      const std::array<SubscriptionEntry, NumberOfSubscriptions>& subscriptions = {},
      const std::array<std::shared_ptr<rclcpp::GuardCondition>, NumberOfGuardCondtions>&
          guard_conditions = {},
      const std::array<std::shared_ptr<rclcpp::TimerBase>, NumberOfTimers>& timers = {},
      const std::array<std::shared_ptr<rclcpp::ClientBase>, NumberOfClients>& clients = {},
      const std::array<std::shared_ptr<rclcpp::ServiceBase>, NumberOfServices>& services = {},
      const std::array<WaitableEntry, NumberOfWaitables>& waitables = {},
      rclcpp::Context::SharedPtr context = rclcpp::contexts::get_global_default_context())
      : base_(subscriptions, guard_conditions, timers, clients, services, waitables,
              std::move(context)) {}

  const rcl_wait_set_t& get_rcl_wait_set() const { return base_.get_rcl_wait_set(); }
  template <class Rep = int64_t, class Period = std::milli>
  [[nodiscard]] WaitResult<Base> wait(
      std::chrono::duration<Rep, Period> time_to_wait = std::chrono::duration<Rep, Period>(-1)) {
    return base_.wait(time_to_wait);
  }

 private:
  Base base_;
};

}  // namespace rclcpp
