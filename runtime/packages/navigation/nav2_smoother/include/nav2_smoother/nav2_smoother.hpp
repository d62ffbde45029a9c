// Smooths paths by the smoother plugins that its parameters name.
#pragma once

#include <memory>
#include <string>
#include <unordered_map>
#include <vector>

#include "nav2_core/smoother.hpp"
#include "nav2_costmap_2d/costmap_subscriber.hpp"
#include "nav2_costmap_2d/costmap_topic_collision_checker.hpp"
#include "nav2_costmap_2d/footprint_subscriber.hpp"
#include "nav2_msgs/action/smooth_path.hpp"
#include "nav2_util/lifecycle_node.hpp"
#include "nav2_util/simple_action_server.hpp"
#include "nav_msgs/msg/path.hpp"
#include "pluginlib/class_loader.hpp"
#include "tf2_ros/buffer.h"
#include "tf2_ros/transform_listener.h"

namespace nav2_smoother {

class SmootherServer : public nav2_util::LifecycleNode {
 public:
  using SmootherMap = std::unordered_map<std::string, nav2_core::Smoother::Ptr>;

  explicit SmootherServer(const rclcpp::NodeOptions& options = rclcpp::NodeOptions());
  ~SmootherServer();

 protected:
  using Action = nav2_msgs::action::SmoothPath;
  using ActionResult = Action::Result;
  using ActionServer = nav2_util::SimpleActionServer<Action>;

  nav2_util::CallbackReturn on_configure(const rclcpp_lifecycle::State& state) override;
  nav2_util::CallbackReturn on_activate(const rclcpp_lifecycle::State& state) override;
  nav2_util::CallbackReturn on_deactivate(const rclcpp_lifecycle::State& state) override;
  nav2_util::CallbackReturn on_cleanup(const rclcpp_lifecycle::State& state) override;
  nav2_util::CallbackReturn on_shutdown(const rclcpp_lifecycle::State& state) override;

  bool loadSmootherPlugins();
  /// Answers the current goal.
  void smoothPlan();
  /// Without a name: the only smoother. False: logged.
  bool findSmootherId(const std::string& c_name, std::string& name);
  /// False: the path is empty, or has numbers that are not finite; logged.
  bool validate(const nav_msgs::msg::Path& path);

  std::unique_ptr<ActionServer> action_server_;
  std::shared_ptr<tf2_ros::Buffer> tf_;
  std::shared_ptr<tf2_ros::TransformListener> transform_listener_;
  rclcpp_lifecycle::LifecyclePublisher<nav_msgs::msg::Path>::SharedPtr plan_publisher_;
  // Declared before the smoothers, since it owns their code.
  pluginlib::ClassLoader<nav2_core::Smoother> lp_loader_;
  SmootherMap smoothers_;
  std::vector<std::string> default_ids_{"simple_smoother"};
  std::vector<std::string> default_types_{"nav2_smoother::SimpleSmoother"};
  std::vector<std::string> smoother_ids_;
  std::string smoother_ids_concat_;
  std::string current_smoother_;
  std::shared_ptr<nav2_costmap_2d::CostmapSubscriber> costmap_sub_;
  std::shared_ptr<nav2_costmap_2d::FootprintSubscriber> footprint_sub_;
  std::shared_ptr<nav2_costmap_2d::CostmapTopicCollisionChecker> collision_checker_;

 private:
  void subscribe();
  /// The path of the goal, smoothed. Throws a SmootherException, or what the plugin throws.
  void smoothGoal(const Action::Goal& goal, ActionResult& result);
  void checkCollisions(const nav_msgs::msg::Path& path);
};

}  // namespace nav2_smoother
