// See nav2_smoother.hpp. The states of the server; the work is in smoothing.cpp.
#include "nav2_smoother/nav2_smoother.hpp"

#include <chrono>

#include "nav2_util/node_utils.hpp"
#include "rclcpp_components/register_node_macro.hpp"
#include "tf2_ros/create_timer_ros.h"

namespace nav2_smoother {

using nav2_util::CallbackReturn;

SmootherServer::SmootherServer(const rclcpp::NodeOptions& options)
    : nav2_util::LifecycleNode("smoother_server", "", options),
      lp_loader_("nav2_core", "nav2_core::Smoother") {
  RCLCPP_INFO(get_logger(), "Creating smoother server");
  declare_parameter("costmap_topic", "global_costmap/costmap_raw");
  declare_parameter("footprint_topic", "global_costmap/published_footprint");
  declare_parameter("robot_base_frame", "base_link");
  declare_parameter("transform_tolerance", 0.1);
  declare_parameter("smoother_plugins", default_ids_);
  declare_parameter("action_server_result_timeout", 10.0);
}

SmootherServer::~SmootherServer() {
  // Ends a goal that runs while the smoothers that it uses exist.
  runCleanups();
  smoothers_.clear();
}

CallbackReturn SmootherServer::on_configure(const rclcpp_lifecycle::State& state) {
  RCLCPP_INFO(get_logger(), "Configuring smoother server");
  get_parameter("smoother_plugins", smoother_ids_);
  if (smoother_ids_ == default_ids_) {
    nav2_util::declare_parameter_if_not_declared(this, default_ids_[0] + ".plugin",
                                                 rclcpp::ParameterValue(default_types_[0]));
  }
  subscribe();
  if (!loadSmootherPlugins()) {
    on_cleanup(state);
    return CallbackReturn::FAILURE;
  }
  plan_publisher_ = create_publisher<nav_msgs::msg::Path>("plan_smoothed", 1);
  rcl_action_server_options_t options = rcl_action_server_get_default_options();
  options.result_timeout.nanoseconds =
      RCL_S_TO_NS(get_parameter("action_server_result_timeout").as_double());
  action_server_ = std::make_unique<ActionServer>(
      shared_from_this(), "smooth_path", [this] { smoothPlan(); }, nullptr,
      std::chrono::milliseconds(500), true, options);
  return CallbackReturn::SUCCESS;
}

void SmootherServer::subscribe() {
  tf_ = std::make_shared<tf2_ros::Buffer>(get_clock());
  tf_->setCreateTimerInterface(std::make_shared<tf2_ros::CreateTimerROS>(
      get_node_base_interface(), get_node_timers_interface()));
  transform_listener_ = std::make_shared<tf2_ros::TransformListener>(*tf_, this, true);
  const nav2_util::LifecycleNode::WeakPtr node(shared_from_this());
  costmap_sub_ = std::make_shared<nav2_costmap_2d::CostmapSubscriber>(
      node, get_parameter("costmap_topic").as_string());
  footprint_sub_ = std::make_shared<nav2_costmap_2d::FootprintSubscriber>(
      node, get_parameter("footprint_topic").as_string(), *tf_,
      get_parameter("robot_base_frame").as_string(),
      get_parameter("transform_tolerance").as_double());
  collision_checker_ = std::make_shared<nav2_costmap_2d::CostmapTopicCollisionChecker>(
      *costmap_sub_, *footprint_sub_, get_name());
}

bool SmootherServer::loadSmootherPlugins() {
  smoother_ids_concat_.clear();
  for (const std::string& id : smoother_ids_) {
    try {
      const std::string type = nav2_util::get_plugin_type_param(this, id);
      nav2_core::Smoother::Ptr smoother = lp_loader_.createUniqueInstance(type);
      RCLCPP_INFO(get_logger(), "Created smoother : %s of type %s", id.c_str(), type.c_str());
      smoother->configure(shared_from_this(), id, tf_, costmap_sub_, footprint_sub_);
      smoothers_.insert({id, smoother});
    } catch (const std::exception& error) {
      RCLCPP_FATAL(get_logger(), "Failed to create smoother. Exception: %s", error.what());
      return false;
    }
    smoother_ids_concat_ += id + " ";
  }
  RCLCPP_INFO(get_logger(), "Smoother Server has %s smoothers available.",
              smoother_ids_concat_.c_str());
  return true;
}

CallbackReturn SmootherServer::on_activate(const rclcpp_lifecycle::State&) {
  RCLCPP_INFO(get_logger(), "Activating");
  plan_publisher_->on_activate();
  for (const auto& [id, smoother] : smoothers_) smoother->activate();
  action_server_->activate();
  createBond();
  return CallbackReturn::SUCCESS;
}

CallbackReturn SmootherServer::on_deactivate(const rclcpp_lifecycle::State&) {
  RCLCPP_INFO(get_logger(), "Deactivating");
  action_server_->deactivate();
  for (const auto& [id, smoother] : smoothers_) smoother->deactivate();
  plan_publisher_->on_deactivate();
  destroyBond();
  return CallbackReturn::SUCCESS;
}

CallbackReturn SmootherServer::on_cleanup(const rclcpp_lifecycle::State&) {
  RCLCPP_INFO(get_logger(), "Cleaning up");
  for (const auto& [id, smoother] : smoothers_) smoother->cleanup();
  smoothers_.clear();
  action_server_.reset();
  plan_publisher_.reset();
  collision_checker_.reset();
  footprint_sub_.reset();
  costmap_sub_.reset();
  transform_listener_.reset();
  tf_.reset();
  return CallbackReturn::SUCCESS;
}

CallbackReturn SmootherServer::on_shutdown(const rclcpp_lifecycle::State&) {
  RCLCPP_INFO(get_logger(), "Shutting down");
  return CallbackReturn::SUCCESS;
}

}  // namespace nav2_smoother

RCLCPP_COMPONENTS_REGISTER_NODE(nav2_smoother::SmootherServer)
