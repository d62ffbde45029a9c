// A node with a managed life. Whoever may call its services, or it itself, takes it from state to
// state; at each step one of its callbacks decides where it leads.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "rclcpp/node.hpp"
#include "rclcpp_lifecycle/lifecycle_publisher.hpp"
#include "rclcpp_lifecycle/managed_entity.hpp"
#include "rclcpp_lifecycle/node_interfaces/lifecycle_node_interface.hpp"
#include "rclcpp_lifecycle/state.hpp"
#include "rclcpp_lifecycle/transition.hpp"
#include "rclcpp_lifecycle/visibility_control.h"

namespace rclcpp_lifecycle {

class ManagedLife;

template <typename AllocatorT>
using PublisherOptionsWithAllocator = rclcpp::PublisherOptionsWithAllocator<AllocatorT>;
template <typename AllocatorT>
using SubscriptionOptionsWithAllocator = rclcpp::SubscriptionOptionsWithAllocator<AllocatorT>;

template <typename AllocatorT>
PublisherOptionsWithAllocator<AllocatorT> create_default_publisher_options() {
  return PublisherOptionsWithAllocator<AllocatorT>();
}
template <typename AllocatorT>
SubscriptionOptionsWithAllocator<AllocatorT> create_default_subscription_options() {
  return SubscriptionOptionsWithAllocator<AllocatorT>();
}

class LifecycleNode : public node_interfaces::LifecycleNodeInterface,
                      public std::enable_shared_from_this<LifecycleNode>,
                      public rclcpp::detail::CommonNode {
 public:
  RCLCPP_SMART_PTR_DEFINITIONS(LifecycleNode)

  /// Without the communication interface there are no services, only ~/transition_event.
  explicit LifecycleNode(const std::string& node_name,
                         const rclcpp::NodeOptions& options = rclcpp::NodeOptions(),
                         bool enable_communication_interface = true);
  LifecycleNode(const std::string& node_name, const std::string& namespace_,
                const rclcpp::NodeOptions& options = rclcpp::NodeOptions(),
                bool enable_communication_interface = true);
  ~LifecycleNode() override;

  /// A publisher that is activated and deactivated with the node.
  template <typename MessageT, typename AllocatorT = std::allocator<void>>
  std::shared_ptr<LifecyclePublisher<MessageT, AllocatorT>> create_publisher(
      const std::string& topic_name, const rclcpp::QoS& qos,
      const PublisherOptionsWithAllocator<AllocatorT>& options =
          create_default_publisher_options<AllocatorT>()) {
    auto publisher = CommonNode::create_publisher<MessageT, AllocatorT,
                                                  LifecyclePublisher<MessageT, AllocatorT>>(
        topic_name, qos, options);
    add_managed_entity(publisher);
    return publisher;
  }

  const State& get_current_state() const;
  std::vector<State> get_available_states() const;
  /// Those that start at the current state, and all.
  std::vector<Transition> get_available_transitions() const;
  std::vector<Transition> get_transition_graph() const;

  /// Each returns the state after the transition. A transition that does not start at the current
  /// state is refused: an error is logged, and `cb_return_code` stays as it is.
  const State& trigger_transition(const Transition& transition);
  const State& trigger_transition(const Transition& transition, CallbackReturn& cb_return_code);
  const State& trigger_transition(uint8_t transition_id);
  const State& trigger_transition(uint8_t transition_id, CallbackReturn& cb_return_code);
  const State& configure();
  const State& configure(CallbackReturn& cb_return_code);
  const State& cleanup();
  const State& cleanup(CallbackReturn& cb_return_code);
  const State& activate();
  const State& activate(CallbackReturn& cb_return_code);
  const State& deactivate();
  const State& deactivate(CallbackReturn& cb_return_code);
  const State& shutdown();
  const State& shutdown(CallbackReturn& cb_return_code);

  /// A function in place of the method of that name. Always true.
  bool register_on_configure(std::function<CallbackReturn(const State&)> fcn);
  bool register_on_cleanup(std::function<CallbackReturn(const State&)> fcn);
  bool register_on_shutdown(std::function<CallbackReturn(const State&)> fcn);
  bool register_on_activate(std::function<CallbackReturn(const State&)> fcn);
  bool register_on_deactivate(std::function<CallbackReturn(const State&)> fcn);
  bool register_on_error(std::function<CallbackReturn(const State&)> fcn);

  /// Activate and deactivate the managed entities; who overrides them calls them.
  CallbackReturn on_activate(const State& previous_state) override;
  CallbackReturn on_deactivate(const State& previous_state) override;

 protected:
  void add_managed_entity(std::weak_ptr<ManagedEntityInterface> managed_entity);
  /// Timers go on in every state, as in ROS 2.
  void add_timer_handle(std::shared_ptr<rclcpp::TimerBase> timer);

 private:
  RCLCPP_DISABLE_COPY(LifecycleNode)
  const std::unique_ptr<ManagedLife> life_;
};

}  // namespace rclcpp_lifecycle
