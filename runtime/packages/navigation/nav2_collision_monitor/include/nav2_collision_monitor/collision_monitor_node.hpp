// Passes velocities on, and slows or stops the robot when its sensors see an obstacle in a zone.
#pragma once

#include <memory>
#include <string>

#include "geometry_msgs/msg/twist.hpp"
#include "geometry_msgs/msg/twist_stamped.hpp"
#include "nav2_collision_monitor/polygon.hpp"
#include "nav2_collision_monitor/types.hpp"
#include "nav2_collision_monitor/zones.hpp"
#include "nav2_msgs/msg/collision_monitor_state.hpp"
#include "nav2_msgs/srv/toggle.hpp"
#include "nav2_util/lifecycle_node.hpp"
#include "nav2_util/twist_publisher.hpp"
#include "nav2_util/twist_subscriber.hpp"
#include "rclcpp/rclcpp.hpp"
#include "visualization_msgs/msg/marker_array.hpp"

namespace nav2_collision_monitor {

/// Works when a velocity comes; without one it sleeps.
class CollisionMonitor : public nav2_util::LifecycleNode {
 public:
  explicit CollisionMonitor(const rclcpp::NodeOptions& options = rclcpp::NodeOptions());
  ~CollisionMonitor();

 protected:
  using MarkerArray = visualization_msgs::msg::MarkerArray;
  using State = nav2_msgs::msg::CollisionMonitorState;
  using Toggle = nav2_msgs::srv::Toggle;

  nav2_util::CallbackReturn on_configure(const rclcpp_lifecycle::State& state) override;
  nav2_util::CallbackReturn on_activate(const rclcpp_lifecycle::State& state) override;
  nav2_util::CallbackReturn on_deactivate(const rclcpp_lifecycle::State& state) override;
  nav2_util::CallbackReturn on_cleanup(const rclcpp_lifecycle::State& state) override;
  nav2_util::CallbackReturn on_shutdown(const rclcpp_lifecycle::State& state) override;

  void cmdVelInCallbackStamped(geometry_msgs::msg::TwistStamped::SharedPtr msg);
  void cmdVelInCallbackUnstamped(geometry_msgs::msg::Twist::SharedPtr msg);
  void process(const Velocity& cmd_vel_in, const std_msgs::msg::Header& header);
  /// True: the action is that of this zone now.
  bool processStopSlowdownLimit(const std::shared_ptr<Polygon> polygon,
                                const SourcePoints& sources_collision_points_map,
                                const Velocity& velocity, Action& robot_action) const;
  bool processApproach(const std::shared_ptr<Polygon> polygon,
                       const SourcePoints& sources_collision_points_map, const Velocity& velocity,
                       Action& robot_action) const;
  void notifyActionState(const Action& robot_action,
                         const std::shared_ptr<Polygon> action_polygon) const;
  /// Nothing more once the robot has stood for `stop_pub_timeout`.
  void publishVelocity(const Action& robot_action, const std_msgs::msg::Header& header);

  Zones zones_;
  std::unique_ptr<nav2_util::TwistSubscriber> cmd_vel_in_sub_;
  std::unique_ptr<nav2_util::TwistPublisher> cmd_vel_out_pub_;
  rclcpp_lifecycle::LifecyclePublisher<State>::SharedPtr state_pub_;
  rclcpp_lifecycle::LifecyclePublisher<MarkerArray>::SharedPtr collision_points_marker_pub_;
  rclcpp::Service<Toggle>::SharedPtr toggle_cm_service_;
  bool enabled_ = true;
  bool process_active_ = false;
  Action robot_action_prev_;
  rclcpp::Time stop_stamp_;
  rclcpp::Duration stop_pub_timeout_{1, 0};

 private:
  bool getParameters(std::string& in_topic, std::string& out_topic, std::string& state_topic);
  void createTopics(const std::string& in_topic, const std::string& out_topic,
                    const std::string& state_topic);
  /// Returns the first source that cannot be used, or null. The sources after it are not asked.
  const Source* collectPoints(SourcePoints& points);
  void publishPoints(const SourcePoints& points);
  std::shared_ptr<Polygon> processPolygons(const SourcePoints& points, const Velocity& velocity,
                                           Action& action) const;
  void logAction(const Action& action, const Polygon* cause) const;

  const Source* invalid_source_ = nullptr;  // of the last velocity; its name is logged once
};

}  // namespace nav2_collision_monitor
