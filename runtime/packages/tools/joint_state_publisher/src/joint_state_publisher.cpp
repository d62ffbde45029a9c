// See joint_state_publisher.hpp.
#include "joint_state_publisher.hpp"

#include <fstream>
#include <iterator>
#include <map>
#include <stdexcept>

namespace joint_state_publisher {
namespace {

double number_of(const rclcpp::Parameter& parameter) {
  return parameter.get_type() == rclcpp::ParameterType::PARAMETER_INTEGER
             ? static_cast<double>(parameter.as_int())
             : parameter.as_double();
}

/// The joints that parameters named <joint>.parent, <joint>.factor and <joint>.offset describe.
std::map<std::string, DependentJoint> dependent_joints(
    const std::map<std::string, rclcpp::Parameter>& parameters) {
  std::map<std::string, DependentJoint> result;
  for (const auto& [name, parameter] : parameters) {
    const std::size_t dot = name.find('.');
    if (dot == std::string::npos || name.find('.', dot + 1) != std::string::npos) {
      throw std::runtime_error("Invalid dependent_joint name '" + name + "'");
    }
    DependentJoint& joint = result[name.substr(0, dot)];
    const std::string key = name.substr(dot + 1);
    if (key == "parent") {
      joint.parent = parameter.as_string();
    } else if (key == "factor") {
      joint.factor = number_of(parameter);
    } else if (key == "offset") {
      joint.offset = number_of(parameter);
    } else {
      throw std::runtime_error("Invalid dependent_joint name '" + key +
                               "' (allowed values are 'parent', 'factor', and 'offset')");
    }
  }
  for (const auto& [name, joint] : result) {
    if (!joint.parent) {
      throw std::runtime_error("All dependent_joints must at least have a parent");
    }
  }
  return result;
}

}  // namespace

JointStatePublisher::JointStatePublisher(const std::optional<std::string>& urdf_file)
    : rclcpp::Node("joint_state_publisher",
                   rclcpp::NodeOptions().automatically_declare_parameters_from_overrides(true)) {
  // Those that somebody set are declared already.
  const auto declare = [this](const std::string& name, const rclcpp::ParameterValue& value) {
    if (!has_parameter(name)) {
      declare_parameter(name, value);
    }
    return get_parameter(name);
  };
  const auto flag = [&declare](const std::string& name, bool value) {
    return declare(name, rclcpp::ParameterValue(value)).as_bool();
  };
  JointOptions options;
  options.publish_efforts = flag("publish_default_efforts", false);
  options.publish_positions = flag("publish_default_positions", true);
  options.publish_velocities = flag("publish_default_velocities", false);
  options.use_mimic = flag("use_mimic_tags", true);
  options.use_smallest_limits = flag("use_smallest_joint_limits", true);
  const double rate = number_of(declare("rate", rclcpp::ParameterValue(10)));
  if (!(rate > 0)) {
    throw std::runtime_error("rate must be greater than 0");
  }
  delta_ = number_of(declare("delta", rclcpp::ParameterValue(0.0)));
  const auto sources =
      declare("source_list", rclcpp::ParameterValue(std::vector<std::string>{})).as_string_array();
  std::map<std::string, rclcpp::Parameter> zeros;
  get_parameters("zeros", zeros);
  for (const auto& [name, zero] : zeros) {
    options.zeros[name] = number_of(zero);
  }
  std::map<std::string, rclcpp::Parameter> dependent;
  get_parameters("dependent_joints", dependent);
  options.dependent = dependent_joints(dependent);
  joints_.emplace(std::move(options));

  if (urdf_file) {
    std::ifstream file(*urdf_file);
    if (!file) {
      throw std::runtime_error("No such file or directory: '" + *urdf_file + "'");
    }
    configure(std::string(std::istreambuf_iterator<char>(file), {}));
  } else {
    RCLCPP_INFO(get_logger(),
                "Waiting for robot_description to be published on the robot_description topic...");
    description_ = create_subscription<std_msgs::msg::String>(
        "robot_description", rclcpp::QoS(1).transient_local(),
        [this](const std_msgs::msg::String& message) { configure(message.data); });
  }
  for (const std::string& source : sources) {
    sources_.push_back(create_subscription<sensor_msgs::msg::JointState>(
        source, 10, [this](const sensor_msgs::msg::JointState& state) { joints_->take(state); }));
  }
  publisher_ = create_publisher<sensor_msgs::msg::JointState>("joint_states", 10);
  timer_ = rclcpp::create_timer(this, get_clock(),
                                rclcpp::Duration(std::chrono::duration<double>(1.0 / rate)),
                                [this] { publish(); });
}

void JointStatePublisher::configure(const std::string& description) {
  RCLCPP_DEBUG(get_logger(), "Got description, configuring robot");
  try {
    joints_->configure(description, [this](const std::string& text) {
      RCLCPP_WARN(get_logger(), "%s", text.c_str());
    });
  } catch (const std::runtime_error&) {
    RCLCPP_WARN(get_logger(), "Invalid robot_description given, ignoring");
  }
}

void JointStatePublisher::publish() {
  if (delta_ > 0) {
    joints_->move(delta_);
  }
  auto state = joints_->state();
  if (state.name.empty()) {
    return;
  }
  state.header.stamp = now();
  publisher_->publish(state);
}

}  // namespace joint_state_publisher
