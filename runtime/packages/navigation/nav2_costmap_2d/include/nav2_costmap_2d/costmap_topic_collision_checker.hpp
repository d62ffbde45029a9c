// Collision checks against a costmap and an outline that another node publishes.
#pragma once

#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "geometry_msgs/msg/pose2_d.hpp"
#include "nav2_costmap_2d/costmap_2d.hpp"
#include "nav2_costmap_2d/costmap_subscriber.hpp"
#include "nav2_costmap_2d/footprint_collision_checker.hpp"
#include "nav2_costmap_2d/footprint_subscriber.hpp"
#include "rclcpp/rclcpp.hpp"

namespace nav2_costmap_2d {

class CostmapTopicCollisionChecker {
 public:
  CostmapTopicCollisionChecker(CostmapSubscriber& costmap_sub, FootprintSubscriber& footprint_sub,
                               std::string name = "collision_checker");
  CostmapTopicCollisionChecker(CostmapSubscriber& costmap_sub, std::string footprint_string,
                               std::string name = "collision_checker");
  ~CostmapTopicCollisionChecker() = default;

  /// The greatest cost under the outline at a pose. Throws IllegalPoseException outside of the map,
  /// CollisionCheckerException when something is missing. `fetch_costmap_and_footprint` false:
  /// those of the last call, for many poses at one time.
  double scorePose(const geometry_msgs::msg::Pose2D& pose, bool fetch_costmap_and_footprint = true);
  /// False, with an error logged, when something is missing.
  bool isCollisionFree(const geometry_msgs::msg::Pose2D& pose,
                       bool fetch_costmap_and_footprint = true);

 protected:
  Footprint getFootprint(const geometry_msgs::msg::Pose2D& pose,
                         bool fetch_latest_footprint = true);

  std::string name_;
  CostmapSubscriber& costmap_sub_;
  FootprintSubscriber* footprint_sub_ = nullptr;
  FootprintCollisionChecker<std::shared_ptr<Costmap2D>> collision_checker_;
  Footprint footprint_;
  std::string footprint_string_;

 private:
  std::mutex mutex_;  // of the above: behaviours share one checker, each in its thread
};

}  // namespace nav2_costmap_2d
