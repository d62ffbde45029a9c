// See controller_server.hpp. The states of the server; the work is in control_loop.cpp.
#include "nav2_controller/controller_server.hpp"

#include <chrono>
#include <cmath>

#include "lifecycle_msgs/msg/state.hpp"
#include "nav2_util/node_utils.hpp"
#include "rclcpp_components/register_node_macro.hpp"

namespace nav2_controller {

using nav2_util::CallbackReturn;
using nav2_util::declare_parameter_if_not_declared;

namespace {

struct DefaultPlugin {
  const char* parameter;
  const char* name;
  const char* type;
};
constexpr DefaultPlugin kDefaults[] = {
    {"progress_checker_plugins", "progress_checker", "nav2_controller::SimpleProgressChecker"},
    {"goal_checker_plugins", "goal_checker", "nav2_controller::SimpleGoalChecker"},
    {"controller_plugins", "FollowPath", "dwb_core::DWBLocalPlanner"},
};

}  // namespace

ControllerServer::ControllerServer(const rclcpp::NodeOptions& options)
    : nav2_util::LifecycleNode("controller_server", "", options),
      progress_checkers_("progress checker", "nav2_core::ProgressChecker"),
      goal_checkers_("goal checker", "nav2_core::GoalChecker"),
      controllers_("controller", "nav2_core::Controller"),
      costmap_update_timeout_(std::chrono::milliseconds(300)) {
  RCLCPP_INFO(get_logger(), "Creating controller server");
  declare_parameter("controller_frequency", 20.0);
  declare_parameter("action_server_result_timeout", 10.0);
  for (const DefaultPlugin& one : kDefaults) {
    declare_parameter(one.parameter, std::vector<std::string>{one.name});
  }
  declare_parameter("min_x_velocity_threshold", 0.0001);
  declare_parameter("min_y_velocity_threshold", 0.0001);
  declare_parameter("min_theta_velocity_threshold", 0.0001);
  declare_parameter("speed_limit_topic", "speed_limit");
  declare_parameter("failure_tolerance", 0.0);
  declare_parameter("use_realtime_priority", false);
  declare_parameter("publish_zero_velocity", true);
  declare_parameter("costmap_update_timeout", 0.30);
  bool use_sim_time = false;
  get_parameter("use_sim_time", use_sim_time);
  costmap_ros_ = std::make_shared<nav2_costmap_2d::Costmap2DROS>(
      "local_costmap", std::string{get_namespace()}, "local_costmap", use_sim_time);
}

ControllerServer::~ControllerServer() {
  progress_checkers_.loaded.clear();
  goal_checkers_.loaded.clear();
  controllers_.loaded.clear();
  costmap_thread_.reset();
}

void ControllerServer::declareDefaultTypes() {
  for (const DefaultPlugin& one : kDefaults) {
    if (get_parameter(one.parameter).as_string_array() != std::vector<std::string>{one.name})
      continue;
    declare_parameter_if_not_declared(this, std::string(one.name) + ".plugin",
                                      rclcpp::ParameterValue(one.type));
  }
}

template <typename BaseT, typename PrepareT>
bool ControllerServer::load(Plugins<BaseT>& plugins, const std::string& parameter,
                            PrepareT prepare) {
  plugins.names.clear();
  const char* kind = plugins.kind.c_str();
  const std::vector<std::string> ids = get_parameter(parameter).as_string_array();
  for (const std::string& id : ids) {
    try {
      const std::string type = nav2_util::get_plugin_type_param(this, id);
      std::shared_ptr<BaseT> plugin = plugins.loader.createUniqueInstance(type);
      RCLCPP_INFO(get_logger(), "Created %s : %s of type %s", kind, id.c_str(), type.c_str());
      prepare(*plugin, id);
      plugins.loaded.insert({id, plugin});
    } catch (const std::exception& error) {
      RCLCPP_FATAL(get_logger(), "Failed to create %s. Exception: %s", kind, error.what());
      return false;
    }
    plugins.names += id + " ";
  }
  if (plugins.names.empty()) plugins.names = "(none)";
  RCLCPP_INFO(get_logger(), "Controller Server has %s %ss available.", plugins.names.c_str(), kind);
  return true;
}

CallbackReturn ControllerServer::on_configure(const rclcpp_lifecycle::State& state) {
  RCLCPP_INFO(get_logger(), "Configuring controller interface");
  RCLCPP_INFO(get_logger(), "getting progress checker plugins..");
  RCLCPP_INFO(get_logger(), "getting goal checker plugins..");
  declareDefaultTypes();
  get_parameter("controller_frequency", controller_frequency_);
  get_parameter("min_x_velocity_threshold", min_x_velocity_threshold_);
  get_parameter("min_y_velocity_threshold", min_y_velocity_threshold_);
  get_parameter("min_theta_velocity_threshold", min_theta_velocity_threshold_);
  get_parameter("failure_tolerance", failure_tolerance_);
  RCLCPP_INFO(get_logger(), "Controller frequency set to %.4fHz", controller_frequency_);
  if (!(controller_frequency_ > 0)) {
    RCLCPP_FATAL(get_logger(), "controller_frequency must be greater than 0");
    return CallbackReturn::FAILURE;
  }
  costmap_update_timeout_ =
      rclcpp::Duration::from_seconds(get_parameter("costmap_update_timeout").as_double());
  if (costmap_ros_->configure().id() != lifecycle_msgs::msg::State::PRIMARY_STATE_INACTIVE) {
    return CallbackReturn::FAILURE;
  }
  costmap_thread_ = std::make_unique<nav2_util::NodeThread>(costmap_ros_);

  const auto node = shared_from_this();
  const bool is_loaded =
      load(progress_checkers_, "progress_checker_plugins",
           [&](nav2_core::ProgressChecker& checker, const std::string& id) {
             checker.initialize(node, id);
           }) &&
      load(goal_checkers_, "goal_checker_plugins",
           [&](nav2_core::GoalChecker& checker, const std::string& id) {
             checker.initialize(node, id, costmap_ros_);
           }) &&
      load(controllers_, "controller_plugins",
           [&](nav2_core::Controller& controller, const std::string& id) {
             controller.configure(node, id, costmap_ros_->getTfBuffer(), costmap_ros_);
           });
  if (!is_loaded) {
    on_cleanup(state);
    return CallbackReturn::FAILURE;
  }

  declare_parameter_if_not_declared(this, "odom_topic", rclcpp::ParameterValue("odom"));
  odom_sub_ = create_subscription<nav_msgs::msg::Odometry>(
      get_parameter("odom_topic").as_string(), rclcpp::SystemDefaultsQoS(),
      [this](const nav_msgs::msg::Odometry& odometry) {
        const std::lock_guard<std::mutex> lock(odom_lock_);
        odom_ = odometry.twist.twist;
      });
  vel_publisher_ = std::make_unique<nav2_util::TwistPublisher>(node, "cmd_vel", 1);
  rcl_action_server_options_t options = rcl_action_server_get_default_options();
  options.result_timeout.nanoseconds =
      RCL_S_TO_NS(get_parameter("action_server_result_timeout").as_double());
  action_server_ = std::make_unique<ActionServer>(
      node, "follow_path", [this] { computeControl(); }, nullptr, std::chrono::milliseconds(500),
      true, options, get_parameter("use_realtime_priority").as_bool());
  speed_limit_sub_ = create_subscription<nav2_msgs::msg::SpeedLimit>(
      get_parameter("speed_limit_topic").as_string(), rclcpp::QoS(10),
      [this](const nav2_msgs::msg::SpeedLimit& limit) {
        for (const auto& [id, controller] : controllers_.loaded) {
          controller->setSpeedLimit(limit.speed_limit, limit.percentage);
        }
      });
  return CallbackReturn::SUCCESS;
}

CallbackReturn ControllerServer::on_activate(const rclcpp_lifecycle::State&) {
  RCLCPP_INFO(get_logger(), "Activating");
  if (costmap_ros_->activate().id() != lifecycle_msgs::msg::State::PRIMARY_STATE_ACTIVE) {
    return CallbackReturn::FAILURE;
  }
  for (const auto& [id, controller] : controllers_.loaded) controller->activate();
  vel_publisher_->on_activate();
  action_server_->activate();
  dyn_params_handler_ =
      add_on_set_parameters_callback([this](std::vector<rclcpp::Parameter> parameters) {
        return dynamicParametersCallback(parameters);
      });
  createBond();
  return CallbackReturn::SUCCESS;
}

CallbackReturn ControllerServer::on_deactivate(const rclcpp_lifecycle::State&) {
  RCLCPP_INFO(get_logger(), "Deactivating");
  action_server_->deactivate();
  for (const auto& [id, controller] : controllers_.loaded) controller->deactivate();
  costmap_ros_->deactivate();
  publishVelocity(stopped());
  vel_publisher_->on_deactivate();
  dyn_params_handler_.reset();
  destroyBond();
  return CallbackReturn::SUCCESS;
}

CallbackReturn ControllerServer::on_cleanup(const rclcpp_lifecycle::State&) {
  RCLCPP_INFO(get_logger(), "Cleaning up");
  for (const auto& [id, controller] : controllers_.loaded) controller->cleanup();
  controllers_.loaded.clear();
  goal_checkers_.loaded.clear();
  progress_checkers_.loaded.clear();
  // Its callbacks use the layers.
  costmap_thread_.reset();
  costmap_ros_->cleanup();
  action_server_.reset();
  odom_sub_.reset();
  vel_publisher_.reset();
  speed_limit_sub_.reset();
  return CallbackReturn::SUCCESS;
}

CallbackReturn ControllerServer::on_shutdown(const rclcpp_lifecycle::State&) {
  RCLCPP_INFO(get_logger(), "Shutting down");
  return CallbackReturn::SUCCESS;
}

rcl_interfaces::msg::SetParametersResult ControllerServer::dynamicParametersCallback(
    std::vector<rclcpp::Parameter> parameters) {
  rcl_interfaces::msg::SetParametersResult result;
  result.successful = true;
  for (const rclcpp::Parameter& parameter : parameters) {
    const std::string& name = parameter.get_name();
    // Those of plugins are theirs.
    if (name.find('.') != std::string::npos) continue;
    const std::unique_lock<std::mutex> lock(dynamic_params_lock_, std::try_to_lock);
    if (!lock.owns_lock()) {
      result.successful = false;
      result.reason =
          "Unable to dynamically change Parameters while the controller is currently running";
      RCLCPP_WARN(get_logger(), "%s", result.reason.c_str());
      return result;
    }
    if (parameter.get_type() != rclcpp::ParameterType::PARAMETER_DOUBLE) continue;
    const double value = parameter.as_double();
    if (name == "controller_frequency" && !(value > 0)) {
      result.successful = false;
      result.reason = "controller_frequency must be greater than 0";
      return result;
    }
    if (name == "controller_frequency") controller_frequency_ = value;
    if (name == "min_x_velocity_threshold") min_x_velocity_threshold_ = value;
    if (name == "min_y_velocity_threshold") min_y_velocity_threshold_ = value;
    if (name == "min_theta_velocity_threshold") min_theta_velocity_threshold_ = value;
    if (name == "failure_tolerance") failure_tolerance_ = value;
  }
  return result;
}

}  // namespace nav2_controller

RCLCPP_COMPONENTS_REGISTER_NODE(nav2_controller::ControllerServer)
