// See behavior_server.hpp.
#include "nav2_behaviors/behavior_server.hpp"

#include "nav2_util/node_utils.hpp"
#include "rclcpp_components/register_node_macro.hpp"

namespace behavior_server {

using nav2_core::CostmapInfoType;
using nav2_util::CallbackReturn;

BehaviorServer::BehaviorServer(const rclcpp::NodeOptions& options)
    : nav2_util::LifecycleNode("behavior_server", "", options),
      plugin_loader_("nav2_core", "nav2_core::Behavior"),
      default_ids_{"spin", "backup", "drive_on_heading", "wait"},
      default_types_{"nav2_behaviors::Spin", "nav2_behaviors::BackUp",
                     "nav2_behaviors::DriveOnHeading", "nav2_behaviors::Wait"} {
  declare_parameter("local_costmap_topic", "local_costmap/costmap_raw");
  declare_parameter("global_costmap_topic", "global_costmap/costmap_raw");
  declare_parameter("local_footprint_topic", "local_costmap/published_footprint");
  declare_parameter("global_footprint_topic", "global_costmap/published_footprint");
  declare_parameter("cycle_frequency", 10.0);
  declare_parameter("behavior_plugins", default_ids_);
  get_parameter("behavior_plugins", behavior_ids_);
  if (behavior_ids_ == default_ids_) {
    for (size_t i = 0; i < default_ids_.size(); ++i) {
      declare_parameter(default_ids_[i] + ".plugin", default_types_[i]);
    }
  }
  declare_parameter("local_frame", "odom");
  declare_parameter("global_frame", "map");
  declare_parameter("robot_base_frame", "base_link");
  declare_parameter("transform_tolerance", 0.1);
}

BehaviorServer::~BehaviorServer() {
  // Ends a goal that runs while the members that it uses exist.
  runCleanups();
  behaviors_.clear();
}

CallbackReturn BehaviorServer::on_configure(const rclcpp_lifecycle::State& state) {
  RCLCPP_INFO(get_logger(), "Configuring");
  if (!(get_parameter("cycle_frequency").as_double() > 0)) {
    RCLCPP_FATAL(get_logger(), "cycle_frequency must be greater than 0");
    return CallbackReturn::FAILURE;
  }
  tf_ = std::make_shared<tf2_ros::Buffer>(get_clock());
  tf_->setCreateTimerInterface(std::make_shared<tf2_ros::CreateTimerROS>(
      get_node_base_interface(), get_node_timers_interface()));
  transform_listener_ = std::make_shared<tf2_ros::TransformListener>(*tf_, this, true);
  if (!loadBehaviorPlugins()) {
    on_cleanup(state);
    return CallbackReturn::FAILURE;
  }
  try {
    setupResourcesForBehaviorPlugins();
    configureBehaviorPlugins();
  } catch (const std::exception& error) {
    RCLCPP_FATAL(get_logger(), "Failed to configure behaviors. Exception: %s", error.what());
    on_cleanup(state);
    return CallbackReturn::FAILURE;
  }
  return CallbackReturn::SUCCESS;
}

bool BehaviorServer::loadBehaviorPlugins() {
  behavior_types_.assign(behavior_ids_.size(), "");
  for (size_t i = 0; i < behavior_ids_.size(); ++i) {
    const std::string& id = behavior_ids_[i];
    std::string& type = behavior_types_[i];
    try {
      type = nav2_util::get_plugin_type_param(this, id);
      RCLCPP_INFO(get_logger(), "Creating behavior plugin %s of type %s", id.c_str(), type.c_str());
      behaviors_.push_back(plugin_loader_.createUniqueInstance(type));
    } catch (const std::exception& error) {
      RCLCPP_FATAL(get_logger(), "Failed to create behavior %s of type %s. Exception: %s",
                   id.c_str(), type.c_str(), error.what());
      return false;
    }
  }
  return true;
}

void BehaviorServer::configureBehaviorPlugins() {
  for (size_t i = 0; i < behaviors_.size(); ++i) {
    behaviors_[i]->configure(shared_from_this(), behavior_ids_[i], tf_, local_collision_checker_,
                             global_collision_checker_);
  }
}

void BehaviorServer::setupResourcesForBehaviorPlugins() {
  bool needs_local = false;
  bool needs_global = false;
  for (const auto& behavior : behaviors_) {
    const CostmapInfoType needed = behavior->getResourceInfo();
    needs_local |= needed == CostmapInfoType::LOCAL || needed == CostmapInfoType::BOTH;
    needs_global |= needed == CostmapInfoType::GLOBAL || needed == CostmapInfoType::BOTH;
  }
  if (needs_local) {
    subscribe("local", local_costmap_sub_, local_footprint_sub_, local_collision_checker_);
  }
  if (needs_global) {
    subscribe("global", global_costmap_sub_, global_footprint_sub_, global_collision_checker_);
  }
}

void BehaviorServer::subscribe(
    const std::string& which, std::unique_ptr<nav2_costmap_2d::CostmapSubscriber>& costmap,
    std::unique_ptr<nav2_costmap_2d::FootprintSubscriber>& footprint,
    std::shared_ptr<nav2_costmap_2d::CostmapTopicCollisionChecker>& checker) {
  const auto text = [this](const std::string& name) { return get_parameter(name).as_string(); };
  costmap = std::make_unique<nav2_costmap_2d::CostmapSubscriber>(shared_from_this(),
                                                                 text(which + "_costmap_topic"));
  footprint = std::make_unique<nav2_costmap_2d::FootprintSubscriber>(
      shared_from_this(), text(which + "_footprint_topic"), *tf_, text("robot_base_frame"),
      get_parameter("transform_tolerance").as_double());
  checker = std::make_shared<nav2_costmap_2d::CostmapTopicCollisionChecker>(*costmap, *footprint,
                                                                            get_name());
}

CallbackReturn BehaviorServer::on_activate(const rclcpp_lifecycle::State&) {
  RCLCPP_INFO(get_logger(), "Activating");
  for (const auto& behavior : behaviors_) behavior->activate();
  createBond();
  return CallbackReturn::SUCCESS;
}

CallbackReturn BehaviorServer::on_deactivate(const rclcpp_lifecycle::State&) {
  RCLCPP_INFO(get_logger(), "Deactivating");
  for (const auto& behavior : behaviors_) behavior->deactivate();
  destroyBond();
  return CallbackReturn::SUCCESS;
}

CallbackReturn BehaviorServer::on_cleanup(const rclcpp_lifecycle::State&) {
  RCLCPP_INFO(get_logger(), "Cleaning up");
  for (const auto& behavior : behaviors_) behavior->cleanup();
  behaviors_.clear();
  transform_listener_.reset();
  // A checker refers to both subscribers, and a subscriber to the buffer.
  local_collision_checker_.reset();
  global_collision_checker_.reset();
  local_costmap_sub_.reset();
  global_costmap_sub_.reset();
  local_footprint_sub_.reset();
  global_footprint_sub_.reset();
  tf_.reset();
  return CallbackReturn::SUCCESS;
}

CallbackReturn BehaviorServer::on_shutdown(const rclcpp_lifecycle::State&) {
  RCLCPP_INFO(get_logger(), "Shutting down");
  return CallbackReturn::SUCCESS;
}

}  // namespace behavior_server

RCLCPP_COMPONENTS_REGISTER_NODE(behavior_server::BehaviorServer)
