// See bt_navigator.hpp.
#include "nav2_bt_navigator/bt_navigator.hpp"

#include <algorithm>
#include <utility>

#include "lifecycle_msgs/msg/state.hpp"
#include "nav2_behavior_tree/plugins_list.hpp"
#include "nav2_util/node_utils.hpp"
#include "nav2_util/string_utils.hpp"
#include "rclcpp_components/register_node_macro.hpp"
#include "tf2_ros/create_timer_ros.h"

namespace nav2_bt_navigator {

using nav2_util::CallbackReturn;
using nav2_util::declare_parameter_if_not_declared;
using rclcpp::ParameterValue;

BtNavigator::BtNavigator(rclcpp::NodeOptions options)
    : nav2_util::LifecycleNode("bt_navigator", "",
                               options.automatically_declare_parameters_from_overrides(true)),
      class_loader_("nav2_core", "nav2_core::NavigatorBase") {
  RCLCPP_INFO(get_logger(), "Creating");
  const auto declare = [this](const char* name, ParameterValue value) {
    declare_parameter_if_not_declared(this, name, value);
  };
  declare("plugin_lib_names", ParameterValue(std::vector<std::string>{}));
  declare("transform_tolerance", ParameterValue(0.1));
  declare("global_frame", ParameterValue(std::string("map")));
  declare("robot_base_frame", ParameterValue(std::string("base_link")));
  declare("odom_topic", ParameterValue(std::string("odom")));
}

BtNavigator::~BtNavigator() {
  if (get_current_state().id() != lifecycle_msgs::msg::State::PRIMARY_STATE_ACTIVE) return;
  for (const auto& navigator : navigators_) navigator->on_deactivate();
}

CallbackReturn BtNavigator::on_configure(const rclcpp_lifecycle::State& state) {
  RCLCPP_INFO(get_logger(), "Configuring");
  tf_ = std::make_shared<tf2_ros::Buffer>(get_clock());
  tf_->setCreateTimerInterface(std::make_shared<tf2_ros::CreateTimerROS>(
      get_node_base_interface(), get_node_timers_interface()));
  tf_->setUsingDedicatedThread(true);
  tf_listener_ = std::make_shared<tf2_ros::TransformListener>(*tf_, this, true);
  odom_smoother_ = std::make_shared<nav2_util::OdomSmoother>(
      shared_from_this(), 0.3, get_parameter("odom_topic").as_string());

  auto libraries = nav2_util::split(nav2::details::BT_BUILTIN_PLUGINS, ';');
  const auto more = get_parameter("plugin_lib_names").as_string_array();
  libraries.insert(libraries.end(), more.begin(), more.end());
  nav2_core::FeedbackUtils feedback;
  feedback.robot_frame = get_parameter("robot_base_frame").as_string();
  feedback.global_frame = get_parameter("global_frame").as_string();
  feedback.transform_tolerance = get_parameter("transform_tolerance").as_double();
  feedback.tf = tf_;
  for (const std::string& id : navigator_ids()) {
    try {
      if (add_navigator(id, libraries, feedback)) continue;
    } catch (const std::exception& error) {
      RCLCPP_FATAL(get_logger(), "Failed to create navigator id %s. Exception: %s", id.c_str(),
                   error.what());
    }
    on_cleanup(state);
    return CallbackReturn::FAILURE;
  }
  return CallbackReturn::SUCCESS;
}

std::vector<std::string> BtNavigator::navigator_ids() {
  const std::vector<std::string> defaults = {"navigate_to_pose", "navigate_through_poses"};
  declare_parameter_if_not_declared(this, "navigators", ParameterValue(defaults));
  const auto ids = get_parameter("navigators").as_string_array();
  if (ids == defaults) {
    const auto declare = [this](const std::string& id, const char* type) {
      declare_parameter_if_not_declared(this, id + ".plugin", ParameterValue(std::string(type)));
    };
    declare(ids[0], "nav2_bt_navigator::NavigateToPoseNavigator");
    declare(ids[1], "nav2_bt_navigator::NavigateThroughPosesNavigator");
  }
  return ids;
}

bool BtNavigator::add_navigator(const std::string& id, const std::vector<std::string>& libraries,
                                const nav2_core::FeedbackUtils& feedback) {
  const std::string type = nav2_util::get_plugin_type_param(shared_from_this(), id);
  RCLCPP_INFO(get_logger(), "Creating navigator id %s of type %s", id.c_str(), type.c_str());
  navigators_.push_back(class_loader_.createUniqueInstance(type));
  return navigators_.back()->on_configure(shared_from_this(), libraries, feedback, &plugin_muxer_,
                                          odom_smoother_);
}

CallbackReturn BtNavigator::on_activate(const rclcpp_lifecycle::State& state) {
  RCLCPP_INFO(get_logger(), "Activating");
  for (const auto& navigator : navigators_) {
    if (navigator->on_activate()) continue;
    on_deactivate(state);
    return CallbackReturn::FAILURE;
  }
  createBond();
  return CallbackReturn::SUCCESS;
}

CallbackReturn BtNavigator::on_deactivate(const rclcpp_lifecycle::State& /*state*/) {
  RCLCPP_INFO(get_logger(), "Deactivating");
  for (const auto& navigator : navigators_) {
    if (!navigator->on_deactivate()) return CallbackReturn::FAILURE;
  }
  destroyBond();
  return CallbackReturn::SUCCESS;
}

CallbackReturn BtNavigator::on_cleanup(const rclcpp_lifecycle::State& /*state*/) {
  RCLCPP_INFO(get_logger(), "Cleaning up");
  tf_listener_.reset();
  const bool is_clean = std::all_of(navigators_.begin(), navigators_.end(),
                                    [](const auto& navigator) { return navigator->on_cleanup(); });
  if (!is_clean) return CallbackReturn::FAILURE;
  navigators_.clear();
  tf_.reset();
  odom_smoother_.reset();
  RCLCPP_INFO(get_logger(), "Completed Cleaning up");
  return CallbackReturn::SUCCESS;
}

CallbackReturn BtNavigator::on_shutdown(const rclcpp_lifecycle::State& /*state*/) {
  RCLCPP_INFO(get_logger(), "Shutting down");
  return CallbackReturn::SUCCESS;
}

}  // namespace nav2_bt_navigator

RCLCPP_COMPONENTS_REGISTER_NODE(nav2_bt_navigator::BtNavigator)
