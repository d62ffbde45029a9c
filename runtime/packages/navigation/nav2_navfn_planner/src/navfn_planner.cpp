// See navfn_planner.hpp.
#include "nav2_navfn_planner/navfn_planner.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "nav2_costmap_2d/cost_values.hpp"
#include "nav2_util/geometry_utils.hpp"
#include "nav2_util/node_utils.hpp"
#include "pluginlib/class_list_macros.hpp"

PLUGINLIB_EXPORT_CLASS(nav2_navfn_planner::NavfnPlanner, nav2_core::GlobalPlanner)

namespace nav2_navfn_planner {

using nav2_util::declare_parameter_if_not_declared;
using nav2_util::geometry_utils::euclidean_distance;
using nav2_util::geometry_utils::orientationAroundZAxis;

namespace {

/// In metres.
constexpr double kSamePlace = 0.001;

std::string coordinates(const char* which, const geometry_msgs::msg::Pose& pose) {
  return std::string(which) + " Coordinates of(" + std::to_string(pose.position.x) + ", " +
         std::to_string(pose.position.y) + ")";
}

}  // namespace

NavfnPlanner::~NavfnPlanner() {
  RCLCPP_INFO(logger_, "Destroying plugin %s of type NavfnPlanner", name_.c_str());
}

void NavfnPlanner::configure(const rclcpp_lifecycle::LifecycleNode::WeakPtr& parent,
                             std::string name, std::shared_ptr<tf2_ros::Buffer>,
                             std::shared_ptr<nav2_costmap_2d::Costmap2DROS> costmap_ros) {
  name_ = std::move(name);
  costmap_ = costmap_ros->getCostmap();
  global_frame_ = costmap_ros->getGlobalFrameID();
  node_ = parent;
  const auto node = parent.lock();
  clock_ = node->get_clock();
  logger_ = node->get_logger();
  RCLCPP_INFO(logger_, "Configuring plugin %s of type NavfnPlanner", name_.c_str());
  declare_parameter_if_not_declared(node, name_ + ".tolerance", rclcpp::ParameterValue(0.5));
  declare_parameter_if_not_declared(node, name_ + ".use_astar", rclcpp::ParameterValue(false));
  declare_parameter_if_not_declared(node, name_ + ".allow_unknown", rclcpp::ParameterValue(true));
  declare_parameter_if_not_declared(node, name_ + ".use_final_approach_orientation",
                                    rclcpp::ParameterValue(false));
  node->get_parameter(name_ + ".tolerance", tolerance_);
  node->get_parameter(name_ + ".use_astar", use_astar_);
  node->get_parameter(name_ + ".allow_unknown", allow_unknown_);
  node->get_parameter(name_ + ".use_final_approach_orientation", use_final_approach_orientation_);
}

void NavfnPlanner::activate() {
  RCLCPP_INFO(logger_, "Activating plugin %s of type NavfnPlanner", name_.c_str());
  dyn_params_handler_ = node_.lock()->add_on_set_parameters_callback(
      [this](std::vector<rclcpp::Parameter> parameters) {
        return dynamicParametersCallback(parameters);
      });
}

void NavfnPlanner::deactivate() {
  RCLCPP_INFO(logger_, "Deactivating plugin %s of type NavfnPlanner", name_.c_str());
  const auto node = node_.lock();
  if (dyn_params_handler_ && node) {
    node->remove_on_set_parameters_callback(dyn_params_handler_.get());
  }
  dyn_params_handler_.reset();
}

void NavfnPlanner::cleanup() {
  RCLCPP_INFO(logger_, "Cleaning up plugin %s of type NavfnPlanner", name_.c_str());
  planner_.reset();
}

bool NavfnPlanner::cell_of(double wx, double wy, Cell& cell) const {
  const double x = (wx - place_.origin_x) / place_.resolution;
  const double y = (wy - place_.origin_y) / place_.resolution;
  if (!(x >= 0 && y >= 0 && x < planner_->nx() && y < planner_->ny())) return false;
  cell = {static_cast<int>(x), static_cast<int>(y)};
  return true;
}

void NavfnPlanner::checkBounds(const Pose& start, const Pose& goal) const {
  Cell cell;
  if (!cell_of(start.position.x, start.position.y, cell)) {
    throw nav2_core::StartOutsideMapBounds(coordinates("Start", start) + " was outside bounds");
  }
  if (!cell_of(goal.position.x, goal.position.y, cell)) {
    throw nav2_core::GoalOutsideMapBounds(coordinates("Goal", goal) + " was outside bounds");
  }
  const auto cost =
      costmap_->getCost(static_cast<unsigned int>(cell.x), static_cast<unsigned int>(cell.y));
  if (tolerance_ == 0 && cost == nav2_costmap_2d::LETHAL_OBSTACLE) {
    throw nav2_core::GoalOccupied(coordinates("Goal", goal) + " was in lethal cost");
  }
}

void NavfnPlanner::takeCosts(const Pose& start, const Pose& goal) {
  const std::unique_lock<nav2_costmap_2d::Costmap2D::mutex_t> lock(*costmap_->getMutex());
  const int width = static_cast<int>(costmap_->getSizeInCellsX());
  const int height = static_cast<int>(costmap_->getSizeInCellsY());
  if (!planner_ || planner_->nx() != width || planner_->ny() != height) {
    planner_ = std::make_unique<NavFn>(width, height);
  }
  place_ = {costmap_->getOriginX(), costmap_->getOriginY(), costmap_->getResolution()};
  checkBounds(start, goal);
  // The robot stands there: what is seen in its place is the robot.
  Cell from;
  cell_of(start.position.x, start.position.y, from);
  costmap_->setCost(static_cast<unsigned int>(from.x), static_cast<unsigned int>(from.y),
                    nav2_costmap_2d::FREE_SPACE);
  planner_->setCostmap(costmap_->getCharMap(), allow_unknown_);
}

nav_msgs::msg::Path NavfnPlanner::createPlan(const geometry_msgs::msg::PoseStamped& start,
                                             const geometry_msgs::msg::PoseStamped& goal,
                                             std::function<bool()> cancel_checker) {
  takeCosts(start.pose, goal.pose);
  Path path;
  path.header.stamp = clock_->now();
  path.header.frame_id = global_frame_;
  if (start.pose.position.x == goal.pose.position.x &&
      start.pose.position.y == goal.pose.position.y) {
    geometry_msgs::msg::PoseStamped pose;
    pose.header = path.header;
    pose.pose = start.pose;
    if (!use_final_approach_orientation_) pose.pose.orientation = goal.pose.orientation;
    path.poses.push_back(pose);
    return path;
  }
  if (!makePlan(start.pose, goal.pose, cancel_checker, path)) {
    throw nav2_core::NoValidPathCouldBeFound("Failed to create plan with tolerance of: " +
                                             std::to_string(tolerance_));
  }
  return path;
}

bool NavfnPlanner::makePlan(const Pose& start, const Pose& goal,
                            const std::function<bool()>& cancel_checker, Path& plan) {
  Cell from;
  Cell to;
  if (!cell_of(start.position.x, start.position.y, from) ||
      !cell_of(goal.position.x, goal.position.y, to)) {
    return false;
  }
  // From the robot: a goal that cannot be reached has others near it that can.
  planner_->computePotential(from, to, use_astar_, cancel_checker);
  if (cancel_checker && cancel_checker()) {
    throw nav2_core::PlannerCancelled("Planner was cancelled");
  }
  Pose best;
  if (!findReachable(goal, best)) return false;
  if (!fillPlan(best, plan)) {
    RCLCPP_ERROR(logger_,
                 "Failed to create a plan from potential when a legal potential was found. This "
                 "shouldn't happen.");
    return false;
  }
  approachGoal(best, plan);
  if (use_final_approach_orientation_) turnAlongPath(plan);
  return !plan.poses.empty();
}

bool NavfnPlanner::findReachable(const Pose& goal, Pose& best) const {
  const auto is_reached = [this](double x, double y) {
    Cell cell;
    return cell_of(x, y, cell) && planner_->potential(cell) < NavFn::kHighPotential;
  };
  best = goal;
  if (is_reached(goal.position.x, goal.position.y)) return true;
  double nearest = std::numeric_limits<double>::max();
  const double step = place_.resolution;
  Pose pose = goal;
  for (double dy = -tolerance_; dy <= tolerance_; dy += step) {
    for (double dx = -tolerance_; dx <= tolerance_; dx += step) {
      pose.position.x = goal.position.x + dx;
      pose.position.y = goal.position.y + dy;
      const double square = dx * dx + dy * dy;
      if (square >= nearest || !is_reached(pose.position.x, pose.position.y)) continue;
      nearest = square;
      best = pose;
    }
  }
  return nearest < std::numeric_limits<double>::max();
}

bool NavfnPlanner::fillPlan(const Pose& best, Path& plan) const {
  Cell cell;
  if (!cell_of(best.position.x, best.position.y, cell)) return false;
  const int most_steps = 4 * std::max(planner_->nx(), planner_->ny());
  const std::vector<PathPoint> points = planner_->path(cell, most_steps);
  plan.poses.clear();
  for (auto point = points.rbegin(); point != points.rend(); ++point) {
    geometry_msgs::msg::PoseStamped pose;
    pose.header = plan.header;
    pose.pose.position.x = place_.origin_x + point->x * place_.resolution;
    pose.pose.position.y = place_.origin_y + point->y * place_.resolution;
    pose.pose.orientation.w = 1.0;
    plan.poses.push_back(pose);
  }
  return !plan.poses.empty();
}

void NavfnPlanner::approachGoal(const Pose& goal, Path& plan) const {
  // The last pose gives way to the goal when it is farther along than the goal.
  if (plan.poses.size() >= 2) {
    const Pose& before = plan.poses[plan.poses.size() - 2].pose;
    Pose& last = plan.poses.back().pose;
    if (euclidean_distance(last, before) > euclidean_distance(goal, before)) {
      last = goal;
      return;
    }
  }
  // So does one at its place.
  if (!plan.poses.empty() && euclidean_distance(plan.poses.back().pose, goal) < kSamePlace) {
    plan.poses.back().pose = goal;
    return;
  }
  geometry_msgs::msg::PoseStamped pose;
  pose.header = plan.header;
  pose.pose = goal;
  plan.poses.push_back(pose);
}

void NavfnPlanner::turnAlongPath(Path& plan) const {
  const size_t count = plan.poses.size();
  if (count < 2) return;
  Pose& last = plan.poses[count - 1].pose;
  const Pose& before = plan.poses[count - 2].pose;
  double dx = last.position.x - before.position.x;
  double dy = last.position.y - before.position.y;
  // The goal may be very near to the pose before.
  if (count > 2 && std::abs(dx) < 0.0001 && std::abs(dy) < 0.0001) {
    const Pose& earlier = plan.poses[count - 3].pose;
    dx = last.position.x - earlier.position.x;
    dy = last.position.y - earlier.position.y;
  }
  last.orientation = orientationAroundZAxis(std::atan2(dy, dx));
}

rcl_interfaces::msg::SetParametersResult NavfnPlanner::dynamicParametersCallback(
    std::vector<rclcpp::Parameter> parameters) {
  for (const rclcpp::Parameter& parameter : parameters) {
    const std::string& name = parameter.get_name();
    if (parameter.get_type() == rclcpp::ParameterType::PARAMETER_DOUBLE) {
      if (name == name_ + ".tolerance") tolerance_ = parameter.as_double();
    } else if (parameter.get_type() == rclcpp::ParameterType::PARAMETER_BOOL) {
      if (name == name_ + ".use_astar") use_astar_ = parameter.as_bool();
      if (name == name_ + ".allow_unknown") allow_unknown_ = parameter.as_bool();
      if (name == name_ + ".use_final_approach_orientation") {
        use_final_approach_orientation_ = parameter.as_bool();
      }
    }
  }
  rcl_interfaces::msg::SetParametersResult result;
  result.successful = true;
  return result;
}

}  // namespace nav2_navfn_planner
