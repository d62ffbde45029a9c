// Entities, in fixed numbers, are given to the constructor.
#pragma once

#include <array>
#include <cstddef>
#include <memory>

#include "rclcpp/client.hpp"
#include "rclcpp/guard_condition.hpp"
#include "rclcpp/service.hpp"
#include "rclcpp/timer.hpp"
#include "rclcpp/wait_set_policies/detail/entries.hpp"

namespace rclcpp {
namespace wait_set_policies {

template <std::size_t NumberOfSubscriptions, std::size_t NumberOfGuardCondtions,
          std::size_t NumberOfTimers, std::size_t NumberOfClients, std::size_t NumberOfServices,
          std::size_t NumberOfWaitables>
class StaticStorage {
 public:
  static constexpr bool kFixed = true;
  using SubscriptionEntry = detail::SubscriptionEntry;
  using WaitableEntry = detail::WaitableEntry;
  using SubscriptionsIterable = std::array<SubscriptionEntry, NumberOfSubscriptions>;
  using GuardConditionsIterable =
      std::array<std::shared_ptr<rclcpp::GuardCondition>, NumberOfGuardCondtions>;
  using TimersIterable = std::array<std::shared_ptr<rclcpp::TimerBase>, NumberOfTimers>;
  using ClientsIterable = std::array<std::shared_ptr<rclcpp::ClientBase>, NumberOfClients>;
  using ServicesIterable = std::array<std::shared_ptr<rclcpp::ServiceBase>, NumberOfServices>;
  using WaitablesIterable = std::array<WaitableEntry, NumberOfWaitables>;
};

}  // namespace wait_set_policies
}  // namespace rclcpp
