// The entries that the constructors of wait sets take where an entity needs additional data: a mask
// for a subscription, an associated entity for a waitable.
#pragma once

#include <memory>
#include <type_traits>
#include <utility>

#include "rclcpp/subscription_base.hpp"
#include "rclcpp/subscription_wait_set_mask.hpp"
#include "rclcpp/waitable.hpp"

namespace rclcpp {
namespace wait_set_policies {
namespace detail {

struct SubscriptionEntry {
  std::shared_ptr<rclcpp::SubscriptionBase> subscription;
  rclcpp::SubscriptionWaitSetMask mask;

  SubscriptionEntry(std::shared_ptr<rclcpp::SubscriptionBase> subscription_in = nullptr,
                    const rclcpp::SubscriptionWaitSetMask& mask_in = {})  // NOLINT
      : subscription(std::move(subscription_in)), mask(mask_in) {}
  template <typename SubscriptionT,
            typename = std::enable_if_t<std::is_base_of_v<rclcpp::SubscriptionBase, SubscriptionT>>>
  SubscriptionEntry(const std::shared_ptr<SubscriptionT>& subscription_in)  // NOLINT
      : subscription(subscription_in) {}
};

struct WaitableEntry {
  std::shared_ptr<rclcpp::Waitable> waitable;
  std::shared_ptr<void> associated_entity;
  WaitableEntry(std::shared_ptr<rclcpp::Waitable> waitable_in = nullptr,
                std::shared_ptr<void> associated_entity_in = nullptr)  // NOLINT
      : waitable(std::move(waitable_in)), associated_entity(std::move(associated_entity_in)) {}
};

}  // namespace detail
}  // namespace wait_set_policies
}  // namespace rclcpp
