// See velocity_smoother.hpp.
#include "nav2_velocity_smoother/velocity_smoother.hpp"

#include <chrono>
#include <cmath>
#include <utility>

#include "parameter_checks.hpp"
#include "rclcpp_components/register_node_macro.hpp"
#include "velocity_steps.hpp"

namespace nav2_velocity_smoother {

using geometry_msgs::msg::Twist;
using geometry_msgs::msg::TwistStamped;
using nav2_util::CallbackReturn;
using nav2_util::declare_parameter_if_not_declared;
using rclcpp::ParameterType;

namespace {

constexpr const char* kNumbers[] = {"smoothing_frequency", "velocity_timeout", "odom_duration"};
constexpr const char* kAxes[] = {"max_decel", "max_accel", "min_velocity", "max_velocity",
                                 "deadband_velocity"};

Velocity velocity_of(const Twist& twist) {
  return {twist.linear.x, twist.linear.y, twist.angular.z};
}

Twist twist_of(const Velocity& velocity) {
  Twist result;
  result.linear.x = velocity[0];
  result.linear.y = velocity[1];
  result.angular.z = velocity[2];
  return result;
}

Velocity axes(const std::vector<double>& values) {
  return {values[0], values[1], values[2]};
}

std::string check(const rclcpp::Parameter& parameter) {
  const std::string& name = parameter.get_name();
  switch (parameter.get_type()) {
    case ParameterType::PARAMETER_DOUBLE:
      return check_number(name, parameter.as_double());
    case ParameterType::PARAMETER_DOUBLE_ARRAY:
      return check_axes(name, parameter.as_double_array(), Moment::kChange);
    case ParameterType::PARAMETER_STRING:
      return name == "feedback" ? check_feedback(parameter.as_string()) : "";
    default:
      return "";
  }
}

}  // namespace

VelocitySmoother::VelocitySmoother(const rclcpp::NodeOptions& options)
    : LifecycleNode("velocity_smoother", "", options),
      last_command_time_{0, 0, get_clock()->get_clock_type()} {}

VelocitySmoother::~VelocitySmoother() {
  if (timer_) timer_->cancel();
}

void VelocitySmoother::declareParameters() {
  using Numbers = std::vector<double>;
  const auto declare = [this](const char* name, const auto& value) {
    declare_parameter_if_not_declared(this, name, rclcpp::ParameterValue(value));
  };
  declare("smoothing_frequency", 20.0);
  declare("feedback", "OPEN_LOOP");
  declare("scale_velocities", false);
  declare("max_velocity", Numbers{0.50, 0.0, 2.5});
  declare("min_velocity", Numbers{-0.50, 0.0, -2.5});
  declare("max_accel", Numbers{2.5, 0.0, 3.2});
  declare("max_decel", Numbers{-2.5, 0.0, -3.2});
  declare("odom_topic", "odom");
  declare("odom_duration", 0.1);
  declare("deadband_velocity", Numbers{0.0, 0.0, 0.0});
  declare("velocity_timeout", 1.0);
  declare("stamp_smoothed_velocity_with_smoothing_time", false);
  declare("use_realtime_priority", false);
}

std::string VelocitySmoother::readParameters() {
  for (const char* name : kAxes) {
    const rclcpp::Parameter parameter = get_parameter(name);
    const std::string message = check_axes(name, parameter.as_double_array(), Moment::kConfigure);
    if (!message.empty()) return message;
    apply(parameter);
  }
  for (const char* name : kNumbers) {
    const rclcpp::Parameter parameter = get_parameter(name);
    const std::string message = check_number(name, parameter.as_double());
    if (!message.empty()) return message;
    apply(parameter);
  }
  scale_velocities_ = get_parameter("scale_velocities").as_bool();
  stamp_smoothed_velocity_with_smoothing_time_ =
      get_parameter("stamp_smoothed_velocity_with_smoothing_time").as_bool();
  odom_topic_ = get_parameter("odom_topic").as_string();
  return check_feedback(get_parameter("feedback").as_string());
}

CallbackReturn VelocitySmoother::on_configure(const rclcpp_lifecycle::State& state) {
  RCLCPP_INFO(get_logger(), "Configuring velocity smoother");
  declareParameters();
  const std::string message = readParameters();
  if (!message.empty()) {
    RCLCPP_ERROR(get_logger(), "%s", message.c_str());
    on_cleanup(state);
    return CallbackReturn::FAILURE;
  }
  apply(get_parameter("feedback"));
  const auto node = shared_from_this();
  smoothed_cmd_pub_ = std::make_unique<nav2_util::TwistPublisher>(node, "cmd_vel_smoothed", 1);
  cmd_sub_ = std::make_unique<nav2_util::TwistSubscriber>(
      node, "cmd_vel", rclcpp::QoS(1),
      [this](Twist::SharedPtr msg) { inputCommandCallback(std::move(msg)); },
      [this](TwistStamped::SharedPtr msg) { inputCommandStampedCallback(std::move(msg)); });
  if (get_parameter("use_realtime_priority").as_bool()) nav2_util::setSoftRealTimePriority();
  return CallbackReturn::SUCCESS;
}

CallbackReturn VelocitySmoother::on_activate(const rclcpp_lifecycle::State&) {
  RCLCPP_INFO(get_logger(), "Activating");
  smoothed_cmd_pub_->on_activate();
  startTimer();
  dyn_params_handler_ =
      add_on_set_parameters_callback([this](std::vector<rclcpp::Parameter> parameters) {
        return dynamicParametersCallback(std::move(parameters));
      });
  createBond();
  return CallbackReturn::SUCCESS;
}

CallbackReturn VelocitySmoother::on_deactivate(const rclcpp_lifecycle::State&) {
  RCLCPP_INFO(get_logger(), "Deactivating");
  if (timer_) timer_->cancel();
  timer_.reset();
  smoothed_cmd_pub_->on_deactivate();
  dyn_params_handler_.reset();
  destroyBond();
  return CallbackReturn::SUCCESS;
}

CallbackReturn VelocitySmoother::on_cleanup(const rclcpp_lifecycle::State&) {
  RCLCPP_INFO(get_logger(), "Cleaning up");
  smoothed_cmd_pub_.reset();
  odom_smoother_.reset();
  cmd_sub_.reset();
  return CallbackReturn::SUCCESS;
}

CallbackReturn VelocitySmoother::on_shutdown(const rclcpp_lifecycle::State&) {
  RCLCPP_INFO(get_logger(), "Shutting down");
  return CallbackReturn::SUCCESS;
}

void VelocitySmoother::startTimer() {
  if (timer_) timer_->cancel();
  const std::chrono::milliseconds period(static_cast<int64_t>(1000.0 / smoothing_frequency_));
  timer_ = create_wall_timer(period, [this] { smootherTimer(); });
}

void VelocitySmoother::listenToOdometry() {
  odom_smoother_ =
      std::make_unique<nav2_util::OdomSmoother>(shared_from_this(), odom_duration_, odom_topic_);
}

void VelocitySmoother::inputCommandStampedCallback(const TwistStamped::SharedPtr msg) {
  if (!nav2_util::validateTwist(msg->twist)) {
    RCLCPP_ERROR(get_logger(), "Velocity message contains NaNs or Infs! Ignoring as invalid!");
    return;
  }
  command_ = msg;
  const bool has_stamp = msg->header.stamp.sec != 0 || msg->header.stamp.nanosec != 0;
  last_command_time_ = has_stamp ? rclcpp::Time(msg->header.stamp) : now();
  wake();
}

void VelocitySmoother::wake() {
  if (timer_ && timer_->is_canceled()) timer_->reset();
}

void VelocitySmoother::inputCommandCallback(Twist::SharedPtr msg) {
  auto stamped = std::make_shared<TwistStamped>();
  stamped->twist = *msg;
  inputCommandStampedCallback(stamped);
}

double VelocitySmoother::findEtaConstraint(const double v_curr, const double v_cmd,
                                           const double accel, const double decel) {
  return find_eta(v_curr, v_cmd, {accel, decel}, smoothing_frequency_);
}

double VelocitySmoother::applyConstraints(const double v_curr, const double v_cmd,
                                          const double accel, const double decel,
                                          const double eta) {
  return stepped(v_curr, v_cmd, {accel, decel}, eta, smoothing_frequency_);
}

bool VelocitySmoother::isIdle(const rclcpp::Duration& age) {
  if (age <= velocity_timeout_) return false;
  if (stopped_ || last_cmd_.twist == Twist()) return true;
  *command_ = TwistStamped();
  command_->header.stamp = now();
  return false;
}

Twist VelocitySmoother::nextVelocity() {
  Limits limits{
      axes(min_velocities_), axes(max_velocities_), {}, smoothing_frequency_, scale_velocities_};
  for (size_t i = 0; i < limits.axes.size(); ++i) limits.axes[i] = {max_accels_[i], max_decels_[i]};
  const Twist current = open_loop_ ? last_cmd_.twist : odom_smoother_->getTwist();
  const Velocity command = clamped(velocity_of(command_->twist), limits);
  return twist_of(next_velocity(velocity_of(current), command, limits));
}

void VelocitySmoother::smootherTimer() {
  const rclcpp::Duration age = now() - last_command_time_;
  auto velocity = std::make_unique<TwistStamped>();
  if (command_) velocity->header = command_->header;
  stopped_ = !command_ || isIdle(age);
  if (stopped_) {
    timer_->cancel();
    return;
  }
  if (stamp_smoothed_velocity_with_smoothing_time_) {
    velocity->header.stamp = rclcpp::Time(velocity->header.stamp) + age;
  }
  velocity->twist = nextVelocity();
  last_cmd_ = *velocity;
  const auto pass = [](double& value, double deadband) {
    if (std::abs(value) < deadband) value = 0.0;
  };
  pass(velocity->twist.linear.x, deadband_velocities_[0]);
  pass(velocity->twist.linear.y, deadband_velocities_[1]);
  pass(velocity->twist.angular.z, deadband_velocities_[2]);
  smoothed_cmd_pub_->publish(std::move(velocity));
}

void VelocitySmoother::apply(const rclcpp::Parameter& parameter) {
  const std::string& name = parameter.get_name();
  if (parameter.get_type() == ParameterType::PARAMETER_DOUBLE) {
    if (name == "velocity_timeout") {
      velocity_timeout_ = rclcpp::Duration::from_seconds(parameter.as_double());
    }
    if (name == "odom_duration") odom_duration_ = parameter.as_double();
    if (name == "smoothing_frequency") smoothing_frequency_ = parameter.as_double();
    if (name == "smoothing_frequency" && timer_) startTimer();
  } else if (parameter.get_type() == ParameterType::PARAMETER_DOUBLE_ARRAY) {
    if (name == "max_velocity") max_velocities_ = parameter.as_double_array();
    if (name == "min_velocity") min_velocities_ = parameter.as_double_array();
    if (name == "max_accel") max_accels_ = parameter.as_double_array();
    if (name == "max_decel") max_decels_ = parameter.as_double_array();
    if (name == "deadband_velocity") deadband_velocities_ = parameter.as_double_array();
  } else if (parameter.get_type() == ParameterType::PARAMETER_STRING) {
    if (name == "odom_topic") odom_topic_ = parameter.as_string();
    if (name == "feedback") open_loop_ = parameter.as_string() == "OPEN_LOOP";
    if (name == "feedback" && open_loop_) odom_smoother_.reset();
    if (name == "feedback" && !open_loop_) listenToOdometry();
  }
  const bool changes_odometry = name == "odom_topic" || name == "odom_duration";
  if (changes_odometry && odom_smoother_) listenToOdometry();
}

rcl_interfaces::msg::SetParametersResult VelocitySmoother::dynamicParametersCallback(
    std::vector<rclcpp::Parameter> parameters) {
  rcl_interfaces::msg::SetParametersResult result;
  result.successful = true;
  for (const rclcpp::Parameter& parameter : parameters) {
    const std::string message = check(parameter);
    if (message.empty()) continue;
    RCLCPP_WARN(get_logger(), "%s", message.c_str());
    result.successful = false;
    result.reason = message;
    return result;
  }
  for (const rclcpp::Parameter& parameter : parameters) apply(parameter);
  // A longer timeout makes a command valid again.
  wake();
  return result;
}

}  // namespace nav2_velocity_smoother

RCLCPP_COMPONENTS_REGISTER_NODE(nav2_velocity_smoother::VelocitySmoother)
