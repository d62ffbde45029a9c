// See costmap_topic_collision_checker.hpp.
#include "nav2_costmap_2d/costmap_topic_collision_checker.hpp"

#include <memory>
#include <mutex>
#include <utility>

#include "nav2_costmap_2d/cost_values.hpp"
#include "nav2_costmap_2d/exceptions.hpp"
#include "nav2_costmap_2d/footprint.hpp"

namespace nav2_costmap_2d {

CostmapTopicCollisionChecker::CostmapTopicCollisionChecker(CostmapSubscriber& costmap_sub,
                                                           FootprintSubscriber& footprint_sub,
                                                           std::string name)
    : name_(std::move(name)), costmap_sub_(costmap_sub), footprint_sub_(&footprint_sub) {}

CostmapTopicCollisionChecker::CostmapTopicCollisionChecker(CostmapSubscriber& costmap_sub,
                                                           std::string footprint_string,
                                                           std::string name)
    : name_(std::move(name)),
      costmap_sub_(costmap_sub),
      footprint_string_(std::move(footprint_string)) {}

bool CostmapTopicCollisionChecker::isCollisionFree(const geometry_msgs::msg::Pose2D& pose,
                                                   bool fetch_costmap_and_footprint) {
  try {
    return scorePose(pose, fetch_costmap_and_footprint) < LETHAL_OBSTACLE;
  } catch (const std::runtime_error& error) {
    RCLCPP_ERROR(rclcpp::get_logger(name_), "%s", error.what());
    return false;
  }
}

double CostmapTopicCollisionChecker::scorePose(const geometry_msgs::msg::Pose2D& pose,
                                               bool fetch_costmap_and_footprint) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (fetch_costmap_and_footprint) {
    try {
      collision_checker_.setCostmap(costmap_sub_.getCostmap());
    } catch (const std::runtime_error& error) {
      throw CollisionCheckerException(error.what());
    }
  }
  const std::shared_ptr<Costmap2D> costmap = collision_checker_.getCostmap();
  if (!costmap) throw CollisionCheckerException("Costmap is not available");
  // A message that arrives during the check may give the map another size.
  const std::lock_guard<Costmap2D::mutex_t> cells_lock(*costmap->getMutex());
  unsigned int cell_x = 0;
  unsigned int cell_y = 0;
  if (!collision_checker_.worldToMap(pose.x, pose.y, cell_x, cell_y)) {
    RCLCPP_DEBUG(rclcpp::get_logger(name_), "Map Cell: [%d, %d]", cell_x, cell_y);
    throw IllegalPoseException(name_, "Pose Goes Off Grid.");
  }
  return collision_checker_.footprintCost(getFootprint(pose, fetch_costmap_and_footprint));
}

Footprint CostmapTopicCollisionChecker::getFootprint(const geometry_msgs::msg::Pose2D& pose,
                                                     bool fetch_latest_footprint) {
  if (fetch_latest_footprint && footprint_sub_ != nullptr) {
    std_msgs::msg::Header header;
    if (!footprint_sub_->getFootprintInRobotFrame(footprint_, header)) {
      throw CollisionCheckerException("Current footprint not available.");
    }
  } else if (footprint_sub_ == nullptr && footprint_.empty() &&
             !makeFootprintFromString(footprint_string_, footprint_)) {
    throw CollisionCheckerException("The footprint is not valid: " + footprint_string_);
  }
  Footprint oriented;
  transformFootprint(pose.x, pose.y, pose.theta, footprint_, oriented);
  return oriented;
}

}  // namespace nav2_costmap_2d
