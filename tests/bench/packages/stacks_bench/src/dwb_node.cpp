// Cycles of DWB with 20 x 20 velocities over a local costmap of 60 x 60 cells, by itself: the
// robot stands at the begin of a straight path of 2 m.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <memory>
#include <vector>

#include "dwb_core/dwb_local_planner.hpp"
#include "nav2_costmap_2d/costmap_2d_ros.hpp"
#include "rclcpp/rclcpp.hpp"
#include "rclcpp_lifecycle/lifecycle_node.hpp"
#include "tf2_ros/buffer.h"

namespace {

constexpr int kCycles = 60;

nav_msgs::msg::Path straight_path() {
  nav_msgs::msg::Path path;
  path.header.frame_id = "odom";
  for (int i = 0; i <= 40; ++i) {
    geometry_msgs::msg::PoseStamped pose;
    pose.header = path.header;
    pose.pose.position.x = 0.05 * i;
    pose.pose.orientation.w = 1.0;
    path.poses.push_back(pose);
  }
  return path;
}

}  // namespace

int main(int argc, char** argv) {
  using Clock = std::chrono::steady_clock;
  rclcpp::init(argc, argv);
  auto node = std::make_shared<rclcpp_lifecycle::LifecycleNode>("dwb");
  auto costmap = std::make_shared<nav2_costmap_2d::Costmap2DROS>("local_costmap");
  costmap->configure();
  costmap->getCostmap()->updateOrigin(-1.5, -1.5);
  auto buffer = std::make_shared<tf2_ros::Buffer>(node->get_clock());
  dwb_core::DWBLocalPlanner planner;
  planner.configure(node, "FollowPath", buffer, costmap);
  planner.activate();
  const nav_msgs::msg::Path path = straight_path();
  std::vector<double> times;
  double speed = 0.0;
  for (int i = 0; i < kCycles; ++i) {
    const auto begin = Clock::now();
    planner.setPlan(path);
    const geometry_msgs::msg::Twist still;
    speed = planner.computeVelocityCommands(path.poses.front(), still, nullptr).twist.linear.x;
    times.push_back(std::chrono::duration<double, std::milli>(Clock::now() - begin).count());
  }
  std::sort(times.begin(), times.end());
  std::printf("dwb %.2f m/s", speed);
  for (const double time : times) std::printf(" %f", time);
  std::printf("\n");
  rclcpp::shutdown();
}
