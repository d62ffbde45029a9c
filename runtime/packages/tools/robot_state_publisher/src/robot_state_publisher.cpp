// See robot_state_publisher.hpp.
#include "robot_state_publisher/robot_state_publisher.hpp"

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "rclcpp_components/register_node_macro.hpp"

namespace robot_state_publisher {
namespace {

bool is_frequency(double hertz) {
  return hertz > 0 && hertz <= 1000;
}

std::string text_of_file(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) {
    throw std::system_error(errno, std::system_category(), "Failed to open URDF file: " + path);
  }
  return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace

RobotStatePublisher::RobotStatePublisher(const rclcpp::NodeOptions& options)
    : rclcpp::Node("robot_state_publisher", options) {
  auto description = declare_parameter<std::string>("robot_description", "");
  if (description.empty()) {
    try {
      description = described_by(options.arguments());
      set_parameter(rclcpp::Parameter("robot_description", description));
    } catch (const std::runtime_error& error) {
      RCLCPP_FATAL(get_logger(), "%s", error.what());
      throw;
    }
  }
  publish_frequency_ = declare_parameter("publish_frequency", 20.0);
  if (!is_frequency(publish_frequency_)) {
    throw std::runtime_error("publish_frequency must be between 0 and 1000");
  }
  frame_prefix_ = declare_parameter<std::string>("frame_prefix", "");
  ignore_timestamp_ = declare_parameter("ignore_timestamp", false);

  tf_broadcaster_ = std::make_unique<tf2_ros::TransformBroadcaster>(*this);
  static_tf_broadcaster_ = std::make_unique<tf2_ros::StaticTransformBroadcaster>(*this);
  description_pub_ = create_publisher<std_msgs::msg::String>("robot_description",
                                                             rclcpp::QoS(1).transient_local());
  setupURDF(description);

  rclcpp::SubscriptionOptions subscription_options;
  subscription_options.qos_overriding_options =
      rclcpp::QosOverridingOptions::with_default_policies();
  joint_state_sub_ = create_subscription<sensor_msgs::msg::JointState>(
      "joint_states", rclcpp::SensorDataQoS(),
      [this](const sensor_msgs::msg::JointState::ConstSharedPtr state) {
        callbackJointState(state);
      },
      subscription_options);
  publishFixedTransforms();
  param_cb_ = add_on_set_parameters_callback(
      [this](const std::vector<rclcpp::Parameter>& changed) { return parameterUpdate(changed); });
  param_taken_cb_ = add_post_set_parameters_callback(
      [this](const std::vector<rclcpp::Parameter>& changed) { takeParameters(changed); });
}

/// Reads the description from the path after the program's name, as older launch files give it.
std::string RobotStatePublisher::described_by(const std::vector<std::string>& arguments) const {
  if (arguments.size() < 2) {
    throw std::runtime_error("robot_description parameter must not be empty");
  }
  RCLCPP_WARN(get_logger(),
              "No robot_description parameter, but command-line argument available.  Assuming "
              "argument is name of URDF file.  This backwards compatibility fallback will be "
              "removed in the future.");
  return text_of_file(arguments[1]);
}

void RobotStatePublisher::setupURDF(const std::string& urdf_xml) {
  kinematics_ = read_kinematics(urdf_xml);
  std_msgs::msg::String message;
  message.data = urdf_xml;
  description_pub_->publish(message);
  RCLCPP_INFO(get_logger(), "Robot initialized");
}

geometry_msgs::msg::TransformStamped RobotStatePublisher::transform_of(
    const Segment& segment, double position, const rclcpp::Time& stamp) const {
  const urdf::Pose pose = segment.pose(position);
  geometry_msgs::msg::TransformStamped result;
  result.header.stamp = stamp;
  result.header.frame_id = frame_prefix_ + segment.root;
  result.child_frame_id = frame_prefix_ + segment.tip;
  result.transform.translation.x = pose.position.x;
  result.transform.translation.y = pose.position.y;
  result.transform.translation.z = pose.position.z;
  result.transform.rotation.x = pose.rotation.x;
  result.transform.rotation.y = pose.rotation.y;
  result.transform.rotation.z = pose.rotation.z;
  result.transform.rotation.w = pose.rotation.w;
  return result;
}

void RobotStatePublisher::publishFixedTransforms() {
  RCLCPP_DEBUG(get_logger(), "Publishing transforms for fixed joints");
  std::vector<geometry_msgs::msg::TransformStamped> transforms;
  for (const auto& [joint, segment] : kinematics_.fixed) {
    transforms.push_back(transform_of(segment, 0, now()));
  }
  static_tf_broadcaster_->sendTransform(transforms);
}

void RobotStatePublisher::publishTransforms(const std::map<std::string, double>& joint_positions,
                                            const builtin_interfaces::msg::Time& time) {
  RCLCPP_DEBUG(get_logger(), "Publishing transforms for moving joints");
  std::vector<geometry_msgs::msg::TransformStamped> transforms;
  for (const auto& [joint, position] : joint_positions) {
    if (const auto segment = kinematics_.moving.find(joint); segment != kinematics_.moving.end()) {
      transforms.push_back(transform_of(segment->second, position, time));
    }
  }
  tf_broadcaster_->sendTransform(transforms);
}

void RobotStatePublisher::callbackJointState(
    const sensor_msgs::msg::JointState::ConstSharedPtr state) {
  if (state->name.size() != state->position.size()) {
    if (state->position.empty()) {
      RCLCPP_WARN(get_logger(),
                  "Robot state publisher ignored a JointState message about joint(s) "
                  "\"%s\"(,...) whose position member was empty.",
                  state->name.front().c_str());
    } else {
      RCLCPP_ERROR(get_logger(), "Robot state publisher ignored an invalid JointState message");
    }
    return;
  }
  const rclcpp::Time now(get_clock()->now().nanoseconds());
  if (last_callback_time_ > now) {
    RCLCPP_WARN(get_logger(), "Moved backwards in time, re-publishing joint transforms!");
    last_publish_time_.clear();
  }
  last_callback_time_ = now;

  // A joint is told as often as publish_frequency says; the one told longest ago decides.
  rclcpp::Time oldest = now;
  for (const std::string& name : state->name) {
    oldest = std::min(oldest, last_publish_time_[name]);
  }
  const auto interval = std::chrono::milliseconds(static_cast<int64_t>(1000 / publish_frequency_));
  const rclcpp::Time stamp(rclcpp::Time(state->header.stamp).nanoseconds());
  if (!ignore_timestamp_ && stamp < oldest + rclcpp::Duration(interval)) {
    return;
  }
  std::map<std::string, double> positions;
  for (size_t i = 0; i < state->name.size(); ++i) {
    positions.emplace(state->name[i], state->position[i]);
    last_publish_time_[state->name[i]] = stamp;
  }
  for (const auto& [joint, mimic] : kinematics_.mimic) {
    if (const auto found = positions.find(mimic.joint_name); found != positions.end()) {
      positions.emplace(joint, found->second * mimic.multiplier + mimic.offset);
    }
  }
  publishTransforms(positions, state->header.stamp);
}

rcl_interfaces::msg::SetParametersResult RobotStatePublisher::parameterUpdate(
    const std::vector<rclcpp::Parameter>& parameters) {
  rcl_interfaces::msg::SetParametersResult result;
  result.successful = true;
  const auto refuse = [&result](const std::string& reason) {
    result.successful = false;
    result.reason = reason;
  };
  for (const rclcpp::Parameter& parameter : parameters) {
    if (parameter.get_name() == "robot_description") {
      if (parameter.as_string().empty()) {
        refuse("Empty URDF is not allowed");
        break;
      }
      try {
        read_kinematics(parameter.as_string());
      } catch (const std::runtime_error& error) {
        RCLCPP_WARN(get_logger(), "%s", error.what());
        refuse(error.what());
      }
    } else if (parameter.get_name() == "publish_frequency" &&
               !is_frequency(parameter.as_double())) {
      refuse("publish_frequency must be between 0.0 (exclusive) and 1000.0");
    }
  }
  return result;
}

void RobotStatePublisher::takeParameters(const std::vector<rclcpp::Parameter>& parameters) {
  for (const rclcpp::Parameter& parameter : parameters) {
    const std::string& name = parameter.get_name();
    if (name == "robot_description") {
      setupURDF(parameter.as_string());
      publishFixedTransforms();
    } else if (name == "publish_frequency") {
      publish_frequency_ = parameter.as_double();
    } else if (name == "frame_prefix") {
      frame_prefix_ = parameter.as_string();
    } else if (name == "ignore_timestamp") {
      ignore_timestamp_ = parameter.as_bool();
    }
  }
}

}  // namespace robot_state_publisher

RCLCPP_COMPONENTS_REGISTER_NODE(robot_state_publisher::RobotStatePublisher)
