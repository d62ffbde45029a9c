// The work of the controller server for one goal.
#include <algorithm>
#include <cmath>
#include <utility>

#include "nav2_controller/controller_server.hpp"
#include "nav2_util/geometry_utils.hpp"
#include "nav2_util/robot_utils.hpp"

namespace nav2_controller {

using geometry_msgs::msg::PoseStamped;
using geometry_msgs::msg::Twist;
using geometry_msgs::msg::TwistStamped;

bool ControllerServer::findController(const std::string& name) {
  if (controllers_.loaded.count(name) != 0) {
    controllers_.current = name;
    return true;
  }
  if (controllers_.loaded.size() == 1 && name.empty()) {
    RCLCPP_WARN_ONCE(get_logger(),
                     "No controller was specified in action call. Server will use only plugin "
                     "loaded %s. This warning will appear once.",
                     controllers_.names.c_str());
    controllers_.current = controllers_.loaded.begin()->first;
    return true;
  }
  RCLCPP_ERROR(get_logger(),
               "FollowPath called with controller name %s, which does not exist. Available "
               "controllers are: %s.",
               name.c_str(), controllers_.names.c_str());
  return false;
}

bool ControllerServer::findGoalChecker(const std::string& name) {
  if (goal_checkers_.loaded.count(name) != 0) {
    goal_checkers_.current = name;
    return true;
  }
  if (goal_checkers_.loaded.size() == 1 && name.empty()) {
    RCLCPP_WARN_ONCE(get_logger(),
                     "No goal checker was specified in parameter 'current_goal_checker'. Server "
                     "will use only plugin loaded %s. This warning will appear once.",
                     goal_checkers_.names.c_str());
    goal_checkers_.current = goal_checkers_.loaded.begin()->first;
    return true;
  }
  RCLCPP_ERROR(get_logger(),
               "FollowPath called with goal_checker name %s in parameter 'current_goal_checker', "
               "which does not exist. Available goal checkers are: %s.",
               name.c_str(), goal_checkers_.names.c_str());
  return false;
}

bool ControllerServer::findProgressChecker(const std::string& name, std::string& found) {
  found = name;
  // Without any, the robot may stand.
  if (progress_checkers_.loaded.count(name) != 0) return true;
  if (progress_checkers_.loaded.empty() && name.empty()) return true;
  if (progress_checkers_.loaded.size() == 1 && name.empty()) {
    RCLCPP_WARN_ONCE(get_logger(),
                     "No progress checker was specified in parameter 'current_progress_checker'. "
                     "Server will use only plugin loaded %s. This warning will appear once.",
                     progress_checkers_.names.c_str());
    found = progress_checkers_.loaded.begin()->first;
    return true;
  }
  RCLCPP_ERROR(get_logger(),
               "FollowPath called with progress_checker name %s in parameter "
               "'current_progress_checker', which does not exist. Available progress checkers "
               "are: %s.",
               name.c_str(), progress_checkers_.names.c_str());
  return false;
}

void ControllerServer::computeControl() {
  const std::lock_guard<std::mutex> lock(dynamic_params_lock_);
  RCLCPP_INFO(get_logger(), "Received a goal, begin computing control effort.");
  using Result = Action::Result;
  try {
    const auto goal = action_server_->get_current_goal();
    // The server was deactivated meanwhile.
    if (!goal) return;
    begin(*goal);
    followUntilReached();
  } catch (const nav2_core::InvalidController& error) {
    fail(Result::INVALID_CONTROLLER, error);
  } catch (const nav2_core::ControllerTFError& error) {
    fail(Result::TF_ERROR, error);
  } catch (const nav2_core::NoValidControl& error) {
    fail(Result::NO_VALID_CONTROL, error);
  } catch (const nav2_core::FailedToMakeProgress& error) {
    fail(Result::FAILED_TO_MAKE_PROGRESS, error);
  } catch (const nav2_core::PatienceExceeded& error) {
    fail(Result::PATIENCE_EXCEEDED, error);
  } catch (const nav2_core::InvalidPath& error) {
    fail(Result::INVALID_PATH, error);
  } catch (const nav2_core::ControllerTimedOut& error) {
    fail(Result::CONTROLLER_TIMED_OUT, error);
  } catch (const std::exception& error) {
    fail(Result::UNKNOWN, error);
  }
}

void ControllerServer::fail(uint16_t code, const std::exception& error) {
  RCLCPP_ERROR(get_logger(), "%s", error.what());
  publishZeroVelocity();
  auto result = std::make_shared<Action::Result>();
  result->error_code = code;
  result->error_msg = error.what();
  action_server_->terminate_current(result);
}

void ControllerServer::begin(const Action::Goal& goal) {
  if (!findController(goal.controller_id)) {
    throw nav2_core::InvalidController("Failed to find controller name: " + goal.controller_id);
  }
  if (!findGoalChecker(goal.goal_checker_id)) {
    throw nav2_core::ControllerException("Failed to find goal checker name: " +
                                         goal.goal_checker_id);
  }
  if (!findProgressChecker(goal.progress_checker_id, progress_checkers_.current)) {
    throw nav2_core::ControllerException("Failed to find progress checker name: " +
                                         goal.progress_checker_id);
  }
  setPlannerPath(goal.path);
  if (!progress_checkers_.current.empty()) {
    progress_checkers_.loaded[progress_checkers_.current]->reset();
  }
  last_valid_cmd_time_ = now();
}

void ControllerServer::followUntilReached() {
  rclcpp::WallRate rate(controller_frequency_);
  while (rclcpp::ok()) {
    const rclcpp::Time start = now();
    if (!action_server_->is_server_active()) {
      RCLCPP_DEBUG(get_logger(), "Action server unavailable or inactive. Stopping.");
      return;
    }
    if (isCancelled()) return;
    waitForCostmap();
    updateGlobalPath();
    if (isGoalReached()) {
      RCLCPP_INFO(get_logger(), "Reached the goal!");
      publishZeroVelocity();
      action_server_->succeeded_current();
      return;
    }
    computeAndPublishVelocity();
    const rclcpp::Duration duration = now() - start;
    if (rate.sleep()) continue;
    RCLCPP_WARN(get_logger(),
                "Control loop missed its desired rate of %.4f Hz. Current loop rate is %.4f Hz.",
                controller_frequency_, 1 / duration.seconds());
    rate.reset();
  }
}

bool ControllerServer::isCancelled() {
  if (!action_server_->is_cancel_requested()) return false;
  if (!controllers_.loaded[controllers_.current]->cancel()) {
    RCLCPP_INFO_THROTTLE(get_logger(), *get_clock(), 1000,
                         "Waiting for the controller to finish cancellation");
    return false;
  }
  RCLCPP_INFO(get_logger(), "Cancellation was successful. Stopping the robot.");
  action_server_->terminate_all();
  publishZeroVelocity();
  return true;
}

void ControllerServer::waitForCostmap() {
  rclcpp::Rate rate(100);
  const rclcpp::Time begin = now();
  while (!costmap_ros_->isCurrent()) {
    // The clock may stand.
    if (!rclcpp::ok() || !action_server_->is_server_active() ||
        now() - begin > costmap_update_timeout_) {
      throw nav2_core::ControllerTimedOut("Costmap timed out waiting for update");
    }
    rate.sleep();
  }
}

void ControllerServer::updateGlobalPath() {
  if (!action_server_->is_preempt_requested()) return;
  RCLCPP_INFO(get_logger(), "Passing new path to controller.");
  const auto goal = action_server_->accept_pending_goal();
  if (!findController(goal->controller_id)) {
    throw nav2_core::InvalidController("Failed to find controller name: " + goal->controller_id);
  }
  if (!findGoalChecker(goal->goal_checker_id)) {
    throw nav2_core::ControllerException("Failed to find goal checker name: " +
                                         goal->goal_checker_id);
  }
  std::string progress_checker;
  if (!findProgressChecker(goal->progress_checker_id, progress_checker)) {
    throw nav2_core::ControllerException("Failed to find progress checker name: " +
                                         goal->progress_checker_id);
  }
  if (progress_checker != progress_checkers_.current) {
    RCLCPP_INFO(get_logger(), "Change of progress checker %s requested, resetting it",
                goal->progress_checker_id.c_str());
    progress_checkers_.current = progress_checker;
    if (!progress_checker.empty()) progress_checkers_.loaded[progress_checker]->reset();
  }
  setPlannerPath(goal->path);
}

void ControllerServer::setPlannerPath(const nav_msgs::msg::Path& path) {
  RCLCPP_DEBUG(get_logger(), "Providing path to the controller %s", controllers_.current.c_str());
  if (path.poses.empty()) throw nav2_core::InvalidPath("Path is empty.");
  controllers_.loaded[controllers_.current]->setPlan(path);
  end_pose_ = path.poses.back();
  end_pose_.header.frame_id = path.header.frame_id;
  goal_checkers_.loaded[goal_checkers_.current]->reset();
  RCLCPP_DEBUG(get_logger(), "Path end point is (%.2f, %.2f)", end_pose_.pose.position.x,
               end_pose_.pose.position.y);
  current_path_ = path;
}

Twist ControllerServer::currentVelocity() {
  Twist velocity;
  {
    const std::lock_guard<std::mutex> lock(odom_lock_);
    velocity.linear.x = odom_.linear.x;
    velocity.linear.y = odom_.linear.y;
    velocity.angular.z = odom_.angular.z;
  }
  const auto cut = [](double& part, double threshold) {
    if (std::abs(part) <= threshold) part = 0.0;
  };
  cut(velocity.linear.x, min_x_velocity_threshold_);
  cut(velocity.linear.y, min_y_velocity_threshold_);
  cut(velocity.angular.z, min_theta_velocity_threshold_);
  return velocity;
}

bool ControllerServer::isGoalReached() {
  PoseStamped pose;
  if (!costmap_ros_->getRobotPose(pose)) return false;
  // The end moves in the frame of the costmap, while the robot corrects its place on the map.
  PoseStamped end;
  end_pose_.header.stamp = rclcpp::Time();
  if (!nav2_util::transformPoseInTargetFrame(end_pose_, end, *costmap_ros_->getTfBuffer(),
                                             costmap_ros_->getGlobalFrameID(),
                                             costmap_ros_->getTransformTolerance())) {
    throw nav2_core::ControllerTFError("Failed to transform end pose to global frame");
  }
  return goal_checkers_.loaded[goal_checkers_.current]->isGoalReached(pose.pose, end.pose,
                                                                      currentVelocity());
}

TwistStamped ControllerServer::stopped() const {
  TwistStamped velocity;
  velocity.header.frame_id = costmap_ros_->getBaseFrameID();
  velocity.header.stamp = now();
  return velocity;
}

TwistStamped ControllerServer::nextVelocity(const PoseStamped& pose) {
  try {
    TwistStamped velocity = controllers_.loaded[controllers_.current]->computeVelocityCommands(
        pose, currentVelocity(), goal_checkers_.loaded[goal_checkers_.current].get());
    last_valid_cmd_time_ = now();
    velocity.header = stopped().header;
    return velocity;
  } catch (const nav2_core::NoValidControl& error) {
    const bool is_patient_for_ever = failure_tolerance_ == -1.0;
    if (!(failure_tolerance_ > 0) && !is_patient_for_ever) throw;
    RCLCPP_WARN(get_logger(), "%s", error.what());
    if (!is_patient_for_ever && (now() - last_valid_cmd_time_).seconds() > failure_tolerance_) {
      throw nav2_core::PatienceExceeded("Controller patience exceeded");
    }
    return stopped();
  }
}

void ControllerServer::computeAndPublishVelocity() {
  PoseStamped pose;
  if (!costmap_ros_->getRobotPose(pose)) {
    throw nav2_core::ControllerTFError("Failed to obtain robot pose");
  }
  if (!progress_checkers_.current.empty() &&
      !progress_checkers_.loaded[progress_checkers_.current]->check(pose)) {
    throw nav2_core::FailedToMakeProgress("Failed to make progress");
  }
  const TwistStamped velocity = nextVelocity(pose);
  publishFeedback(pose, velocity.twist);
  publishVelocity(velocity);
}

void ControllerServer::publishFeedback(const PoseStamped& pose, const Twist& velocity) {
  auto feedback = std::make_shared<Action::Feedback>();
  feedback->speed = static_cast<float>(std::hypot(velocity.linear.x, velocity.linear.y));
  // The path may be in another frame than the local costmap.
  PoseStamped robot = pose;
  nav2_util::transformPoseInTargetFrame(pose, robot, *costmap_ros_->getTfBuffer(),
                                        current_path_.header.frame_id,
                                        costmap_ros_->getTransformTolerance());
  const auto distance_of = [&robot](const PoseStamped& one) {
    return nav2_util::geometry_utils::euclidean_distance(robot, one);
  };
  const auto& poses = current_path_.poses;
  const auto nearest = std::min_element(
      poses.begin(), poses.end(),
      [&](const PoseStamped& a, const PoseStamped& b) { return distance_of(a) < distance_of(b); });
  feedback->distance_to_goal = static_cast<float>(nav2_util::geometry_utils::calculate_path_length(
      current_path_, static_cast<size_t>(nearest - poses.begin())));
  action_server_->publish_feedback(feedback);
}

void ControllerServer::publishVelocity(const TwistStamped& velocity) {
  if (vel_publisher_->is_activated() && vel_publisher_->get_subscription_count() > 0) {
    vel_publisher_->publish(std::make_unique<TwistStamped>(velocity));
  }
}

void ControllerServer::publishZeroVelocity() {
  if (get_parameter("publish_zero_velocity").as_bool()) publishVelocity(stopped());
  for (const auto& [id, controller] : controllers_.loaded) controller->reset();
}

}  // namespace nav2_controller
