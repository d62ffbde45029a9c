// Obstacles from a sensor that measures one distance over a field of view.
#pragma once

#include <vector>

#include "nav2_collision_monitor/source.hpp"
#include "sensor_msgs/msg/range.hpp"

namespace nav2_collision_monitor {

class Range : public Source {
 public:
  using Source::Source;
  ~Range();

  void configure() override;
  bool getData(const rclcpp::Time& curr_time, std::vector<Point>& data) override;

 protected:
  void dataCallback(sensor_msgs::msg::Range::ConstSharedPtr msg);

  rclcpp::Subscription<sensor_msgs::msg::Range>::SharedPtr data_sub_;
  double obstacles_angle_ = 0.0;  // rad between two points of the field of view
  sensor_msgs::msg::Range::ConstSharedPtr data_;
};

}  // namespace nav2_collision_monitor
