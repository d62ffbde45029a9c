// Entities may be added and removed between waits.
#pragma once

#include <memory>
#include <vector>

#include "rclcpp/client.hpp"
#include "rclcpp/guard_condition.hpp"
#include "rclcpp/service.hpp"
#include "rclcpp/timer.hpp"
#include "rclcpp/wait_set_policies/detail/entries.hpp"

namespace rclcpp {
namespace wait_set_policies {

class DynamicStorage {
 public:
  static constexpr bool kFixed = false;
  using SubscriptionEntry = detail::SubscriptionEntry;
  using WaitableEntry = detail::WaitableEntry;
  using SubscriptionsIterable = std::vector<SubscriptionEntry>;
  using GuardConditionsIterable = std::vector<std::shared_ptr<rclcpp::GuardCondition>>;
  using TimersIterable = std::vector<std::shared_ptr<rclcpp::TimerBase>>;
  using ClientsIterable = std::vector<std::shared_ptr<rclcpp::ClientBase>>;
  using ServicesIterable = std::vector<std::shared_ptr<rclcpp::ServiceBase>>;
  using WaitablesIterable = std::vector<WaitableEntry>;
};

}  // namespace wait_set_policies
}  // namespace rclcpp
