// Moves joints along trajectories that come by topic or by action.
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "control_msgs/action/follow_joint_trajectory.hpp"
#include "control_msgs/msg/joint_trajectory_controller_state.hpp"
#include "control_msgs/msg/speed_scaling_factor.hpp"
#include "control_msgs/srv/query_trajectory_state.hpp"
#include "control_toolbox/pid.hpp"
#include "controller_interface/controller_interface.hpp"
#include "joint_trajectory_controller/jtc_parameters.hpp"
#include "joint_trajectory_controller/path.hpp"
#include "joint_trajectory_controller/tolerances.hpp"
#include "rclcpp/rclcpp.hpp"
#include "rclcpp_action/rclcpp_action.hpp"
#include "rclcpp_lifecycle/state.hpp"
#include "realtime_tools/realtime_publisher.hpp"
#include "realtime_tools/realtime_server_goal_handle.hpp"
#include "trajectory_msgs/msg/joint_trajectory.hpp"

namespace joint_trajectory_controller {

/// Whether there is a value of each kind, for commands or for states.
struct Kinds {
  bool position = false;
  bool velocity = false;
  bool acceleration = false;
  bool effort = false;
};

class JointTrajectoryController : public controller_interface::ControllerInterface {
 public:
  JointTrajectoryController() = default;

  controller_interface::InterfaceConfiguration command_interface_configuration() const override;
  controller_interface::InterfaceConfiguration state_interface_configuration() const override;
  controller_interface::return_type update(const rclcpp::Time& time,
                                           const rclcpp::Duration& period) override;
  controller_interface::CallbackReturn on_init() override;
  controller_interface::CallbackReturn on_configure(
      const rclcpp_lifecycle::State& previous_state) override;
  controller_interface::CallbackReturn on_activate(
      const rclcpp_lifecycle::State& previous_state) override;
  controller_interface::CallbackReturn on_deactivate(
      const rclcpp_lifecycle::State& previous_state) override;
  controller_interface::CallbackReturn on_error(
      const rclcpp_lifecycle::State& previous_state) override;

 private:
  using CallbackReturn = controller_interface::CallbackReturn;
  using Action = control_msgs::action::FollowJointTrajectory;
  using GoalHandle = rclcpp_action::ServerGoalHandle<Action>;
  using RealtimeGoal = realtime_tools::RealtimeServerGoalHandle<Action>;
  using StateMessage = control_msgs::msg::JointTrajectoryControllerState;
  using QueryState = control_msgs::srv::QueryTrajectoryState;
  using Trajectory = trajectory_msgs::msg::JointTrajectory;
  template <class InterfaceT>
  using Handles = std::array<std::vector<std::reference_wrapper<InterfaceT>>, 4>;

  /// How a cycle stands to the tolerances.
  struct Judgement {
    bool is_violated_on_the_way = false;
    bool is_outside_goal = false;
    bool is_in_time = true;
    bool is_over = false;  ///< after the last point
    double late_s = 0.0;   ///< since the segment began
  };

  // jtc_setup.cpp
  void read_model();
  void check_deceleration(const std::vector<double>& max_velocities);
  bool choose_joints();
  bool choose_interfaces();
  void create_topics();
  void create_services();
  void set_up_scaling();
  void update_pids();
  SegmentTolerances tolerances_of_parameters() const;
  void log_interfaces() const;
  void choose_timeout();
  bool find_scaling_interfaces();
  void reset();

  // jtc_interfaces.cpp
  template <class InterfaceT>
  bool order_interfaces(std::vector<InterfaceT>& all, const std::vector<std::string>& kinds,
                        const std::vector<std::string>& joints, const char* what,
                        Handles<InterfaceT>& ordered);
  bool take_interfaces();
  void read_state(PathPoint& state) const;
  /// Replaces the kinds that have a command for each joint.
  void read_commands_as_state(PathPoint& state) const;
  /// False when a kind has no command for a joint.
  bool read_commands(PathPoint& commands) const;
  bool are_commands_set(size_t kind) const;
  std::vector<double> commands_of(size_t kind) const;
  void write(size_t kind, const std::vector<double>& values);
  void write_commands(const rclcpp::Duration& period);
  void stop_commands();
  void publish_state(const rclcpp::Time& time);

  // joint_trajectory_controller.cpp
  void follow_parameters();
  void read_scaling();
  void start_new_trajectory();
  void prepare_first_sample(const rclcpp::Time& time);
  void update_error();
  Judgement judge(const Segment& segment, bool is_first_sample);
  void check_timeout(const Judgement& judgement);
  void report_feedback(const rclcpp::Time& time);
  void end_goal(const Judgement& judgement);
  void end_without_goal(const Judgement& judgement);
  void follow_trajectory(const rclcpp::Time& time, const rclcpp::Duration& period);

  // goals.cpp
  void on_trajectory(const std::shared_ptr<Trajectory>& message);
  bool is_accepted(const PathRequest& request) const;
  rclcpp_action::GoalResponse on_goal(const std::shared_ptr<const Action::Goal>& goal);
  rclcpp_action::CancelResponse on_cancel(const std::shared_ptr<GoalHandle>& goal);
  void on_accepted(const std::shared_ptr<GoalHandle>& goal);
  void watch_goal(const std::shared_ptr<RealtimeGoal>& goal);
  void on_query(const QueryState::Request& request, QueryState::Response& response);
  void set_scaling_factor(double factor);
  void hold();
  void hold_or_brake();
  void repeat_last_point();
  void start_hold(PathPoint point);

  std::shared_ptr<ParamListener> param_listener_;
  Params params_;
  std::vector<std::string> command_joints_;
  std::vector<size_t> command_places_;  ///< of each command joint among the joints
  std::vector<bool> wraps_;             ///< of each joint: has it no limits?
  Kinds commands_;
  Kinds states_;
  Handles<hardware_interface::LoanedCommandInterface> command_handles_;
  Handles<hardware_interface::LoanedStateInterface> state_handles_;
  rclcpp::Duration update_period_ = rclcpp::Duration::from_nanoseconds(0);
  Interpolation interpolation_ = Interpolation::kSplines;

  bool uses_pids_ = false;
  std::vector<std::shared_ptr<control_toolbox::Pid>> pids_;
  std::vector<double> ff_velocity_scale_;

  /// Between the control loop and the callbacks of topics, services and the action.
  std::recursive_mutex mutex_;
  std::optional<Path> path_;                  ///< while active
  std::shared_ptr<PathRequest> new_request_;  ///< the one to run from the next cycle on
  std::shared_ptr<RealtimeGoal> goal_;
  std::shared_ptr<RealtimeGoal> watched_goal_;  ///< the last one, until its client knows the end
  bool is_holding_ = false;
  SegmentTolerances default_tolerances_;
  SegmentTolerances active_tolerances_;
  double cmd_timeout_ = 0.0;
  bool brakes_on_cancel_ = false;
  std::vector<double> max_deceleration_;

  PathPoint state_;
  PathPoint wanted_;
  PathPoint error_;
  PathPoint next_;  ///< what is commanded in this cycle
  PathPoint last_command_;
  std::optional<rclcpp::Time> last_command_time_;
  rclcpp::Time path_time_;  ///< slower than the clock when the speed is scaled down

  double scaling_factor_ = 1.0;
  double scaling_factor_command_ = 1.0;
  std::optional<std::reference_wrapper<hardware_interface::LoanedStateInterface>> scaling_state_;
  std::optional<std::reference_wrapper<hardware_interface::LoanedCommandInterface>>
      scaling_command_;

  std::shared_ptr<realtime_tools::RealtimePublisher<StateMessage>> state_publisher_;
  StateMessage state_message_;
  rclcpp::Subscription<Trajectory>::SharedPtr trajectory_subscription_;
  rclcpp::Subscription<control_msgs::msg::SpeedScalingFactor>::SharedPtr scaling_subscription_;
  rclcpp_action::Server<Action>::SharedPtr action_server_;
  rclcpp::Service<QueryState>::SharedPtr query_service_;
  rclcpp::TimerBase::SharedPtr goal_timer_;
};

/// The messages of points and trajectories.
PathPoint to_point(const trajectory_msgs::msg::JointTrajectoryPoint& message);
trajectory_msgs::msg::JointTrajectoryPoint to_message(const PathPoint& point);
PathRequest to_request(const trajectory_msgs::msg::JointTrajectory& message);

}  // namespace joint_trajectory_controller
