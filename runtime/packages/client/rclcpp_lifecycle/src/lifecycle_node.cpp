// A node with a managed life.
#include "rclcpp_lifecycle/lifecycle_node.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "lifecycle_msgs/msg/state.hpp"
#include "lifecycle_msgs/msg/transition.hpp"
#include "managed_life.hpp"

namespace rclcpp_lifecycle {
namespace {

using StateNumber = lifecycle_msgs::msg::State;
using TransitionNumber = lifecycle_msgs::msg::Transition;

template <typename RowsT>
std::vector<Transition> transitions_of(const RowsT& rows) {
  std::vector<Transition> result;
  std::transform(rows.begin(), rows.end(), std::back_inserter(result), transition_of);
  return result;
}

}  // namespace

LifecycleNode::LifecycleNode(const std::string& node_name, const rclcpp::NodeOptions& options,
                             bool enable_communication_interface)
    : LifecycleNode(node_name, "", options, enable_communication_interface) {}

LifecycleNode::LifecycleNode(const std::string& node_name, const std::string& namespace_,
                             const rclcpp::NodeOptions& options,
                             bool enable_communication_interface)
    : CommonNode(node_name, namespace_, options),
      life_(std::make_unique<ManagedLife>(get_node_base_interface(), get_node_services_interface(),
                                          get_logger(), enable_communication_interface)) {
  register_on_configure([this](const State& state) { return on_configure(state); });
  register_on_cleanup([this](const State& state) { return on_cleanup(state); });
  register_on_shutdown([this](const State& state) { return on_shutdown(state); });
  register_on_activate([this](const State& state) { return on_activate(state); });
  register_on_deactivate([this](const State& state) { return on_deactivate(state); });
  register_on_error([this](const State& state) { return on_error(state); });
}

LifecycleNode::~LifecycleNode() = default;

const State& LifecycleNode::get_current_state() const {
  return life_->current_state();
}

std::vector<State> LifecycleNode::get_available_states() const {
  std::vector<State> result;
  for (const StateRow& row : kStates) {
    result.emplace_back(row.id, row.label);
  }
  return result;
}

std::vector<Transition> LifecycleNode::get_available_transitions() const {
  return transitions_of(life_->available_transitions());
}

std::vector<Transition> LifecycleNode::get_transition_graph() const {
  return transitions_of(kTransitions);
}

const State& LifecycleNode::trigger_transition(const Transition& transition) {
  return trigger_transition(transition.id());
}
const State& LifecycleNode::trigger_transition(const Transition& transition,
                                               CallbackReturn& cb_return_code) {
  return trigger_transition(transition.id(), cb_return_code);
}
const State& LifecycleNode::trigger_transition(uint8_t transition_id) {
  CallbackReturn ignored{};
  return trigger_transition(transition_id, ignored);
}
const State& LifecycleNode::trigger_transition(uint8_t transition_id,
                                               CallbackReturn& cb_return_code) {
  life_->change_state(transition_id, cb_return_code);
  return get_current_state();
}

const State& LifecycleNode::configure() {
  return trigger_transition(TransitionNumber::TRANSITION_CONFIGURE);
}
const State& LifecycleNode::configure(CallbackReturn& cb_return_code) {
  return trigger_transition(TransitionNumber::TRANSITION_CONFIGURE, cb_return_code);
}
const State& LifecycleNode::cleanup() {
  return trigger_transition(TransitionNumber::TRANSITION_CLEANUP);
}
const State& LifecycleNode::cleanup(CallbackReturn& cb_return_code) {
  return trigger_transition(TransitionNumber::TRANSITION_CLEANUP, cb_return_code);
}
const State& LifecycleNode::activate() {
  return trigger_transition(TransitionNumber::TRANSITION_ACTIVATE);
}
const State& LifecycleNode::activate(CallbackReturn& cb_return_code) {
  return trigger_transition(TransitionNumber::TRANSITION_ACTIVATE, cb_return_code);
}
const State& LifecycleNode::deactivate() {
  return trigger_transition(TransitionNumber::TRANSITION_DEACTIVATE);
}
const State& LifecycleNode::deactivate(CallbackReturn& cb_return_code) {
  return trigger_transition(TransitionNumber::TRANSITION_DEACTIVATE, cb_return_code);
}
// Three transitions have this name: one from each state that can be left this way.
const State& LifecycleNode::shutdown() {
  CallbackReturn ignored{};
  return shutdown(ignored);
}
const State& LifecycleNode::shutdown(CallbackReturn& cb_return_code) {
  life_->change_state(kShutdownLabel, cb_return_code);
  return get_current_state();
}

bool LifecycleNode::register_on_configure(std::function<CallbackReturn(const State&)> fcn) {
  life_->set_callback(StateNumber::TRANSITION_STATE_CONFIGURING, std::move(fcn));
  return true;
}
bool LifecycleNode::register_on_cleanup(std::function<CallbackReturn(const State&)> fcn) {
  life_->set_callback(StateNumber::TRANSITION_STATE_CLEANINGUP, std::move(fcn));
  return true;
}
bool LifecycleNode::register_on_shutdown(std::function<CallbackReturn(const State&)> fcn) {
  life_->set_callback(StateNumber::TRANSITION_STATE_SHUTTINGDOWN, std::move(fcn));
  return true;
}
bool LifecycleNode::register_on_activate(std::function<CallbackReturn(const State&)> fcn) {
  life_->set_callback(StateNumber::TRANSITION_STATE_ACTIVATING, std::move(fcn));
  return true;
}
bool LifecycleNode::register_on_deactivate(std::function<CallbackReturn(const State&)> fcn) {
  life_->set_callback(StateNumber::TRANSITION_STATE_DEACTIVATING, std::move(fcn));
  return true;
}
bool LifecycleNode::register_on_error(std::function<CallbackReturn(const State&)> fcn) {
  life_->set_callback(StateNumber::TRANSITION_STATE_ERRORPROCESSING, std::move(fcn));
  return true;
}

LifecycleNode::CallbackReturn LifecycleNode::on_activate(const State&) {
  life_->activate_entities();
  return CallbackReturn::SUCCESS;
}
LifecycleNode::CallbackReturn LifecycleNode::on_deactivate(const State&) {
  life_->deactivate_entities();
  return CallbackReturn::SUCCESS;
}

void LifecycleNode::add_managed_entity(std::weak_ptr<ManagedEntityInterface> managed_entity) {
  life_->add_managed_entity(std::move(managed_entity));
}
void LifecycleNode::add_timer_handle(std::shared_ptr<rclcpp::TimerBase>) {}

}  // namespace rclcpp_lifecycle
