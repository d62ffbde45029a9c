// Obstacles from the points of a cloud that are within heights.
#pragma once

#include <vector>

#include "nav2_collision_monitor/source.hpp"
#include "sensor_msgs/msg/point_cloud2.hpp"

namespace nav2_collision_monitor {

class PointCloud : public Source {
 public:
  using Source::Source;
  ~PointCloud();

  void configure() override;
  bool getData(const rclcpp::Time& curr_time, std::vector<Point>& data) override;

 protected:
  void dataCallback(sensor_msgs::msg::PointCloud2::ConstSharedPtr msg);

  /// Heights that are not z in the frame of the robot come from the field `height`.
  bool isReadable() const;

  rclcpp::Subscription<sensor_msgs::msg::PointCloud2>::SharedPtr data_sub_;
  double min_height_ = 0.0;  // m
  double max_height_ = 0.0;  // m
  double min_range_ = 0.0;   // m from the sensor
  bool use_global_height_ = false;
  sensor_msgs::msg::PointCloud2::ConstSharedPtr data_;
};

}  // namespace nav2_collision_monitor
