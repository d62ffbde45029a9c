// A zone whose shape depends on the velocity.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "nav2_collision_monitor/polygon.hpp"

namespace nav2_collision_monitor {

class VelocityPolygon : public Polygon {
 public:
  VelocityPolygon(const nav2_util::LifecycleNode::WeakPtr& node, const std::string& polygon_name,
                  const std::shared_ptr<tf2_ros::Buffer> tf_buffer,
                  const std::string& base_frame_id, const tf2::Duration& transform_tolerance);
  ~VelocityPolygon();

  /// Takes the first shape whose range has the velocity; without one the shape stays.
  void updatePolygon(const Velocity& cmd_vel_in) override;

 protected:
  struct SubPolygonParameter {
    std::vector<Point> poly_;
    std::string velocity_polygon_name_;
    double linear_min_;  // m/s
    double linear_max_;
    double theta_min_;  // rad/s
    double theta_max_;
    double direction_end_angle_;  // rad; only for holonomic robots
    double direction_start_angle_;
  };

  bool getParameters(std::string& polygon_sub_topic, std::string& polygon_pub_topic,
                     std::string& footprint_topic) override;
  bool isInRange(const Velocity& cmd_vel_in, const SubPolygonParameter& sub_polygon_param);

  rclcpp::Clock::SharedPtr clock_;
  bool holonomic_ = false;
  std::vector<SubPolygonParameter> sub_polygons_;

 private:
  /// False: its points cannot be used, which is logged.
  bool readSubPolygon(const std::string& name);
};

}  // namespace nav2_collision_monitor
