// Where a managed node is in its life, its callbacks, and the topic and services by which others
// follow and steer it.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "lifecycle_msgs/msg/transition_event.hpp"
#include "lifecycle_msgs/srv/change_state.hpp"
#include "lifecycle_msgs/srv/get_available_states.hpp"
#include "lifecycle_msgs/srv/get_available_transitions.hpp"
#include "lifecycle_msgs/srv/get_state.hpp"
#include "rclcpp/logger.hpp"
#include "rclcpp/node_interfaces/node_base_interface.hpp"
#include "rclcpp/node_interfaces/node_services_interface.hpp"
#include "rclcpp/publisher.hpp"
#include "rclcpp/service.hpp"
#include "rclcpp_lifecycle/managed_entity.hpp"
#include "rclcpp_lifecycle/node_interfaces/lifecycle_node_interface.hpp"
#include "rclcpp_lifecycle/state.hpp"
#include "transition_map.hpp"

namespace rclcpp_lifecycle {

class ManagedLife {
 public:
  using CallbackReturn = node_interfaces::LifecycleNodeInterface::CallbackReturn;
  using Callback = std::function<CallbackReturn(const State&)>;

  ManagedLife(rclcpp::node_interfaces::NodeBaseInterface::SharedPtr node_base,
              rclcpp::node_interfaces::NodeServicesInterface::SharedPtr node_services,
              rclcpp::Logger logger, bool with_services);

  [[nodiscard]] const State& current_state() const { return current_; }
  /// Those that start at the current state.
  [[nodiscard]] std::vector<TransitionRow> available_transitions() const;

  /// Sets the callback of a transition state, such as TRANSITION_STATE_CONFIGURING.
  void set_callback(uint8_t transition_state, Callback callback);
  /// Goes from the current state through the callback to the next primary state. `result` is what
  /// the callback returned; it stays as it is when the transition does not start here.
  void change_state(uint8_t transition_id, CallbackReturn& result);
  /// The same by label; without a log line of error when there is no such transition.
  void change_state(const char* label, CallbackReturn& result);

  void add_managed_entity(std::weak_ptr<ManagedEntityInterface> entity);
  void activate_entities() const;
  void deactivate_entities() const;

 private:
  using TransitionEvent = lifecycle_msgs::msg::TransitionEvent;
  using ChangeState = lifecycle_msgs::srv::ChangeState;
  using GetState = lifecycle_msgs::srv::GetState;
  using GetAvailableStates = lifecycle_msgs::srv::GetAvailableStates;
  using GetAvailableTransitions = lifecycle_msgs::srv::GetAvailableTransitions;

  void add_services();
  template <typename ServiceT, typename CallbackT>
  void add_service(const char* name, CallbackT callback);
  void answer_change_state(const ChangeState::Request& request, ChangeState::Response& response);

  /// Null, with a warning, when no such transition starts here.
  template <typename KeyT>
  [[nodiscard]] const TransitionRow* find_here(const KeyT& id_or_label) const;
  void step(const TransitionRow& row);
  /// Calls the callback of the current state and takes the step that its result says. False when
  /// there is no such step, because the callback changed the state itself.
  bool pass_through(uint8_t transition_id, const State& initial, CallbackReturn& result);
  [[nodiscard]] CallbackReturn call(const State& initial) const;

  const rclcpp::node_interfaces::NodeBaseInterface::SharedPtr node_base_;
  const rclcpp::node_interfaces::NodeServicesInterface::SharedPtr node_services_;
  const rclcpp::Logger logger_;
  rclcpp::Publisher<TransitionEvent> events_;
  std::vector<rclcpp::ServiceBase::SharedPtr> services_;

  mutable std::recursive_mutex mutex_;
  State current_;
  std::map<uint8_t, Callback> callbacks_;
  std::vector<std::weak_ptr<ManagedEntityInterface>> entities_;
};

}  // namespace rclcpp_lifecycle
