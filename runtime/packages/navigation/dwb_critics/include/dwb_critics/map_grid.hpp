// Scores poses by a number for each cell of the costmap: the distance from some cells.
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "costmap_queue/costmap_queue.hpp"
#include "dwb_core/trajectory_critic.hpp"

namespace dwb_critics {

class MapGridCritic : public dwb_core::TrajectoryCritic {
 public:
  void onInit() override;
  double scoreTrajectory(const dwb_msgs::msg::Trajectory2D& traj) override;
  void addCriticVisualization(
      std::vector<std::pair<std::string, std::vector<float>>>& cost_channels) override;
  /// Scores become metres, halved.
  double getScale() const override { return costmap_->getResolution() * 0.5 * scale_; }
  virtual double scorePose(const geometry_msgs::msg::Pose2D& pose);
  inline double getScore(unsigned int x, unsigned int y) {
    return cell_values_[costmap_->getIndex(x, y)];
  }
  /// A trajectory over that cell is forbidden.
  void setAsObstacle(unsigned int index);

 protected:
  enum class ScoreAggregationType { Last, Sum, Product };

  class MapGridQueue : public costmap_queue::CostmapQueue {
   public:
    MapGridQueue(nav2_costmap_2d::Costmap2D& costmap, MapGridCritic& parent)
        : costmap_queue::CostmapQueue(costmap, true), parent_(parent) {}
    virtual ~MapGridQueue() = default;
    bool validCellToQueue(const costmap_queue::CellData& cell) override;

   protected:
    MapGridCritic& parent_;
  };

  void reset() override;
  /// From the cells in the queue, along rows and columns. (The name is upstream's.)
  void propogateManhattanDistances();

  std::shared_ptr<MapGridQueue> queue_;
  nav2_costmap_2d::Costmap2D* costmap_ = nullptr;
  std::vector<double> cell_values_;
  double obstacle_score_ = 0.0;
  double unreachable_score_ = 1.0;
  /// False in critics that look at a point ahead of the robot, which may be anywhere.
  bool stop_on_failure_ = true;
  ScoreAggregationType aggregationType_ = ScoreAggregationType::Last;
};

}  // namespace dwb_critics
