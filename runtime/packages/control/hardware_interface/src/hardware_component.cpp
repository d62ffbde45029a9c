// The life of one component: which callback leads from which state where.
#include "hardware_interface/hardware_component.hpp"

#include <utility>

#include "hardware_interface/lifecycle_helpers.hpp"

namespace hardware_interface {
namespace {

using lifecycle_msgs::msg::State;

rclcpp_lifecycle::State state_of(uint8_t id) {
  switch (id) {
    case State::PRIMARY_STATE_UNCONFIGURED:
      return {id, lifecycle_state_names::UNCONFIGURED};
    case State::PRIMARY_STATE_INACTIVE:
      return {id, lifecycle_state_names::INACTIVE};
    case State::PRIMARY_STATE_ACTIVE:
      return {id, lifecycle_state_names::ACTIVE};
    case State::PRIMARY_STATE_FINALIZED:
      return {id, lifecycle_state_names::FINALIZED};
    default:
      return {id, lifecycle_state_names::UNKNOWN};
  }
}

}  // namespace

HardwareComponent::HardwareComponent(std::unique_ptr<HardwareComponentInterface> impl)
    : impl_(std::move(impl)) {}

HardwareComponent::HardwareComponent(HardwareComponent&& other) noexcept
    : impl_(std::move(other.impl_)),
      last_read_cycle_time_(other.last_read_cycle_time_),
      last_write_cycle_time_(other.last_write_cycle_time_) {}

const rclcpp_lifecycle::State& HardwareComponent::initialize(
    const HardwareComponentParams& params) {
  const std::lock_guard<std::recursive_mutex> lock(component_mutex_);
  if (get_lifecycle_id() == State::PRIMARY_STATE_UNKNOWN) {
    const bool ready = impl_->init(params) == CallbackReturn::SUCCESS;
    impl_->set_lifecycle_state(
        state_of(ready ? State::PRIMARY_STATE_UNCONFIGURED : State::PRIMARY_STATE_FINALIZED));
  }
  return get_lifecycle_state();
}

const rclcpp_lifecycle::State& HardwareComponent::take(Step step) {
  using Callback = CallbackReturn (HardwareComponentInterface::*)(const rclcpp_lifecycle::State&);
  struct Row {
    uint8_t from;  ///< PRIMARY_STATE_UNKNOWN: any state of a life that has begun and not ended
    Callback callback;
    uint8_t on_success;
    bool can_fail;  ///< FAILURE leaves the component where it was; otherwise it is an error
  };
  static const Row kRows[] = {
      {State::PRIMARY_STATE_UNCONFIGURED, &HardwareComponentInterface::on_configure,
       State::PRIMARY_STATE_INACTIVE, true},
      {State::PRIMARY_STATE_INACTIVE, &HardwareComponentInterface::on_cleanup,
       State::PRIMARY_STATE_UNCONFIGURED, false},
      {State::PRIMARY_STATE_UNKNOWN, &HardwareComponentInterface::on_shutdown,
       State::PRIMARY_STATE_FINALIZED, false},
      {State::PRIMARY_STATE_INACTIVE, &HardwareComponentInterface::on_activate,
       State::PRIMARY_STATE_ACTIVE, true},
      {State::PRIMARY_STATE_ACTIVE, &HardwareComponentInterface::on_deactivate,
       State::PRIMARY_STATE_INACTIVE, true},
  };
  const std::lock_guard<std::recursive_mutex> lock(component_mutex_);
  const Row& row = kRows[static_cast<std::size_t>(step)];
  const uint8_t now = get_lifecycle_id();
  const bool starts_here =
      row.from == State::PRIMARY_STATE_UNKNOWN
          ? now != State::PRIMARY_STATE_UNKNOWN && now != State::PRIMARY_STATE_FINALIZED
          : now == row.from;
  if (!starts_here) {
    return get_lifecycle_state();
  }
  const CallbackReturn result = (*impl_.*row.callback)(get_lifecycle_state());
  if (result == CallbackReturn::SUCCESS) {
    impl_->set_lifecycle_state(state_of(row.on_success));
  } else if (result == CallbackReturn::ERROR || !row.can_fail) {
    return error();
  }
  return get_lifecycle_state();
}

const rclcpp_lifecycle::State& HardwareComponent::configure() {
  return take(Step::kConfigure);
}
const rclcpp_lifecycle::State& HardwareComponent::cleanup() {
  return take(Step::kCleanup);
}
const rclcpp_lifecycle::State& HardwareComponent::shutdown() {
  return take(Step::kShutdown);
}
const rclcpp_lifecycle::State& HardwareComponent::activate() {
  last_read_cycle_time_ = last_write_cycle_time_ = rclcpp::Time(0, 0, RCL_CLOCK_UNINITIALIZED);
  return take(Step::kActivate);
}
const rclcpp_lifecycle::State& HardwareComponent::deactivate() {
  return take(Step::kDeactivate);
}

const rclcpp_lifecycle::State& HardwareComponent::error() {
  const std::lock_guard<std::recursive_mutex> lock(component_mutex_);
  const uint8_t now = get_lifecycle_id();
  if (now != State::PRIMARY_STATE_UNKNOWN && now != State::PRIMARY_STATE_UNCONFIGURED) {
    const bool recovered = impl_->on_error(get_lifecycle_state()) == CallbackReturn::SUCCESS;
    impl_->set_lifecycle_state(
        state_of(recovered ? State::PRIMARY_STATE_UNCONFIGURED : State::PRIMARY_STATE_FINALIZED));
  }
  return get_lifecycle_state();
}

std::vector<StateInterface::ConstSharedPtr> HardwareComponent::export_state_interfaces() {
  auto by_value = impl_->export_state_interfaces();
  if (by_value.empty()) {
    return impl_->on_export_state_interfaces();
  }
  std::vector<StateInterface::ConstSharedPtr> result;
  for (auto& interface : by_value) {
    result.push_back(std::make_shared<const StateInterface>(interface));
  }
  return result;
}

std::vector<CommandInterface::SharedPtr> HardwareComponent::export_command_interfaces() {
  auto by_value = impl_->export_command_interfaces();
  if (by_value.empty()) {
    return impl_->on_export_command_interfaces();
  }
  std::vector<CommandInterface::SharedPtr> result;
  for (auto& interface : by_value) {
    result.push_back(std::make_shared<CommandInterface>(std::move(interface)));
  }
  return result;
}

return_type HardwareComponent::prepare_command_mode_switch(
    const std::vector<std::string>& start_interfaces,
    const std::vector<std::string>& stop_interfaces) {
  return impl_->prepare_command_mode_switch(start_interfaces, stop_interfaces);
}
return_type HardwareComponent::perform_command_mode_switch(
    const std::vector<std::string>& start_interfaces,
    const std::vector<std::string>& stop_interfaces) {
  return impl_->perform_command_mode_switch(start_interfaces, stop_interfaces);
}

const std::string& HardwareComponent::get_name() const {
  return impl_->get_name();
}
const std::string& HardwareComponent::get_group_name() const {
  return impl_->get_group_name();
}
const rclcpp_lifecycle::State& HardwareComponent::get_lifecycle_state() const {
  return impl_->get_lifecycle_state();
}
uint8_t HardwareComponent::get_lifecycle_id() const {
  return impl_->get_lifecycle_id();
}

return_type HardwareComponent::read(const rclcpp::Time& time, const rclcpp::Duration& period) {
  return_type result = return_type::OK;
  if (!lifecycleStateThatRequiresNoAction(get_lifecycle_id())) {
    result = impl_->trigger_read(time, period).result;
    if (result == return_type::ERROR) {
      error();
    }
  }
  last_read_cycle_time_ = time;
  return result;
}

return_type HardwareComponent::write(const rclcpp::Time& time, const rclcpp::Duration& period) {
  return_type result = return_type::OK;
  if (get_lifecycle_id() == State::PRIMARY_STATE_ACTIVE) {
    result = impl_->trigger_write(time, period).result;
    if (result == return_type::ERROR) {
      error();
    }
  }
  last_write_cycle_time_ = time;
  return result;
}

}  // namespace hardware_interface
