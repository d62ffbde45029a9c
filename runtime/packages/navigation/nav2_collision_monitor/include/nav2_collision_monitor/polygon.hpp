// A zone around the robot, or its footprint: obstacles in it cause an action.
#pragma once

#include <memory>
#include <string>
#include <unordered_map>
#include <vector>

#include "geometry_msgs/msg/polygon_stamped.hpp"
#include "nav2_collision_monitor/types.hpp"
#include "nav2_costmap_2d/footprint_subscriber.hpp"
#include "nav2_util/lifecycle_node.hpp"
#include "rclcpp/rclcpp.hpp"
#include "tf2/time.h"
#include "tf2_ros/buffer.h"

namespace nav2_collision_monitor {

/// Obstacles in the frame of the robot, by the name of their source.
using SourcePoints = std::unordered_map<std::string, std::vector<Point>>;

class Polygon {
 public:
  Polygon(const nav2_util::LifecycleNode::WeakPtr& node, const std::string& polygon_name,
          const std::shared_ptr<tf2_ros::Buffer> tf_buffer, const std::string& base_frame_id,
          const tf2::Duration& transform_tolerance);
  virtual ~Polygon();

  /// False: a parameter cannot be used, which is logged.
  bool configure();
  void activate();
  void deactivate();

  std::string getName() const { return polygon_name_; }
  ActionType getActionType() const { return action_type_; }
  bool getEnabled() const { return enabled_; }
  int getMinPoints() const { return min_points_; }
  double getSlowdownRatio() const { return slowdown_ratio_; }
  double getLinearLimit() const { return linear_limit_; }
  double getAngularLimit() const { return angular_limit_; }
  double getTimeBeforeCollision() const { return time_before_collision_; }
  std::vector<std::string> getSourcesNames() const { return sources_names_; }

  virtual void getPolygon(std::vector<Point>& poly) const;
  /// False, with a warning, before a shape is received.
  virtual bool isShapeSet();
  /// Takes the latest footprint, or follows the frame that the shape was published in.
  virtual void updatePolygon(const Velocity& cmd_vel_in);

  virtual int getPointsInside(const std::vector<Point>& points) const;
  /// Counts points of the sources that this zone watches.
  virtual int getPointsInside(const SourcePoints& sources_collision_points_map) const;
  /// In seconds; negative when nothing will be hit.
  double getCollisionTime(const SourcePoints& sources_collision_points_map,
                          const Velocity& velocity) const;
  void publish();

 protected:
  /// The topics stay empty when they are not needed. False: logged.
  bool getCommonParameters(std::string& polygon_sub_topic, std::string& polygon_pub_topic,
                           std::string& footprint_topic, bool use_dynamic_sub = false);
  virtual bool getParameters(std::string& polygon_sub_topic, std::string& polygon_pub_topic,
                             std::string& footprint_topic);
  virtual void createSubscription(std::string& polygon_sub_topic);
  void updatePolygon(geometry_msgs::msg::PolygonStamped::ConstSharedPtr msg);
  void polygonCallback(geometry_msgs::msg::PolygonStamped::ConstSharedPtr msg);
  rcl_interfaces::msg::SetParametersResult dynamicParametersCallback(
      std::vector<rclcpp::Parameter> parameters);
  bool isPointInside(const Point& point) const;
  /// From `[[x1, y1], [x2, y2], ...]`.
  bool getPolygonFromString(std::string& poly_string, std::vector<Point>& polygon);

  /// The QoS of a topic that the shape comes from.
  rclcpp::QoS shapeQoS() const;
  /// The vertices that are published.
  void setPublished(const std::vector<Point>& points);

  nav2_util::LifecycleNode::WeakPtr node_;
  rclcpp::Logger logger_{rclcpp::get_logger("collision_monitor")};
  rclcpp::node_interfaces::OnSetParametersCallbackHandle::SharedPtr dyn_params_handler_;
  std::string polygon_name_;
  ActionType action_type_ = DO_NOTHING;
  int min_points_ = 0;
  double slowdown_ratio_ = 0.0;
  double linear_limit_ = 0.0;           // m/s
  double angular_limit_ = 0.0;          // rad/s
  double time_before_collision_ = 0.0;  // s
  double simulation_time_step_ = 0.0;   // s
  bool enabled_ = true;
  bool polygon_subscribe_transient_local_ = false;
  rclcpp::Subscription<geometry_msgs::msg::PolygonStamped>::SharedPtr polygon_sub_;
  std::unique_ptr<nav2_costmap_2d::FootprintSubscriber> footprint_sub_;
  std::vector<std::string> sources_names_;
  std::shared_ptr<tf2_ros::Buffer> tf_buffer_;
  std::string base_frame_id_;
  tf2::Duration transform_tolerance_;
  bool visualize_ = false;
  // The latest shape that came on a topic, in its frame, or what is published.
  geometry_msgs::msg::PolygonStamped polygon_;
  rclcpp_lifecycle::LifecyclePublisher<geometry_msgs::msg::PolygonStamped>::SharedPtr polygon_pub_;
  std::vector<Point> poly_;  // in the frame of the robot

 private:
  // False: logged.
  bool readAction(const std::string& name);
  bool readSources(const nav2_util::LifecycleNode::SharedPtr& node);
  void readActionNumbers(const nav2_util::LifecycleNode::SharedPtr& node);
  void readMinPoints(const nav2_util::LifecycleNode::SharedPtr& node);
  void takeFootprint();
  /// The vertices of a published shape in the frame of the robot, as it is now. False: logged.
  bool toRobotFrame(const geometry_msgs::msg::PolygonStamped& shape);
};

}  // namespace nav2_collision_monitor
