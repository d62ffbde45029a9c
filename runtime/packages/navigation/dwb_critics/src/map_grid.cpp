// See map_grid.hpp.
#include "dwb_critics/map_grid.hpp"

#include <algorithm>
#include <cctype>

#include "dwb_core/exceptions.hpp"
#include "nav_2d_utils/parameters.hpp"

namespace dwb_critics {

using costmap_queue::CellData;
using dwb_core::IllegalTrajectoryException;

bool MapGridCritic::MapGridQueue::validCellToQueue(const CellData& /*cell*/) {
  return true;
}

void MapGridCritic::onInit() {
  costmap_ = costmap_ros_->getCostmap();
  queue_ = std::make_shared<MapGridQueue>(*costmap_, *this);
  stop_on_failure_ = true;
  const auto node = node_.lock();
  std::string type = nav_2d_utils::searchAndGetParam(
      node, dwb_plugin_name_ + "." + name_ + ".aggregation_type", std::string("last"));
  std::transform(type.begin(), type.end(), type.begin(),
                 [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  aggregationType_ = type == "sum"       ? ScoreAggregationType::Sum
                     : type == "product" ? ScoreAggregationType::Product
                                         : ScoreAggregationType::Last;
  if (type == "last" || aggregationType_ != ScoreAggregationType::Last) return;
  RCLCPP_ERROR(rclcpp::get_logger("MapGridCritic"),
               "aggregation_type parameter \"%s\" invalid. Using Last.", type.c_str());
}

void MapGridCritic::setAsObstacle(unsigned int index) {
  cell_values_[index] = obstacle_score_;
}

void MapGridCritic::reset() {
  queue_->reset();
  const size_t cells = size_t{costmap_->getSizeInCellsX()} * costmap_->getSizeInCellsY();
  obstacle_score_ = static_cast<double>(cells);
  unreachable_score_ = obstacle_score_ + 1.0;
  cell_values_.assign(cells, unreachable_score_);
}

void MapGridCritic::propogateManhattanDistances() {
  while (!queue_->isEmpty()) {
    const CellData cell = queue_->getNextCell();
    cell_values_[cell.index_] = CellData::absolute_difference(cell.src_x_, cell.x_) +
                                CellData::absolute_difference(cell.src_y_, cell.y_);
  }
}

double MapGridCritic::scoreTrajectory(const dwb_msgs::msg::Trajectory2D& traj) {
  double score = aggregationType_ == ScoreAggregationType::Product ? 1.0 : 0.0;
  const bool is_end_enough = aggregationType_ == ScoreAggregationType::Last && !stop_on_failure_;
  const size_t first = is_end_enough && !traj.poses.empty() ? traj.poses.size() - 1 : 0;
  for (size_t i = first; i < traj.poses.size(); ++i) {
    const double distance = scorePose(traj.poses[i]);
    if (stop_on_failure_ && distance == obstacle_score_) {
      throw IllegalTrajectoryException(name_, "Trajectory Hits Obstacle.");
    }
    if (stop_on_failure_ && distance == unreachable_score_) {
      throw IllegalTrajectoryException(name_, "Trajectory Hits Unreachable Area.");
    }
    switch (aggregationType_) {
      case ScoreAggregationType::Last:
        score = distance;
        break;
      case ScoreAggregationType::Sum:
        score += distance;
        break;
      case ScoreAggregationType::Product:
        score *= distance;
        break;
    }
  }
  return score;
}

double MapGridCritic::scorePose(const geometry_msgs::msg::Pose2D& pose) {
  unsigned int x = 0;
  unsigned int y = 0;
  if (!costmap_->worldToMap(pose.x, pose.y, x, y)) {
    throw IllegalTrajectoryException(name_, "Trajectory Goes Off Grid.");
  }
  return getScore(x, y);
}

void MapGridCritic::addCriticVisualization(
    std::vector<std::pair<std::string, std::vector<float>>>& cost_channels) {
  cost_channels.emplace_back(name_, std::vector<float>(cell_values_.begin(), cell_values_.end()));
}

}  // namespace dwb_critics
