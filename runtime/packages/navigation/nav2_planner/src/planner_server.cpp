// See planner_server.hpp. The states of the server; the work is in planning.cpp.
#include "nav2_planner/planner_server.hpp"

#include <chrono>

#include "lifecycle_msgs/msg/state.hpp"
#include "nav2_util/node_utils.hpp"
#include "rclcpp_components/register_node_macro.hpp"

namespace nav2_planner {

using nav2_util::CallbackReturn;

PlannerServer::PlannerServer(const rclcpp::NodeOptions& options)
    : nav2_util::LifecycleNode("planner_server", "", options),
      gp_loader_("nav2_core", "nav2_core::GlobalPlanner"),
      costmap_update_timeout_(rclcpp::Duration::from_seconds(1.0)) {
  RCLCPP_INFO(get_logger(), "Creating");
  const std::vector<std::string> default_ids{"GridBased"};
  declare_parameter("planner_plugins", default_ids);
  declare_parameter("expected_planner_frequency", 1.0);
  declare_parameter("action_server_result_timeout", 10.0);
  declare_parameter("costmap_update_timeout", 1.0);
  get_parameter("planner_plugins", planner_ids_);
  if (planner_ids_ == default_ids) {
    declare_parameter("GridBased.plugin", "nav2_navfn_planner::NavfnPlanner");
  }
  bool use_sim_time = false;
  get_parameter("use_sim_time", use_sim_time);
  costmap_ros_ = std::make_shared<nav2_costmap_2d::Costmap2DROS>(
      "global_costmap", std::string{get_namespace()}, "global_costmap", use_sim_time);
}

PlannerServer::~PlannerServer() {
  planners_.clear();
  costmap_thread_.reset();
}

CallbackReturn PlannerServer::on_configure(const rclcpp_lifecycle::State& state) {
  RCLCPP_INFO(get_logger(), "Configuring");
  if (costmap_ros_->configure().id() != lifecycle_msgs::msg::State::PRIMARY_STATE_INACTIVE) {
    return CallbackReturn::FAILURE;
  }
  costmap_ = costmap_ros_->getCostmap();
  if (!costmap_ros_->getUseRadius()) {
    collision_checker_ =
        std::make_unique<nav2_costmap_2d::FootprintCollisionChecker<nav2_costmap_2d::Costmap2D*>>(
            costmap_);
  }
  costmap_thread_ = std::make_unique<nav2_util::NodeThread>(costmap_ros_);
  RCLCPP_DEBUG(get_logger(), "Costmap size: %d,%d", costmap_->getSizeInCellsX(),
               costmap_->getSizeInCellsY());
  tf_ = costmap_ros_->getTfBuffer();
  if (!loadPlanners()) {
    on_cleanup(state);
    return CallbackReturn::FAILURE;
  }
  setExpectedFrequency(get_parameter("expected_planner_frequency").as_double());
  plan_publisher_ = create_publisher<nav_msgs::msg::Path>("plan", 1);
  rcl_action_server_options_t options = rcl_action_server_get_default_options();
  options.result_timeout.nanoseconds =
      RCL_S_TO_NS(get_parameter("action_server_result_timeout").as_double());
  costmap_update_timeout_ =
      rclcpp::Duration::from_seconds(get_parameter("costmap_update_timeout").as_double());
  constexpr std::chrono::milliseconds kPatience{500};
  action_server_pose_ = std::make_unique<Server<ActionToPose>>(
      shared_from_this(), "compute_path_to_pose", [this] { computePlan(); }, nullptr, kPatience,
      true, options);
  action_server_poses_ = std::make_unique<Server<ActionThroughPoses>>(
      shared_from_this(), "compute_path_through_poses", [this] { computePlanThroughPoses(); },
      nullptr, kPatience, true, options);
  return CallbackReturn::SUCCESS;
}

bool PlannerServer::loadPlanners() {
  planner_ids_concat_.clear();
  for (const std::string& id : planner_ids_) {
    try {
      const std::string type = nav2_util::get_plugin_type_param(this, id);
      nav2_core::GlobalPlanner::Ptr planner = gp_loader_.createUniqueInstance(type);
      RCLCPP_INFO(get_logger(), "Created global planner plugin %s of type %s", id.c_str(),
                  type.c_str());
      planner->configure(shared_from_this(), id, tf_, costmap_ros_);
      planners_.insert({id, planner});
    } catch (const std::exception& error) {
      RCLCPP_FATAL(get_logger(), "Failed to create global planner. Exception: %s", error.what());
      return false;
    }
    planner_ids_concat_ += id + " ";
  }
  RCLCPP_INFO(get_logger(), "Planner Server has %s planners available.",
              planner_ids_concat_.c_str());
  return true;
}

void PlannerServer::setExpectedFrequency(double frequency) {
  max_planner_duration_ = frequency > 0 ? 1 / frequency : 0.0;
  if (frequency > 0) return;
  RCLCPP_WARN(get_logger(),
              "The expected planner frequency parameter is %.4f Hz. The value should to be greater "
              "than 0.0 to turn on duration overrrun warning messages",
              frequency);
}

CallbackReturn PlannerServer::on_activate(const rclcpp_lifecycle::State&) {
  RCLCPP_INFO(get_logger(), "Activating");
  plan_publisher_->on_activate();
  action_server_pose_->activate();
  action_server_poses_->activate();
  if (costmap_ros_->activate().id() != lifecycle_msgs::msg::State::PRIMARY_STATE_ACTIVE) {
    return CallbackReturn::FAILURE;
  }
  for (const auto& [id, planner] : planners_) planner->activate();
  using Service = nav2_msgs::srv::IsPathValid;
  is_path_valid_service_ = create_service<Service>(
      "is_path_valid",
      [this](const Service::Request::SharedPtr request, Service::Response::SharedPtr response) {
        isPathValid(request, response);
      });
  dyn_params_handler_ =
      add_on_set_parameters_callback([this](std::vector<rclcpp::Parameter> parameters) {
        return dynamicParametersCallback(parameters);
      });
  createBond();
  return CallbackReturn::SUCCESS;
}

CallbackReturn PlannerServer::on_deactivate(const rclcpp_lifecycle::State&) {
  RCLCPP_INFO(get_logger(), "Deactivating");
  action_server_pose_->deactivate();
  action_server_poses_->deactivate();
  plan_publisher_->on_deactivate();
  costmap_ros_->deactivate();
  for (const auto& [id, planner] : planners_) planner->deactivate();
  is_path_valid_service_.reset();
  dyn_params_handler_.reset();
  destroyBond();
  return CallbackReturn::SUCCESS;
}

CallbackReturn PlannerServer::on_cleanup(const rclcpp_lifecycle::State&) {
  RCLCPP_INFO(get_logger(), "Cleaning up");
  action_server_pose_.reset();
  action_server_poses_.reset();
  plan_publisher_.reset();
  for (const auto& [id, planner] : planners_) planner->cleanup();
  planners_.clear();
  tf_.reset();
  collision_checker_.reset();
  // Its callbacks use the layers.
  costmap_thread_.reset();
  costmap_ros_->cleanup();
  costmap_ = nullptr;
  return CallbackReturn::SUCCESS;
}

CallbackReturn PlannerServer::on_shutdown(const rclcpp_lifecycle::State&) {
  RCLCPP_INFO(get_logger(), "Shutting down");
  return CallbackReturn::SUCCESS;
}

rcl_interfaces::msg::SetParametersResult PlannerServer::dynamicParametersCallback(
    std::vector<rclcpp::Parameter> parameters) {
  rcl_interfaces::msg::SetParametersResult result;
  result.successful = true;
  for (const rclcpp::Parameter& parameter : parameters) {
    if (parameter.get_name() == "expected_planner_frequency" &&
        parameter.get_type() == rclcpp::ParameterType::PARAMETER_DOUBLE) {
      setExpectedFrequency(parameter.as_double());
    }
  }
  return result;
}

}  // namespace nav2_planner

RCLCPP_COMPONENTS_REGISTER_NODE(nav2_planner::PlannerServer)
