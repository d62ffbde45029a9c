// The life of controllers of steered bases: parameters, topics, interfaces.
#include <algorithm>
#include <cstdio>
#include <exception>
#include <limits>

#include "hardware_interface/types/hardware_interface_type_values.hpp"
#include "rclcpp/logging.hpp"
#include "rclcpp/qos.hpp"
#include "steering_controllers_library/steering_controllers_library.hpp"

namespace steering_controllers_library {
namespace {

constexpr double kNotANumber = std::numeric_limits<double>::quiet_NaN();
constexpr const char* kTypes[] = {"Bicycle", "Tricycle", "Ackermann"};
constexpr size_t kTractionJoints[] = {1, 2, 2};
constexpr size_t kSteeringJoints[] = {1, 1, 2};
constexpr const char* kNumbers[] = {"no", "one", "two"};

}  // namespace

using controller_interface::CallbackReturn;
using controller_interface::interface_configuration_type;
using controller_interface::InterfaceConfiguration;
using hardware_interface::HW_IF_POSITION;
using hardware_interface::HW_IF_VELOCITY;

CallbackReturn SteeringControllersLibrary::on_init() {
  try {
    param_listener_ = std::make_shared<ParamListener>(get_node(), describe);
    params_ = param_listener_->get_params();
    initialize_implementation_parameter_listener();
  } catch (const std::exception& error) {
    std::fprintf(stderr, "Exception thrown during controller's init with message: %s \n",
                 error.what());
    return CallbackReturn::ERROR;
  }
  return CallbackReturn::SUCCESS;
}

void SteeringControllersLibrary::take_deprecated_names() {
  const auto logger = get_node()->get_logger();
  if (!params_.front_steering) {
    RCLCPP_WARN(logger,
                "DEPRECATED parameter 'front_steering'. Instead, set 'traction_joints_names' or "
                "'steering_joints_names'");
  }
  const auto take = [&](const char* name, const std::vector<std::string>& names, bool steers,
                        bool are_states) {
    if (names.empty()) return;
    const char* const suffix = are_states ? "state_names" : "names";
    RCLCPP_WARN(logger,
                "DEPRECATED parameter '%s', set 'traction_joints_%s' or 'steering_joints_%s' "
                "instead",
                name, suffix, suffix);
    auto& steering =
        are_states ? params_.steering_joints_state_names : params_.steering_joints_names;
    auto& traction =
        are_states ? params_.traction_joints_state_names : params_.traction_joints_names;
    (steers ? steering : traction) = names;
  };
  const bool front_steers = params_.front_steering;
  take("front_wheels_names", params_.front_wheels_names, front_steers, false);
  take("rear_wheels_names", params_.rear_wheels_names, !front_steers, false);
  take("front_wheels_state_names", params_.front_wheels_state_names, front_steers, true);
  take("rear_wheels_state_names", params_.rear_wheels_state_names, !front_steers, true);
}

bool SteeringControllersLibrary::check_joints() {
  const unsigned int type = odometry_.get_odometry_type();
  const auto has = [&](const char* what, const std::vector<std::string>& names, size_t expected,
                       const char* given) {
    if (names.size() == expected) return true;
    RCLCPP_ERROR(get_node()->get_logger(),
                 "%s configuration requires exactly %s %s joint%s, but %zu %swere provided",
                 kTypes[type], kNumbers[expected], what, expected == 1 ? "" : "s", names.size(),
                 given);
    return false;
  };
  const size_t traction = kTractionJoints[type];
  const size_t steering = kSteeringJoints[type];
  if (!has("traction", params_.traction_joints_names, traction, "") ||
      !has("steering", params_.steering_joints_names, steering, "")) {
    return false;
  }
  traction_states_ = params_.traction_joints_state_names;
  steering_states_ = params_.steering_joints_state_names;
  if (traction_states_.empty()) traction_states_ = params_.traction_joints_names;
  if (steering_states_.empty()) steering_states_ = params_.steering_joints_names;
  return has("traction", traction_states_, traction, "state interface names ") &&
         has("steering", steering_states_, steering, "state interface names ");
}

CallbackReturn SteeringControllersLibrary::on_configure(const rclcpp_lifecycle::State&) {
  params_ = param_listener_->get_params();
  take_deprecated_names();
  if (configure_odometry() != CallbackReturn::SUCCESS || !check_joints()) {
    return CallbackReturn::ERROR;
  }
  odometry_.set_velocity_rolling_window_size(
      static_cast<size_t>(std::max<int64_t>(1, params_.velocity_rolling_window_size)));
  ref_timeout_ = rclcpp::Duration::from_seconds(params_.reference_timeout);
  forget_reference();
  create_topics();
  prepare_messages();
  RCLCPP_INFO(get_node()->get_logger(), "configure successful");
  return CallbackReturn::SUCCESS;
}

void SteeringControllersLibrary::create_topics() {
  const auto node = get_node();
  rclcpp::SystemDefaultsQoS subscription_qos;
  subscription_qos.keep_last(1);
  subscription_qos.best_effort();
  reference_subscription_ = node->create_subscription<ControllerTwistReferenceMsg>(
      "~/reference", subscription_qos,
      [this](const std::shared_ptr<ControllerTwistReferenceMsg> message) {
        on_reference(message);
      });
  const rclcpp::SystemDefaultsQoS qos;
  odometry_publisher_ = std::make_unique<realtime_tools::RealtimePublisher<ControllerStateMsgOdom>>(
      node->create_publisher<ControllerStateMsgOdom>("~/odometry", qos));
  transform_publisher_ = std::make_unique<realtime_tools::RealtimePublisher<ControllerStateMsgTf>>(
      node->create_publisher<ControllerStateMsgTf>("~/tf_odometry", qos));
  status_publisher_ =
      std::make_unique<realtime_tools::RealtimePublisher<SteeringControllerStateMsg>>(
          node->create_publisher<SteeringControllerStateMsg>("~/controller_state", qos));
}

void SteeringControllersLibrary::prepare_messages() {
  odometry_message_.header.frame_id = params_.odom_frame_id;
  odometry_message_.child_frame_id = params_.base_frame_id;
  for (size_t i = 0; i < 6; ++i) {
    odometry_message_.pose.covariance[7 * i] = params_.pose_covariance_diagonal[i];
    odometry_message_.twist.covariance[7 * i] = params_.twist_covariance_diagonal[i];
  }
  transform_message_.transforms.resize(1);
  transform_message_.transforms[0].header.frame_id = params_.odom_frame_id;
  transform_message_.transforms[0].child_frame_id = params_.base_frame_id;
  status_message_.header.frame_id = params_.odom_frame_id;
}

void SteeringControllersLibrary::on_reference(
    const std::shared_ptr<ControllerTwistReferenceMsg>& message) {
  const auto logger = get_node()->get_logger();
  auto& stamp = message->header.stamp;
  if (stamp.sec == 0 && stamp.nanosec == 0u) {
    RCLCPP_WARN(logger, "Timestamp in header is missing, using current time as command timestamp.");
    stamp = get_node()->now();
  }
  const rclcpp::Duration age = get_node()->now() - stamp;
  if (ref_timeout_.nanoseconds() == 0 || age <= ref_timeout_) {
    input_ref_.set(*message);
    return;
  }
  RCLCPP_ERROR(logger,
               "Received message has timestamp %.10f older for %.10f which is more then allowed "
               "timeout (%.4f).",
               rclcpp::Time(stamp).seconds(), age.seconds(), ref_timeout_.seconds());
}

void SteeringControllersLibrary::forget_reference() {
  current_ref_ = ControllerTwistReferenceMsg();
  current_ref_.header.stamp = get_node()->now();
  current_ref_.twist.linear.x = current_ref_.twist.angular.z = kNotANumber;
  input_ref_.try_set(current_ref_);
}

InterfaceConfiguration SteeringControllersLibrary::command_interface_configuration() const {
  InterfaceConfiguration wanted{interface_configuration_type::INDIVIDUAL, {}};
  for (const std::string& joint : params_.traction_joints_names) {
    wanted.names.push_back(joint + "/" + HW_IF_VELOCITY);
  }
  for (const std::string& joint : params_.steering_joints_names) {
    wanted.names.push_back(joint + "/" + HW_IF_POSITION);
  }
  return wanted;
}

InterfaceConfiguration SteeringControllersLibrary::state_interface_configuration() const {
  InterfaceConfiguration wanted{interface_configuration_type::INDIVIDUAL, {}};
  for (const std::string& joint : traction_states_) {
    wanted.names.push_back(joint + "/" +
                           (params_.position_feedback ? HW_IF_POSITION : HW_IF_VELOCITY));
  }
  for (const std::string& joint : steering_states_) {
    wanted.names.push_back(joint + "/" + HW_IF_POSITION);
  }
  return wanted;
}

std::vector<hardware_interface::CommandInterface::SharedPtr>
SteeringControllersLibrary::on_export_reference_interfaces_list() {
  std::vector<hardware_interface::CommandInterface::SharedPtr> references;
  for (const char* axis : {"/linear", "/angular"}) {
    references.push_back(std::make_shared<hardware_interface::CommandInterface>(
        get_node()->get_name() + std::string(axis), HW_IF_VELOCITY));
  }
  return references;
}

bool SteeringControllersLibrary::on_set_chained_mode(bool) {
  return true;
}

CallbackReturn SteeringControllersLibrary::on_activate(const rclcpp_lifecycle::State&) {
  forget_reference();
  return CallbackReturn::SUCCESS;
}

CallbackReturn SteeringControllersLibrary::on_deactivate(const rclcpp_lifecycle::State&) {
  for (size_t i = 0; i < command_interfaces_.size(); ++i) {
    if (command_interfaces_[i].set_value(kNotANumber)) continue;
    RCLCPP_WARN(get_node()->get_logger(),
                "Failed to set NaN value for command interface '%s' (index %zu) during "
                "deactivation.",
                command_interfaces_[i].get_name().c_str(), i);
  }
  return CallbackReturn::SUCCESS;
}

}  // namespace steering_controllers_library
