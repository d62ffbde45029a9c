// One node of a manager: its state by service, and its bond. All of it runs in one executor, which
// is spun while the manager waits, so that the bonds of other nodes go on meanwhile.
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <memory>
#include <string>

#include "bondcpp/bond.hpp"
#include "lifecycle_msgs/srv/change_state.hpp"
#include "lifecycle_msgs/srv/get_state.hpp"
#include "rclcpp/rclcpp.hpp"

namespace nav2_lifecycle_manager {
namespace detail {

/// Shared by all nodes of a manager. `node` outlives it.
struct NodeLink {
  rclcpp::Node* node;
  rclcpp::CallbackGroup::SharedPtr group;
  rclcpp::executors::SingleThreadedExecutor executor;
  /// The manager ends: nobody waits for an answer any more.
  std::atomic<bool> is_ending = false;
};

class ManagedNode {
 public:
  ManagedNode(std::string name, std::shared_ptr<NodeLink> link);

  /// Waits until the node is there. Logs that it does, every two seconds.
  void wait_for_services() const;

  /// `transition` is an id of lifecycle_msgs/Transition. False: shut down before an answer came.
  /// Throws std::runtime_error when the node is not there.
  bool change_state(std::uint8_t transition);
  /// An id of lifecycle_msgs/State. Throws std::runtime_error when no answer comes in two seconds.
  std::uint8_t get_state();

  /// Waits until the node answers, up to half of the timeout, which is that of heartbeats as well.
  bool form_bond(std::chrono::nanoseconds timeout);
  void drop_bond() { bond_.reset(); }
  bool has_bond() const { return bond_ != nullptr; }
  bool has_broken_bond() const { return bond_ != nullptr && bond_->isBroken(); }

 private:
  template <typename ServiceT>
  typename ServiceT::Response::SharedPtr ask(rclcpp::Client<ServiceT>& client,
                                             typename ServiceT::Request::SharedPtr request,
                                             std::chrono::nanoseconds timeout);

  const std::string name_;
  const std::shared_ptr<NodeLink> link_;
  rclcpp::Client<lifecycle_msgs::srv::ChangeState>::SharedPtr change_state_;
  rclcpp::Client<lifecycle_msgs::srv::GetState>::SharedPtr get_state_;
  std::shared_ptr<bond::Bond> bond_;
};

}  // namespace detail
}  // namespace nav2_lifecycle_manager
