// A circle around the robot.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "nav2_collision_monitor/polygon.hpp"
#include "std_msgs/msg/float32.hpp"

namespace nav2_collision_monitor {

class Circle : public Polygon {
 public:
  Circle(const nav2_util::LifecycleNode::WeakPtr& node, const std::string& polygon_name,
         const std::shared_ptr<tf2_ros::Buffer> tf_buffer, const std::string& base_frame_id,
         const tf2::Duration& transform_tolerance);
  ~Circle();

  using Polygon::getPointsInside;
  using Polygon::updatePolygon;
  /// 16 vertices, for visualization.
  void getPolygon(std::vector<Point>& poly) const override;
  int getPointsInside(const std::vector<Point>& points) const override;
  bool isShapeSet() override;

 protected:
  bool getParameters(std::string& polygon_sub_topic, std::string& polygon_pub_topic,
                     std::string& footprint_topic) override;
  void createSubscription(std::string& polygon_sub_topic) override;
  void updatePolygon(double radius);
  void radiusCallback(std_msgs::msg::Float32::ConstSharedPtr msg);

  double radius_ = 0.0;           // m
  double radius_squared_ = -1.0;  // negative: not known yet
  rclcpp::Subscription<std_msgs::msg::Float32>::SharedPtr radius_sub_;
};

}  // namespace nav2_collision_monitor
