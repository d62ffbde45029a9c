// See filter_parameters.hpp.
#include "node/filter_parameters.hpp"

#include <initializer_list>
#include <stdexcept>
#include <string_view>

namespace robot_localization {
namespace {

[[noreturn]] void refuse(rclcpp::Node& node, const std::string& error) {
  RCLCPP_FATAL(node.get_logger(), "%s", error.c_str());
  throw std::invalid_argument(error);
}

/// A parameter without a default, when it is set.
template <typename T>
std::optional<T> optional_parameter(rclcpp::Node& node, const std::string& name,
                                    rclcpp::ParameterType type) {
  node.declare_parameter(name, type);
  T value;
  if (!node.get_parameter(name, value)) return std::nullopt;
  return value;
}

std::optional<Covariance> read_covariance(rclcpp::Node& node, const std::string& name) {
  const auto values = optional_parameter<std::vector<double>>(
      node, name, rclcpp::ParameterType::PARAMETER_DOUBLE_ARRAY);
  if (!values) return std::nullopt;
  Covariance result = Covariance::Zero();
  if (values->size() == kStateSize) {
    RCLCPP_INFO(node.get_logger(),
                "Detected a %s parameter with length %d. Assuming diagonal values specified.",
                name.c_str(), kStateSize);
    result.diagonal() = State::Map(values->data());
  } else if (values->size() == kStateSize * kStateSize) {
    result = Covariance::Map(values->data());
  } else {
    refuse(node, "Invalid " + name + " specified. Expected a length of " +
                     std::to_string(kStateSize) + " or " + std::to_string(kStateSize * kStateSize) +
                     ", received length " + std::to_string(values->size()));
  }
  if (!result.allFinite()) refuse(node, name + " has values that are not finite");
  return result;
}

std::optional<State> read_initial_state(rclcpp::Node& node) {
  const auto values = optional_parameter<std::vector<double>>(
      node, "initial_state", rclcpp::ParameterType::PARAMETER_DOUBLE_ARRAY);
  if (!values) return std::nullopt;
  if (values->size() != kStateSize) {
    RCLCPP_ERROR(node.get_logger(),
                 "Initial state must be of size %d. Provided config was of size %zu. The initial "
                 "state will be ignored.",
                 kStateSize, values->size());
    return std::nullopt;
  }
  return State(State::Map(values->data()));
}

Variables read_config(rclcpp::Node& node, const std::string& name) {
  const auto flags = node.declare_parameter(name + "_config", std::vector<bool>(kStateSize, false));
  if (flags.size() != kStateSize) {
    refuse(node, name + "_config must have " + std::to_string(kStateSize) + " values, it has " +
                     std::to_string(flags.size()));
  }
  Variables result;
  for (int i = 0; i < kStateSize; ++i) result[i] = flags[i];
  return result;
}

/// The parameters that every kind of input has.
std::optional<InputParameters> read_input(rclcpp::Node& node, const std::string& name,
                                          bool has_pose) {
  const auto topic =
      optional_parameter<std::string>(node, name, rclcpp::ParameterType::PARAMETER_STRING);
  if (!topic) return std::nullopt;
  InputParameters input{.name = name, .topic = *topic};
  if (has_pose) {
    input.is_differential = node.declare_parameter(name + "_differential", false);
    input.is_relative = node.declare_parameter(name + "_relative", false);
    if (input.is_differential && input.is_relative) {
      RCLCPP_ERROR(node.get_logger(),
                   "Both %s_differential and %s_relative were set to true. Using differential "
                   "mode.",
                   name.c_str(), name.c_str());
      input.is_relative = false;
    }
  }
  input.queue_size = static_cast<int>(node.declare_parameter(name + "_queue_size", 10));
  if (input.queue_size < 1) refuse(node, name + "_queue_size must be at least 1");
  input.config = read_config(node, name);
  return input;
}

void warn_when_unused(rclcpp::Node& node, const InputParameters& input, const char* what) {
  if (input.config.any()) return;
  RCLCPP_ERROR(node.get_logger(),
               "Warning: %s is listed as an input topic, but all %supdate variables are false",
               input.topic.c_str(), what);
}

InputParameters odom_of(rclcpp::Node& node, InputParameters input) {
  const std::string& name = input.name;
  input.is_pose_of_child = node.declare_parameter(name + "_pose_use_child_frame", false);
  input.pose_threshold = node.declare_parameter(name + "_pose_rejection_threshold", kNoThreshold);
  input.twist_threshold = node.declare_parameter(name + "_twist_rejection_threshold", kNoThreshold);
  input.config &= (kPoseVariables | kTwistVariables);
  return input;
}

InputParameters pose_of(rclcpp::Node& node, InputParameters input) {
  input.pose_threshold = node.declare_parameter(input.name + "_rejection_threshold", kNoThreshold);
  input.config &= kPoseVariables;
  warn_when_unused(node, input, "pose ");
  return input;
}

InputParameters twist_of(rclcpp::Node& node, InputParameters input) {
  input.twist_threshold = node.declare_parameter(input.name + "_rejection_threshold", kNoThreshold);
  input.config &= kTwistVariables;
  warn_when_unused(node, input, "twist ");
  return input;
}

InputParameters imu_of(rclcpp::Node& node, InputParameters input) {
  const std::string& name = input.name;
  input.pose_threshold = node.declare_parameter(name + "_pose_rejection_threshold", kNoThreshold);
  input.twist_threshold = node.declare_parameter(name + "_twist_rejection_threshold", kNoThreshold);
  input.acceleration_threshold =
      node.declare_parameter(name + "_linear_acceleration_rejection_threshold", kNoThreshold);
  input.removes_gravity =
      node.declare_parameter(name + "_remove_gravitational_acceleration", false);
  const std::pair<int, const char*> missing[] = {{kX, "positional"}, {kVx, "linear velocity"}};
  for (const auto& [begin, what] : missing) {
    if (!(input.config & three_from(begin)).any()) continue;
    RCLCPP_WARN(node.get_logger(),
                "Warning: Some position entries in parameter %s_config are set to true, but the "
                "sensor_msgs/Imu message contains no %s data",
                name.c_str(), what);
  }
  input.config &= (three_from(kRoll) | three_from(kVroll) | three_from(kAx));
  warn_when_unused(node, input, "");
  return input;
}

/// `odom0`, `odom1` and so on; the first that is not set ends the list.
std::vector<InputParameters> read_inputs(rclcpp::Node& node, const std::string& kind,
                                         InputParameters (*complete)(rclcpp::Node&,
                                                                     InputParameters)) {
  std::vector<InputParameters> inputs;
  while (true) {
    auto input = read_input(node, kind + std::to_string(inputs.size()), kind != "twist");
    if (!input) return inputs;
    inputs.push_back(complete(node, std::move(*input)));
  }
}

using Axes = std::array<double, kTwistSize>;

std::optional<std::vector<double>> read_axes(rclcpp::Node& node, const char* name) {
  return optional_parameter<std::vector<double>>(node, name,
                                                 rclcpp::ParameterType::PARAMETER_DOUBLE_ARRAY);
}

Axes axes_of(const std::vector<double>& values) {
  Axes result{};
  std::copy_n(values.begin(), kTwistSize, result.begin());
  return result;
}

/// Limits without which nothing is controlled. False for a wrong number of them.
bool read_limits(rclcpp::Node& node, const std::string& what, const char* name, Axes& limits) {
  const auto values = read_axes(node, name);
  if (!values) {
    const bool is_first = what == "Acceleration";
    if (is_first) {
      RCLCPP_ERROR(node.get_logger(),
                   "use_control is set to true, but acceleration_limits is missing. Will use "
                   "default values.");
    } else {
      RCLCPP_WARN(node.get_logger(),
                  "use_control is set to true, but no deceleration_limits specified. Will use "
                  "acceleration limits.");
    }
    return true;
  }
  if (values->size() != kTwistSize) {
    RCLCPP_ERROR(node.get_logger(),
                 "%s configuration must be of size %d. Provided config was of size %zu. No "
                 "control term will be used.",
                 what.c_str(), kTwistSize, values->size());
    return false;
  }
  limits = axes_of(*values);
  return true;
}

void read_gains(rclcpp::Node& node, const std::string& what, const char* name, Axes& gains) {
  const auto values = read_axes(node, name);
  if (!values) {
    if (what == "Deceleration") {
      RCLCPP_WARN(node.get_logger(),
                  "use_control is set to true, but no deceleration_gains specified. Will use "
                  "acceleration gains.");
    }
    return;
  }
  if (values->size() == kTwistSize) {
    gains = axes_of(*values);
    return;
  }
  RCLCPP_ERROR(node.get_logger(),
               "%s gain configuration must be of size %d. Provided config was of size %zu. All "
               "gains will be assumed to be 1.",
               what.c_str(), kTwistSize, values->size());
  gains.fill(1.0);
}

std::optional<ControlModel> read_control(rclcpp::Node& node) {
  const bool is_used = node.declare_parameter("use_control", false);
  ControlModel model;
  const double timeout = node.declare_parameter("control_timeout", 0.0);
  model.timeout_ns = rclcpp::Duration::from_seconds(timeout).nanoseconds();
  if (!is_used) return std::nullopt;
  const auto config = optional_parameter<std::vector<bool>>(
      node, "control_config", rclcpp::ParameterType::PARAMETER_BOOL_ARRAY);
  model.acceleration_limits.fill(1.0);
  model.acceleration_gains.fill(1.0);
  bool is_usable =
      read_limits(node, "Acceleration", "acceleration_limits", model.acceleration_limits);
  read_gains(node, "Acceleration", "acceleration_gains", model.acceleration_gains);
  model.deceleration_limits = model.acceleration_limits;
  model.deceleration_gains = model.acceleration_gains;
  is_usable &= read_limits(node, "Deceleration", "deceleration_limits", model.deceleration_limits);
  read_gains(node, "Deceleration", "deceleration_gains", model.deceleration_gains);
  if (!config) {
    RCLCPP_ERROR(node.get_logger(),
                 "use_control is set to true, but control_config is missing. No control term will "
                 "be used.");
    return std::nullopt;
  }
  if (config->size() != kTwistSize) {
    RCLCPP_ERROR(node.get_logger(),
                 "Control configuration must be of size %d. Provided config was of size %zu. No "
                 "control term will be used.",
                 kTwistSize, config->size());
    return std::nullopt;
  }
  if (!is_usable) return std::nullopt;
  for (int i = 0; i < kTwistSize; ++i) model.axes[i] = (*config)[i];
  return model;
}

/// An acceleration that is measured cannot be that of the control.
void leave_out_measured_axes(rclcpp::Node& node, FilterParameters& parameters) {
  if (!parameters.control) return;
  ControlModel& control = *parameters.control;
  for (const InputParameters& imu : parameters.imus) {
    for (int axis = 0; axis < 3; ++axis) {
      if (!control.axes[axis] || !imu.config[kAx + axis]) continue;
      const char name = "XYZ"[axis];
      RCLCPP_ERROR(node.get_logger(),
                   "%c acceleration is being measured from IMU; %c velocity control input is "
                   "disabled",
                   name, name);
      control.axes.reset(axis);
    }
  }
  if (control.axes.any()) return;
  RCLCPP_ERROR(node.get_logger(),
               "use_control is set to true, but control_config has only false values. No control "
               "term will be used.");
  parameters.control.reset();
}

void read_frames(rclcpp::Node& node, FilterParameters& out) {
  out.map_frame = node.declare_parameter("map_frame", "map");
  out.odom_frame = node.declare_parameter("odom_frame", "odom");
  out.base_link_frame = node.declare_parameter("base_link_frame", "base_link");
  out.base_link_frame_output =
      node.declare_parameter("base_link_frame_output", out.base_link_frame);
  out.world_frame = node.declare_parameter("world_frame", out.odom_frame);
  if (out.map_frame == out.odom_frame || out.odom_frame == out.base_link_frame ||
      out.map_frame == out.base_link_frame || out.odom_frame == out.base_link_frame_output ||
      out.map_frame == out.base_link_frame_output) {
    RCLCPP_ERROR(node.get_logger(),
                 "Invalid frame configuration! The values for map_frame, odom_frame, and "
                 "base_link_frame must be unique. If using a base_link_frame_output values, it "
                 "must not match the map_frame or odom_frame.");
  }
  std::string prefix =
      optional_parameter<std::string>(node, "tf_prefix", rclcpp::ParameterType::PARAMETER_STRING)
          .value_or("");
  if (prefix.starts_with('/')) prefix.erase(0, 1);
  if (prefix.empty()) return;
  for (std::string* frame : {&out.map_frame, &out.odom_frame, &out.base_link_frame,
                             &out.base_link_frame_output, &out.world_frame}) {
    if (frame->starts_with('/')) frame->erase(0, 1);
    *frame = prefix + "/" + *frame;
  }
}

double read_frequency(rclcpp::Node& node) {
  const double frequency = node.declare_parameter("frequency", 30.0);
  if (!(frequency > 0.0 && frequency <= 1000.0)) {
    refuse(node, "frequency must be greater than 0 and at most 1000 Hz");
  }
  return frequency;
}

double read_history_length(rclcpp::Node& node, bool smooths) {
  const double length = node.declare_parameter("history_length", 0.0);
  if (!smooths && std::abs(length) > 0.0) {
    RCLCPP_ERROR(node.get_logger(),
                 "Filter history interval of %g specified, but smooth_lagged_data is set to "
                 "false. Lagged data will not be smoothed.",
                 length);
  }
  if (smooths && length < 0.0) {
    RCLCPP_ERROR(node.get_logger(),
                 "Negative history interval of %g specified. Absolute value will be assumed.",
                 length);
  }
  return std::abs(length);
}

}  // namespace

FilterParameters read_parameters(rclcpp::Node& node) {
  FilterParameters out;
  out.prints_diagnostics = node.declare_parameter("print_diagnostics", false);
  out.gravity = node.declare_parameter("gravitational_acceleration", out.gravity);
  if (node.declare_parameter("debug", false)) {
    RCLCPP_WARN(node.get_logger(), "debug is set to true, but this node writes no debug file");
  }
  node.declare_parameter("debug_out_file", "robot_localization_debug.txt");
  read_frames(node, out);
  out.publishes_tf = node.declare_parameter("publish_tf", true);
  out.publishes_acceleration = node.declare_parameter("publish_acceleration", false);
  out.permits_corrected_publication = node.declare_parameter("permit_corrected_publication", false);
  out.transform_time_offset = node.declare_parameter("transform_time_offset", 0.0);
  out.transform_timeout = node.declare_parameter("transform_timeout", 0.0);
  out.frequency = read_frequency(node);
  out.predicts_to_current_time = node.declare_parameter("predict_to_current_time", false);
  out.sensor_timeout = node.declare_parameter("sensor_timeout", 1.0 / out.frequency);
  out.is_two_d = node.declare_parameter("two_d_mode", false);
  out.smooths_lagged_data = node.declare_parameter("smooth_lagged_data", false);
  out.history_length = read_history_length(node, out.smooths_lagged_data);
  out.resets_on_time_jump = node.declare_parameter("reset_on_time_jump", false);
  out.control = read_control(node);
  out.is_control_stamped = node.declare_parameter("stamped_control", false);
  out.is_noise_dynamic = node.declare_parameter("dynamic_process_noise_covariance", false);
  out.initial_state = read_initial_state(node);
  out.is_disabled_at_startup = node.declare_parameter("disabled_at_startup", false);
  out.odoms = read_inputs(node, "odom", odom_of);
  out.poses = read_inputs(node, "pose", pose_of);
  out.twists = read_inputs(node, "twist", twist_of);
  out.imus = read_inputs(node, "imu", imu_of);
  leave_out_measured_axes(node, out);
  out.process_noise = read_covariance(node, "process_noise_covariance");
  out.initial_covariance = read_covariance(node, "initial_estimate_covariance");
  return out;
}

}  // namespace robot_localization
