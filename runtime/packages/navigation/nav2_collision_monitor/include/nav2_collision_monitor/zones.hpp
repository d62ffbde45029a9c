// Zones around the robot, sources of obstacles, transforms: both nodes of the package have them.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "nav2_collision_monitor/polygon.hpp"
#include "nav2_collision_monitor/source.hpp"
#include "nav2_util/lifecycle_node.hpp"
#include "tf2_ros/buffer.h"
#include "tf2_ros/transform_listener.h"
#include "visualization_msgs/msg/marker.hpp"

namespace nav2_collision_monitor {

struct Zones {
  /// From parameters. False: one cannot be used, which is logged.
  bool configure(const nav2_util::LifecycleNode::SharedPtr& node);
  void activate();
  void deactivate();
  void clear();
  void publish() const;

  std::string base_frame_id;
  std::vector<std::shared_ptr<Polygon>> polygons;
  std::vector<std::shared_ptr<Source>> sources;

 private:
  bool configureSources(const nav2_util::LifecycleNode::SharedPtr& node);
  bool configurePolygons(const nav2_util::LifecycleNode::SharedPtr& node);

  std::shared_ptr<tf2_ros::Buffer> tf_buffer_;
  std::shared_ptr<tf2_ros::TransformListener> tf_listener_;
  tf2::Duration transform_tolerance_{};
};

/// Appends what a source sees. False also when its data makes it throw, such as a negative time.
bool readPoints(Source& source, const rclcpp::Time& time, std::vector<Point>& points);

/// Points of obstacles, for visualization.
visualization_msgs::msg::Marker pointsMarker(const std::string& frame_id, const std::string& ns,
                                             const std::vector<Point>& points);

}  // namespace nav2_collision_monitor
