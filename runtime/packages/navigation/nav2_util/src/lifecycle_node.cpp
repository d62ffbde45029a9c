// See lifecycle_node.hpp.
#include "nav2_util/lifecycle_node.hpp"

#include <chrono>

#include "lifecycle_msgs/msg/state.hpp"
#include "nav2_util/node_utils.hpp"

namespace nav2_util {
namespace {

using lifecycle_msgs::msg::State;

/// For the end of the manager, in seconds.
constexpr double kHeartbeatTimeout = 4.0;

rcl_interfaces::msg::ParameterDescriptor descriptor_of(const std::string& name,
                                                       const std::string& description,
                                                       const std::string& constraints,
                                                       bool read_only) {
  rcl_interfaces::msg::ParameterDescriptor descriptor;
  descriptor.name = name;
  descriptor.description = description;
  descriptor.additional_constraints = constraints;
  descriptor.read_only = read_only;
  return descriptor;
}

}  // namespace

LifecycleNode::LifecycleNode(const std::string& node_name, const std::string& ns,
                             const rclcpp::NodeOptions& options)
    : rclcpp_lifecycle::LifecycleNode(node_name, ns, options) {
  // A server keeps its bonds, however long the manager is silent.
  const std::string parameter = bond::msg::Constants::DISABLE_HEARTBEAT_TIMEOUT_PARAM;
  declare_parameter(parameter, true);
  set_parameter(rclcpp::Parameter(parameter, true));
  declare_parameter_if_not_declared(this, "bond_heartbeat_period", rclcpp::ParameterValue(0.1));
  get_parameter("bond_heartbeat_period", bond_heartbeat_period);
  declare_parameter_if_not_declared(this, "autostart_node", rclcpp::ParameterValue(false));
  if (get_parameter("autostart_node").as_bool()) autostart();
  printLifecycleNodeNotification();
  register_rcl_preshutdown_callback();
}

LifecycleNode::~LifecycleNode() {
  RCLCPP_INFO(get_logger(), "Destroying");
  runCleanups();
  if (rcl_preshutdown_cb_handle_) {
    get_node_base_interface()->get_context()->remove_pre_shutdown_callback(
        *rcl_preshutdown_cb_handle_);
    rcl_preshutdown_cb_handle_.reset();
  }
}

void LifecycleNode::add_parameter(const std::string& name,
                                  const rclcpp::ParameterValue& default_value,
                                  const std::string& description,
                                  const std::string& additional_constraints, bool read_only) {
  declare_parameter(name, default_value,
                    descriptor_of(name, description, additional_constraints, read_only));
}

void LifecycleNode::add_parameter(const std::string& name,
                                  const rclcpp::ParameterValue& default_value,
                                  const floating_point_range fp_range,
                                  const std::string& description,
                                  const std::string& additional_constraints, bool read_only) {
  auto descriptor = descriptor_of(name, description, additional_constraints, read_only);
  descriptor.floating_point_range.resize(1);
  descriptor.floating_point_range[0].from_value = fp_range.from_value;
  descriptor.floating_point_range[0].to_value = fp_range.to_value;
  descriptor.floating_point_range[0].step = fp_range.step;
  declare_parameter(name, default_value, descriptor);
}

void LifecycleNode::add_parameter(const std::string& name,
                                  const rclcpp::ParameterValue& default_value,
                                  const integer_range int_range, const std::string& description,
                                  const std::string& additional_constraints, bool read_only) {
  auto descriptor = descriptor_of(name, description, additional_constraints, read_only);
  descriptor.integer_range.resize(1);
  descriptor.integer_range[0].from_value = int_range.from_value;
  descriptor.integer_range[0].to_value = int_range.to_value;
  descriptor.integer_range[0].step = int_range.step;
  declare_parameter(name, default_value, descriptor);
}

CallbackReturn LifecycleNode::on_error(const rclcpp_lifecycle::State&) {
  RCLCPP_FATAL(get_logger(), "Lifecycle node %s does not have error state implemented", get_name());
  return CallbackReturn::SUCCESS;
}

void LifecycleNode::autostart() {
  autostart_timer_ = create_wall_timer(std::chrono::seconds(0), [this] {
    autostart_timer_->cancel();
    RCLCPP_INFO(get_logger(), "Auto-starting node: %s", get_name());
    if (configure().id() != State::PRIMARY_STATE_INACTIVE) {
      RCLCPP_ERROR(get_logger(), "Auto-starting node %s failed to configure!", get_name());
      return;
    }
    if (activate().id() != State::PRIMARY_STATE_ACTIVE) {
      RCLCPP_ERROR(get_logger(), "Auto-starting node %s failed to activate!", get_name());
    }
  });
}

void LifecycleNode::on_rcl_preshutdown() {
  RCLCPP_INFO(get_logger(), "Running Nav2 LifecycleNode rcl preshutdown (%s)", get_name());
  runCleanups();
  destroyBond();
}

void LifecycleNode::createBond() {
  if (bond_heartbeat_period <= 0.0) return;
  RCLCPP_INFO(get_logger(), "Creating bond (%s) to lifecycle manager.", get_name());
  bond_ = std::make_shared<bond::Bond>("bond", get_name(), shared_from_this());
  bond_->setHeartbeatPeriod(bond_heartbeat_period);
  bond_->setHeartbeatTimeout(kHeartbeatTimeout);
  bond_->start();
}

void LifecycleNode::destroyBond() {
  if (bond_heartbeat_period <= 0.0) return;
  RCLCPP_INFO(get_logger(), "Destroying bond (%s) to lifecycle manager.", get_name());
  bond_.reset();
}

void LifecycleNode::printLifecycleNodeNotification() {
  RCLCPP_INFO(get_logger(),
              "\n\t%s lifecycle node launched. \n"
              "\tWaiting on external lifecycle transitions to activate\n"
              "\tSee https://design.ros2.org/articles/node_lifecycle.html for more information.",
              get_name());
}

void LifecycleNode::register_rcl_preshutdown_callback() {
  rcl_preshutdown_cb_handle_ = std::make_unique<rclcpp::PreShutdownCallbackHandle>(
      get_node_base_interface()->get_context()->add_pre_shutdown_callback(
          [this] { on_rcl_preshutdown(); }));
}

void LifecycleNode::runCleanups() {
  if (get_current_state().id() == State::PRIMARY_STATE_ACTIVE) deactivate();
  if (get_current_state().id() == State::PRIMARY_STATE_INACTIVE) cleanup();
}

}  // namespace nav2_util
