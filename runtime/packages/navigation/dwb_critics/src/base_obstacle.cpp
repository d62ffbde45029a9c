// See base_obstacle.hpp.
#include "dwb_critics/base_obstacle.hpp"

#include "dwb_core/exceptions.hpp"
#include "nav2_costmap_2d/cost_values.hpp"
#include "nav_2d_utils/parameters.hpp"
#include "pluginlib/class_list_macros.hpp"

namespace dwb_critics {

void BaseObstacleCritic::onInit() {
  costmap_ = costmap_ros_->getCostmap();
  const auto node = node_.lock();
  sum_scores_ =
      nav_2d_utils::searchAndGetParam(node, dwb_plugin_name_ + "." + name_ + ".sum_scores", false);
}

double BaseObstacleCritic::scoreTrajectory(const dwb_msgs::msg::Trajectory2D& traj) {
  double score = 0.0;
  for (const auto& pose : traj.poses) score = (sum_scores_ ? score : 0.0) + scorePose(pose);
  return score;
}

double BaseObstacleCritic::scorePose(const geometry_msgs::msg::Pose2D& pose) {
  unsigned int x = 0;
  unsigned int y = 0;
  if (!costmap_->worldToMap(pose.x, pose.y, x, y)) {
    throw dwb_core::IllegalTrajectoryException(name_, "Trajectory Goes Off Grid.");
  }
  const unsigned char cost = costmap_->getCost(x, y);
  if (!isValidCost(cost)) {
    throw dwb_core::IllegalTrajectoryException(name_, "Trajectory Hits Obstacle.");
  }
  return cost;
}

bool BaseObstacleCritic::isValidCost(const unsigned char cost) {
  return cost < nav2_costmap_2d::INSCRIBED_INFLATED_OBSTACLE;
}

void BaseObstacleCritic::addCriticVisualization(
    std::vector<std::pair<std::string, std::vector<float>>>& cost_channels) {
  const size_t cells = size_t{costmap_->getSizeInCellsX()} * costmap_->getSizeInCellsY();
  const unsigned char* const costs = costmap_->getCharMap();
  cost_channels.emplace_back(name_, std::vector<float>(costs, costs + cells));
}

}  // namespace dwb_critics

PLUGINLIB_EXPORT_CLASS(dwb_critics::BaseObstacleCritic, dwb_core::TrajectoryCritic)
