// Obstacles along the outlines of polygons, each with a number.
#pragma once

#include <vector>

#include "geometry_msgs/msg/polygon_instance_stamped.hpp"
#include "nav2_collision_monitor/source.hpp"

namespace nav2_collision_monitor {

class PolygonSource : public Source {
 public:
  using Source::Source;
  ~PolygonSource();

  void configure() override;
  bool getData(const rclcpp::Time& curr_time, std::vector<Point>& data) override;

 protected:
  void dataCallback(geometry_msgs::msg::PolygonInstanceStamped::ConstSharedPtr msg);

  void dropStale(const rclcpp::Time& curr_time);

  rclcpp::Subscription<geometry_msgs::msg::PolygonInstanceStamped>::SharedPtr data_sub_;
  std::vector<geometry_msgs::msg::PolygonInstanceStamped> data_;  // the latest of each number
  double sampling_distance_ = 0.0;                                // m
};

}  // namespace nav2_collision_monitor
