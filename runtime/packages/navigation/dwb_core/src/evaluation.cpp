// The choice between the trajectories of one cycle.
#include <algorithm>
#include <cmath>
#include <utility>

#include "dwb_core/dwb_local_planner.hpp"
#include "dwb_core/exceptions.hpp"
#include "dwb_core/illegal_trajectory_tracker.hpp"
#include "dwb_msgs/msg/critic_score.hpp"

namespace dwb_core {

using dwb_msgs::msg::CriticScore;
using dwb_msgs::msg::LocalPlanEvaluation;
using dwb_msgs::msg::Trajectory2D;
using dwb_msgs::msg::TrajectoryScore;

namespace {

TrajectoryScore forbidden(const Trajectory2D& trajectory, const std::string& critic) {
  CriticScore score;
  score.name = critic;
  score.raw_score = -1.0F;
  TrajectoryScore result;
  result.traj = trajectory;
  result.scores.push_back(std::move(score));
  result.total = -1.0F;
  return result;
}

/// The index of the last entry; the message has 16 bits for it.
uint16_t last_index(const LocalPlanEvaluation& results) {
  return static_cast<uint16_t>(std::min<size_t>(results.twists.size() - 1, UINT16_MAX));
}

void log_reasons(const IllegalTrajectoryTracker& tracker) {
  const rclcpp::Logger logger = rclcpp::get_logger("DWBLocalPlanner");
  RCLCPP_ERROR(logger, "%s", tracker.getMessage().c_str());
  for (const auto& [reason, share] : tracker.getPercentages()) {
    RCLCPP_ERROR(logger, "%.2f: %10s/%s", share, reason.first.c_str(), reason.second.c_str());
  }
}

}  // namespace

TrajectoryScore DWBLocalPlanner::coreScoringAlgorithm(
    const geometry_msgs::msg::Pose2D& pose, const nav_2d_msgs::msg::Twist2D velocity,
    std::shared_ptr<LocalPlanEvaluation>& results) {
  TrajectoryScore best;
  best.total = -1.0F;
  float worst = -1.0F;
  IllegalTrajectoryTracker tracker;
  traj_generator_->startNewIteration(velocity);
  while (traj_generator_->hasMoreTwists()) {
    const Trajectory2D trajectory =
        traj_generator_->generateTrajectory(pose, velocity, traj_generator_->nextTwist());
    try {
      TrajectoryScore score = scoreTrajectory(trajectory, best.total);
      tracker.addLegalTrajectory();
      if (results) results->twists.push_back(score);
      if (worst < 0 || score.total > worst) {
        worst = score.total;
        if (results) results->worst_index = last_index(*results);
      }
      if (best.total < 0 || score.total < best.total) {
        best = std::move(score);
        if (results) results->best_index = last_index(*results);
      }
    } catch (const IllegalTrajectoryException& error) {
      if (results) results->twists.push_back(forbidden(trajectory, error.getCriticName()));
      tracker.addIllegalTrajectory(error);
    }
  }
  if (best.total >= 0) return best;
  if (debug_trajectory_details_) log_reasons(tracker);
  throw NoLegalTrajectoriesException(tracker);
}

TrajectoryScore DWBLocalPlanner::scoreTrajectory(const Trajectory2D& traj, double best_score) {
  TrajectoryScore result;
  result.traj = traj;
  result.scores.reserve(critics_.size());
  for (const TrajectoryCritic::Ptr& critic : critics_) {
    CriticScore score;
    score.name = critic->getName();
    score.scale = static_cast<float>(critic->getScale());
    if (score.scale != 0.0F) {
      const double raw = critic->scoreTrajectory(traj);
      if (std::isnan(raw)) throw IllegalTrajectoryException(score.name, "Score Is Not A Number.");
      score.raw_score = static_cast<float>(raw);
      result.total = static_cast<float>(result.total + raw * score.scale);
    }
    result.scores.push_back(std::move(score));
    // Scores are not negative: the sum does not become less again.
    const bool is_worse = best_score > 0 && result.total > best_score;
    if (short_circuit_trajectory_evaluation_ && is_worse) break;
  }
  return result;
}

}  // namespace dwb_core
