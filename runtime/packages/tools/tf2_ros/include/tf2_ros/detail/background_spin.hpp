// Runs the callbacks of a group whenever any thread of the program waits: what upstream has a
// thread for. So a program that listens to transforms needs no shared memory.
#pragma once

#include <memory>
#include <vector>

#include "rclcpp/rclcpp.hpp"

namespace tf2_ros {
namespace detail {

class BackgroundSpin {
 public:
  BackgroundSpin(rclcpp::CallbackGroup::SharedPtr group,
                 rclcpp::node_interfaces::NodeBaseInterface::SharedPtr node_base,
                 const std::vector<rclcpp::SubscriptionBase::SharedPtr>& subscriptions);
  /// Waits until no other thread is in a callback.
  ~BackgroundSpin();

 private:
  struct State;

  std::shared_ptr<State> state_;
  std::vector<std::shared_ptr<void>> works_;
};

}  // namespace detail
}  // namespace tf2_ros
