// See waypoint_follower.hpp. The states of the server; the work is in tour.cpp.
#include "nav2_waypoint_follower/waypoint_follower.hpp"

#include <algorithm>
#include <chrono>

#include "rclcpp_components/register_node_macro.hpp"

namespace nav2_waypoint_follower {

using nav2_util::CallbackReturn;
using nav2_util::declare_parameter_if_not_declared;

namespace {

constexpr char kBadRate[] = "loop_rate must be from 1 to 1000 Hz";

bool is_rate(int64_t value) {
  return value >= 1 && value <= 1000;
}

}  // namespace

WaypointFollower::WaypointFollower(const rclcpp::NodeOptions& options)
    : nav2_util::LifecycleNode("waypoint_follower", "", options),
      waypoint_task_executor_loader_("nav2_waypoint_follower", "nav2_core::WaypointTaskExecutor") {
  RCLCPP_INFO(get_logger(), "Creating");
  declare_parameter("stop_on_failure", true);
  declare_parameter("loop_rate", 20);
  declare_parameter("action_server_result_timeout", 900.0);
  declare_parameter("global_frame_id", "map");
  declare_parameter_if_not_declared(this, "waypoint_task_executor_plugin",
                                    rclcpp::ParameterValue("wait_at_waypoint"));
  declare_parameter_if_not_declared(
      this, "wait_at_waypoint.plugin",
      rclcpp::ParameterValue("nav2_waypoint_follower::WaitAtWaypoint"));
}

WaypointFollower::~WaypointFollower() = default;

CallbackReturn WaypointFollower::on_configure(const rclcpp_lifecycle::State& state) {
  RCLCPP_INFO(get_logger(), "Configuring");
  const auto node = shared_from_this();
  stop_on_failure_ = get_parameter("stop_on_failure").as_bool();
  const int64_t rate = get_parameter("loop_rate").as_int();
  if (!is_rate(rate)) {
    RCLCPP_FATAL(get_logger(), "%s", kBadRate);
    return CallbackReturn::FAILURE;
  }
  loop_rate_ = static_cast<int>(rate);
  global_frame_id_ = nav2_util::strip_leading_slash(get_parameter("global_frame_id").as_string());
  callback_group_ = create_callback_group(rclcpp::CallbackGroupType::MutuallyExclusive, false);
  callback_group_executor_.add_callback_group(callback_group_, get_node_base_interface());
  nav_to_pose_client_ = rclcpp_action::create_client<ClientT>(
      get_node_base_interface(), get_node_graph_interface(), get_node_logging_interface(),
      get_node_waitables_interface(), "navigate_to_pose", callback_group_);

  rcl_action_server_options_t options = rcl_action_server_get_default_options();
  options.result_timeout.nanoseconds =
      RCL_S_TO_NS(get_parameter("action_server_result_timeout").as_double());
  const std::chrono::milliseconds timeout(500);
  xyz_action_server_ = std::make_unique<ActionServer>(
      node, "follow_waypoints", [this] { followWaypointsCallback(); }, nullptr, timeout, false,
      options);
  from_ll_to_map_client_ =
      std::make_unique<nav2_util::ServiceClient<robot_localization::srv::FromLL,
                                                std::shared_ptr<nav2_util::LifecycleNode>>>(
          "/fromLL", node);
  gps_action_server_ = std::make_unique<ActionServerGPS>(
      node, "follow_gps_waypoints", [this] { followGPSWaypointsCallback(); }, nullptr, timeout,
      false, options);
  if (loadTask()) return CallbackReturn::SUCCESS;
  on_cleanup(state);
  return CallbackReturn::FAILURE;
}

bool WaypointFollower::loadTask() {
  waypoint_task_executor_id_ = get_parameter("waypoint_task_executor_plugin").as_string();
  try {
    waypoint_task_executor_type_ =
        nav2_util::get_plugin_type_param(this, waypoint_task_executor_id_);
    waypoint_task_executor_ =
        waypoint_task_executor_loader_.createUniqueInstance(waypoint_task_executor_type_);
    RCLCPP_INFO(get_logger(), "Created waypoint_task_executor : %s of type %s",
                waypoint_task_executor_id_.c_str(), waypoint_task_executor_type_.c_str());
    waypoint_task_executor_->initialize(shared_from_this(), waypoint_task_executor_id_);
  } catch (const std::exception& error) {
    RCLCPP_FATAL(get_logger(), "Failed to create waypoint_task_executor. Exception: %s",
                 error.what());
    return false;
  }
  return true;
}

CallbackReturn WaypointFollower::on_activate(const rclcpp_lifecycle::State&) {
  RCLCPP_INFO(get_logger(), "Activating");
  xyz_action_server_->activate();
  gps_action_server_->activate();
  dyn_params_handler_ =
      add_on_set_parameters_callback([this](std::vector<rclcpp::Parameter> parameters) {
        return dynamicParametersCallback(std::move(parameters));
      });
  createBond();
  return CallbackReturn::SUCCESS;
}

CallbackReturn WaypointFollower::on_deactivate(const rclcpp_lifecycle::State&) {
  RCLCPP_INFO(get_logger(), "Deactivating");
  xyz_action_server_->deactivate();
  gps_action_server_->deactivate();
  dyn_params_handler_.reset();
  destroyBond();
  return CallbackReturn::SUCCESS;
}

CallbackReturn WaypointFollower::on_cleanup(const rclcpp_lifecycle::State&) {
  RCLCPP_INFO(get_logger(), "Cleaning up");
  xyz_action_server_.reset();
  gps_action_server_.reset();
  nav_to_pose_client_.reset();
  from_ll_to_map_client_.reset();
  waypoint_task_executor_.reset();
  if (callback_group_) callback_group_executor_.remove_callback_group(callback_group_);
  callback_group_.reset();
  return CallbackReturn::SUCCESS;
}

CallbackReturn WaypointFollower::on_shutdown(const rclcpp_lifecycle::State&) {
  RCLCPP_INFO(get_logger(), "Shutting down");
  return CallbackReturn::SUCCESS;
}

rcl_interfaces::msg::SetParametersResult WaypointFollower::dynamicParametersCallback(
    std::vector<rclcpp::Parameter> parameters) {
  rcl_interfaces::msg::SetParametersResult result;
  result.successful =
      std::all_of(parameters.begin(), parameters.end(), [](const rclcpp::Parameter& parameter) {
        return parameter.get_name() != "loop_rate" || is_rate(parameter.as_int());
      });
  if (!result.successful) {
    result.reason = kBadRate;
    return result;
  }
  for (const rclcpp::Parameter& parameter : parameters) {
    const std::string& name = parameter.get_name();
    if (name == "stop_on_failure") stop_on_failure_ = parameter.as_bool();
    if (name == "loop_rate") loop_rate_ = static_cast<int>(parameter.as_int());
  }
  return result;
}

}  // namespace nav2_waypoint_follower

RCLCPP_COMPONENTS_REGISTER_NODE(nav2_waypoint_follower::WaypointFollower)
