// Gives a subscription its statistics where its options or its node ask for them.
#pragma once

#include <memory>

#include "rclcpp/node_interfaces/node_topics_interface.hpp"
#include "rclcpp/subscription_base.hpp"
#include "rclcpp/subscription_options.hpp"

namespace rclcpp {
namespace detail {

/// Throws std::invalid_argument for a period that is not positive.
void add_topic_statistics(SubscriptionBase& subscription, const SubscriptionOptionsBase& options,
                          node_interfaces::NodeTopicsInterface& topics);

}  // namespace detail
}  // namespace rclcpp
