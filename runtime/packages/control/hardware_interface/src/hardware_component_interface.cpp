// The part of plugins that the framework brings.
#include "hardware_interface/hardware_component_interface.hpp"

#include <algorithm>
#include <atomic>
#include <map>
#include <mutex>

#include "hardware_interface/loan_counts.hpp"

namespace hardware_interface {

using lifecycle_msgs::msg::State;

struct HardwareComponentInterface::Parts {
  rclcpp::Clock::SharedPtr clock;
  rclcpp::Logger logger = rclcpp::get_logger("hardware_component_interface");
  std::string node_namespace;
  rclcpp::Executor::WeakPtr executor;
  rclcpp::Node::SharedPtr node;
  std::mutex node_mutex;
  std::map<std::string, StateInterface::SharedPtr> states;
  std::map<std::string, CommandInterface::SharedPtr> commands;
  std::atomic<uint8_t> lifecycle_id = State::PRIMARY_STATE_UNKNOWN;
};

namespace {

/// The descriptions of a map, sorted by name: exports have the same order in every run.
std::vector<const InterfaceDescription*> sorted(
    const std::unordered_map<std::string, InterfaceDescription>& descriptions) {
  std::vector<const InterfaceDescription*> result;
  for (const auto& entry : descriptions) {
    result.push_back(&entry.second);
  }
  std::sort(result.begin(), result.end(),
            [](const auto* a, const auto* b) { return a->get_name() < b->get_name(); });
  return result;
}

}  // namespace

HardwareComponentInterface::HardwareComponentInterface()
    : lifecycle_state_(State::PRIMARY_STATE_UNKNOWN, lifecycle_state_names::UNKNOWN),
      parts_(std::make_unique<Parts>()) {}

HardwareComponentInterface::~HardwareComponentInterface() = default;

CallbackReturn HardwareComponentInterface::init(
    const HardwareInfo& hardware_info, rclcpp::Logger logger,
    rclcpp::node_interfaces::NodeClockInterface::SharedPtr clock_interface) {
  return init(hardware_info, logger, clock_interface->get_clock());
}

CallbackReturn HardwareComponentInterface::init(const HardwareInfo& hardware_info,
                                                rclcpp::Logger logger,
                                                rclcpp::Clock::SharedPtr clock) {
  HardwareComponentParams params;
  params.hardware_info = hardware_info;
  params.logger = logger;
  params.clock = clock;
  return init(params);
}

CallbackReturn HardwareComponentInterface::init(const HardwareComponentParams& params) {
  parts_->clock = params.clock;
  parts_->logger = params.logger;
  parts_->node_namespace = params.node_namespace;
  parts_->executor = params.executor;
  info_ = params.hardware_info;
  if (info_.is_async) {
    RCLCPP_WARN(get_logger(),
                "The attribute 'is_async' of '%s' has no effect in a site: the control loop reads "
                "and writes the component.",
                info_.name.c_str());
  }
  HardwareComponentInterfaceParams interface_params;
  interface_params.hardware_info = info_;
  interface_params.executor = params.executor;
  return on_init(interface_params);
}

CallbackReturn HardwareComponentInterface::on_init(const HardwareInfo& hardware_info) {
  info_ = hardware_info;
  parse_state_interface_descriptions(info_.joints, joint_state_interfaces_);
  if (info_.type != "sensor") {
    parse_command_interface_descriptions(info_.joints, joint_command_interfaces_);
  }
  if (info_.type != "actuator") {
    parse_state_interface_descriptions(info_.sensors, sensor_state_interfaces_);
  }
  if (info_.type == "system") {
    parse_state_interface_descriptions(info_.gpios, gpio_state_interfaces_);
    parse_command_interface_descriptions(info_.gpios, gpio_command_interfaces_);
  }
  return CallbackReturn::SUCCESS;
}

CallbackReturn HardwareComponentInterface::on_init(const HardwareComponentInterfaceParams& params) {
  return on_init(params.hardware_info);
}

rclcpp::NodeOptions HardwareComponentInterface::define_custom_node_options() const {
  rclcpp::NodeOptions options;
  options.enable_logger_service(true);
  return options;
}

std::vector<StateInterface> HardwareComponentInterface::export_state_interfaces() {
  return {};
}
std::vector<CommandInterface> HardwareComponentInterface::export_command_interfaces() {
  return {};
}
std::vector<InterfaceDescription>
HardwareComponentInterface::export_unlisted_state_interface_descriptions() {
  return {};
}
std::vector<InterfaceDescription>
HardwareComponentInterface::export_unlisted_command_interface_descriptions() {
  return {};
}

StateInterface::SharedPtr HardwareComponentInterface::add_state(
    const InterfaceDescription& description) {
  auto handle = std::make_shared<StateInterface>(description);
  parts_->states.emplace(description.get_name(), handle);
  return handle;
}
CommandInterface::SharedPtr HardwareComponentInterface::add_command(
    const InterfaceDescription& description) {
  auto handle = std::make_shared<CommandInterface>(description);
  parts_->commands.emplace(description.get_name(), handle);
  return handle;
}

std::vector<StateInterface::ConstSharedPtr>
HardwareComponentInterface::on_export_state_interfaces() {
  for (const auto& description : export_unlisted_state_interface_descriptions()) {
    unlisted_state_interfaces_.emplace(description.get_name(), description);
    unlisted_states_.push_back(add_state(description));
  }
  const auto add_all = [this](const auto& descriptions, auto& handles) {
    for (const auto* description : sorted(descriptions)) {
      handles.push_back(add_state(*description));
    }
  };
  add_all(joint_state_interfaces_, joint_states_);
  add_all(sensor_state_interfaces_, sensor_states_);
  add_all(gpio_state_interfaces_, gpio_states_);
  std::vector<StateInterface::ConstSharedPtr> all;
  for (const auto* handles : {&unlisted_states_, &joint_states_, &sensor_states_, &gpio_states_}) {
    all.insert(all.end(), handles->begin(), handles->end());
  }
  return all;
}

std::vector<CommandInterface::SharedPtr>
HardwareComponentInterface::on_export_command_interfaces() {
  for (const auto& description : export_unlisted_command_interface_descriptions()) {
    unlisted_command_interfaces_.emplace(description.get_name(), description);
    unlisted_commands_.push_back(add_command(description));
  }
  const auto add_all = [this](const auto& descriptions, auto& handles) {
    for (const auto* description : sorted(descriptions)) {
      handles.push_back(add_command(*description));
    }
  };
  add_all(joint_command_interfaces_, joint_commands_);
  add_all(gpio_command_interfaces_, gpio_commands_);
  std::vector<CommandInterface::SharedPtr> all;
  for (const auto* handles : {&unlisted_commands_, &joint_commands_, &gpio_commands_}) {
    all.insert(all.end(), handles->begin(), handles->end());
  }
  return all;
}

return_type HardwareComponentInterface::prepare_command_mode_switch(
    const std::vector<std::string>&, const std::vector<std::string>&) {
  return return_type::OK;
}
return_type HardwareComponentInterface::perform_command_mode_switch(
    const std::vector<std::string>&, const std::vector<std::string>&) {
  return return_type::OK;
}

HardwareComponentCycleStatus HardwareComponentInterface::trigger_read(
    const rclcpp::Time& time, const rclcpp::Duration& period) {
  HardwareComponentCycleStatus status;
  status.result = read(time, period);
  return status;
}
HardwareComponentCycleStatus HardwareComponentInterface::trigger_write(
    const rclcpp::Time& time, const rclcpp::Duration& period) {
  HardwareComponentCycleStatus status;
  status.result = write(time, period);
  return status;
}
return_type HardwareComponentInterface::write(const rclcpp::Time&, const rclcpp::Duration&) {
  return return_type::OK;
}

const std::string& HardwareComponentInterface::get_name() const {
  return info_.name;
}
const std::string& HardwareComponentInterface::get_group_name() const {
  return info_.group;
}
const rclcpp_lifecycle::State& HardwareComponentInterface::get_lifecycle_state() const {
  return lifecycle_state_;
}
void HardwareComponentInterface::set_lifecycle_state(const rclcpp_lifecycle::State& new_state) {
  lifecycle_state_ = new_state;
  parts_->lifecycle_id = new_state.id();
}
uint8_t HardwareComponentInterface::get_lifecycle_id() const {
  return parts_->lifecycle_id;
}

bool HardwareComponentInterface::has_state(const std::string& interface_name) const {
  return parts_->states.count(interface_name) > 0;
}
const StateInterface::SharedPtr& HardwareComponentInterface::get_state_interface_handle(
    const std::string& interface_name) const {
  const auto found = parts_->states.find(interface_name);
  if (found == parts_->states.end()) {
    throw std::runtime_error("The requested state interface not found: '" + interface_name +
                             "' in hardware component: '" + info_.name + "'.");
  }
  return found->second;
}
bool HardwareComponentInterface::has_command(const std::string& interface_name) const {
  return parts_->commands.count(interface_name) > 0;
}
const CommandInterface::SharedPtr& HardwareComponentInterface::get_command_interface_handle(
    const std::string& interface_name) const {
  const auto found = parts_->commands.find(interface_name);
  if (found == parts_->commands.end()) {
    throw std::runtime_error("The requested command interface not found: '" + interface_name +
                             "' in hardware component: '" + info_.name + "'.");
  }
  return found->second;
}
void HardwareComponentInterface::refuse_null(const Handle* handle, const char* kind,
                                             const char* method) const {
  if (handle == nullptr) {
    throw std::runtime_error(std::string(kind) +
                             " interface handle is null in hardware component: " + info_.name +
                             ", while calling " + method + " method. This should not happen.");
  }
}

rclcpp::Logger HardwareComponentInterface::get_logger() const {
  return parts_->logger;
}
rclcpp::Clock::SharedPtr HardwareComponentInterface::get_clock() const {
  return parts_->clock;
}
rclcpp::Node::SharedPtr HardwareComponentInterface::get_node() const {
  const std::lock_guard<std::mutex> lock(parts_->node_mutex);
  const auto executor = parts_->executor.lock();
  if (!parts_->node && executor) {
    std::string name = to_lower_case(info_.name);
    std::replace(name.begin(), name.end(), '/', '_');
    auto options = define_custom_node_options();
    options.arguments({"--ros-args", "-r", "__node:=" + name});
    parts_->node = std::make_shared<rclcpp::Node>(name, parts_->node_namespace, options);
    executor->add_node(parts_->node->get_node_base_interface());
  }
  return parts_->node;
}
const HardwareInfo& HardwareComponentInterface::get_hardware_info() const {
  return info_;
}

namespace detail {

void LoanCounts::report(const char* kind, const Handle& handle, const char* calls) const {
  if (failed == 0 && timeouts == 0) {
    return;
  }
  const double percent = 100.0 / total;
  RCLCPP_WARN(rclcpp::get_logger(handle.get_name()),
              "%s %s has %u (%.4f %%) timeouts and %u (%.4f %%) missed calls out of %u %s calls",
              kind, handle.get_name().c_str(), timeouts, timeouts * percent, failed,
              failed * percent, total, calls);
}

}  // namespace detail
}  // namespace hardware_interface
