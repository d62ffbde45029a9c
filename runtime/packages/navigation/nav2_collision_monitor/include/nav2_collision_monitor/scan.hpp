// Obstacles from a laser scan.
#pragma once

#include <vector>

#include "nav2_collision_monitor/source.hpp"
#include "sensor_msgs/msg/laser_scan.hpp"

namespace nav2_collision_monitor {

class Scan : public Source {
 public:
  using Source::Source;
  ~Scan();

  void configure() override;
  bool getData(const rclcpp::Time& curr_time, std::vector<Point>& data) override;

 protected:
  void dataCallback(sensor_msgs::msg::LaserScan::ConstSharedPtr msg);

  rclcpp::Subscription<sensor_msgs::msg::LaserScan>::SharedPtr data_sub_;
  sensor_msgs::msg::LaserScan::ConstSharedPtr data_;
};

}  // namespace nav2_collision_monitor
