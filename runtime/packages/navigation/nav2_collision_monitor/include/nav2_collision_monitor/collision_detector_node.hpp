// Reports in which zones the sensors of a robot see an obstacle. It does not change the velocity.
#pragma once

#include <memory>
#include <vector>

#include "nav2_collision_monitor/types.hpp"
#include "nav2_collision_monitor/zones.hpp"
#include "nav2_msgs/msg/collision_detector_state.hpp"
#include "nav2_util/lifecycle_node.hpp"
#include "rclcpp/rclcpp.hpp"
#include "visualization_msgs/msg/marker_array.hpp"

namespace nav2_collision_monitor {

class CollisionDetector : public nav2_util::LifecycleNode {
 public:
  explicit CollisionDetector(const rclcpp::NodeOptions& options = rclcpp::NodeOptions());
  ~CollisionDetector();

 protected:
  using MarkerArray = visualization_msgs::msg::MarkerArray;
  using State = nav2_msgs::msg::CollisionDetectorState;

  nav2_util::CallbackReturn on_configure(const rclcpp_lifecycle::State& state) override;
  nav2_util::CallbackReturn on_activate(const rclcpp_lifecycle::State& state) override;
  nav2_util::CallbackReturn on_deactivate(const rclcpp_lifecycle::State& state) override;
  nav2_util::CallbackReturn on_cleanup(const rclcpp_lifecycle::State& state) override;
  nav2_util::CallbackReturn on_shutdown(const rclcpp_lifecycle::State& state) override;

  bool getParameters();
  void process();

  Zones zones_;
  rclcpp_lifecycle::LifecyclePublisher<State>::SharedPtr state_pub_;
  rclcpp_lifecycle::LifecyclePublisher<MarkerArray>::SharedPtr collision_points_marker_pub_;
  rclcpp::TimerBase::SharedPtr timer_;
  double frequency_ = 10.0;  // Hz

 private:
  std::vector<Point> collectPoints();
  void publishPoints(const std::vector<Point>& points);
};

}  // namespace nav2_collision_monitor
