// See amcl_node.hpp. Parameters: declared, read and changed by the table of parameter_table.hpp.
#include <algorithm>
#include <cstdint>
#include <limits>
#include <string>
#include <type_traits>
#include <utility>

#include "nav2_amcl/amcl_node.hpp"
#include "nav2_util/string_utils.hpp"
#include "parameter_table.hpp"

namespace nav2_amcl {
namespace {

template <typename Visit>
void for_each_table(Visit visit) {
  visit(double_parameters());
  visit(integer_parameters());
  visit(bool_parameters());
  visit(string_parameters());
}

/// More would not fit into the memory of a page, and one update would take seconds.
constexpr int kMostParticles = 1'000'000;

/// A whole number of ROS has 64 bits.
int narrowed(int64_t value) {
  return static_cast<int>(
      std::clamp<int64_t>(value, std::numeric_limits<int>::min(), std::numeric_limits<int>::max()));
}

template <typename T>
T value_of(const rclcpp::Parameter& parameter) {
  if constexpr (std::is_same_v<T, int>) {
    return narrowed(parameter.as_int());
  } else {
    return parameter.get_value<T>();
  }
}

/// Takes over the value of a parameter that may change at any time.
template <typename T>
void change(const std::vector<ParameterRow<T>>& rows, const rclcpp::Parameter& parameter,
            AmclParameters& parameters, Renewal& renewal) {
  for (const ParameterRow<T>& row : rows) {
    if (parameter.get_name() != row.name || !row.is_dynamic) continue;
    // A value of another type never arrives here: the type of a declared parameter is fixed.
    row.place(parameters) = value_of<T>(parameter);
    if (row.renews != nullptr) renewal.*row.renews = true;
  }
}

void strip_slashes(AmclParameters& parameters) {
  for (std::string* frame :
       {&parameters.odom_frame_id, &parameters.base_frame_id, &parameters.global_frame_id}) {
    *frame = nav2_util::strip_leading_slash(*frame);
  }
}

}  // namespace

void AmclNode::declareParameters() {
  for_each_table([this](const auto& rows) {
    for (const auto& row : rows) {
      add_parameter(row.name, rclcpp::ParameterValue(row.place(parameters_)), row.description);
    }
  });
}

void AmclNode::initParameters() {
  for_each_table([this](const auto& rows) {
    for (const auto& row : rows) {
      auto& place = row.place(parameters_);
      place = value_of<std::decay_t<decltype(place)>>(get_parameter(row.name));
    }
  });
  strip_slashes(parameters_);
  last_reminder_ = now();
  const auto warn = [this](const char* text) { RCLCPP_WARN(get_logger(), "%s", text); };
  FilterSettings& filter = parameters_.filter;
  if (parameters_.laser.likelihood_max_dist < 0) {
    warn(
        "You've set laser_likelihood_max_dist to be negative, this isn't allowed so it will be set "
        "to default value 2.0.");
    parameters_.laser.likelihood_max_dist = 2.0;
  }
  if (filter.max_particles < 0) {
    warn(
        "You've set max_particles to be negative, this isn't allowed so it will be set to default "
        "value 2000.");
    filter.max_particles = 2000;
  }
  if (filter.max_particles > kMostParticles) {
    RCLCPP_WARN(get_logger(), "max_particles is greater than %d, and will be set to that.",
                kMostParticles);
    filter.max_particles = kMostParticles;
    filter.min_particles = std::min(filter.min_particles, kMostParticles);
  }
  if (filter.min_particles < 0) {
    warn(
        "You've set min_particles to be negative, this isn't allowed so it will be set to default "
        "value 500.");
    filter.min_particles = 500;
  }
  if (filter.min_particles > filter.max_particles) {
    warn(
        "You've set min_particles to be greater than max particles, this isn't allowed so "
        "max_particles will be set to min_particles.");
    filter.max_particles = filter.min_particles;
  }
  if (parameters_.resample_interval <= 0) {
    warn(
        "You've set resample_interval to be zero or negative, this isn't allowed so it will be set "
        "to default value to 1.");
    parameters_.resample_interval = 1;
  }
  raiseNegativeAlphas(parameters_);
  if (parameters_.always_reset_initial_pose) initial_pose_is_known_ = false;
}

void AmclNode::raiseNegativeAlphas(AmclParameters& parameters) {
  const std::pair<const char*, double*> alphas[] = {{"alpha1", &parameters.alpha1},
                                                    {"alpha2", &parameters.alpha2},
                                                    {"alpha3", &parameters.alpha3},
                                                    {"alpha4", &parameters.alpha4},
                                                    {"alpha5", &parameters.alpha5}};
  for (const auto& [name, value] : alphas) {
    if (!(*value < 0.0)) continue;
    RCLCPP_WARN(get_logger(),
                "You've set %s to be negative, this isn't allowed, so the %s will be set to be "
                "zero.",
                name, name);
    *value = 0.0;
  }
}

std::string AmclNode::refusal(const AmclParameters& parameters) {
  if (parameters.filter.min_particles > parameters.filter.max_particles) {
    return "You've set min_particles to be greater than max particles, this isn't allowed.";
  }
  if (parameters.filter.max_particles > kMostParticles) {
    return "max_particles is greater than " + std::to_string(kMostParticles);
  }
  if (parameters.filter.min_particles < 0) return "min_particles is negative";
  if (parameters.resample_interval <= 0) return "resample_interval is not positive";
  if (parameters.laser.likelihood_max_dist < 0) return "laser_likelihood_max_dist is negative";
  if (parameters.robot_model_type != parameters_.robot_model_type &&
      !plugin_loader_.isClassAvailable(parameters.robot_model_type)) {
    return "robot_model_type is not a declared motion model: " + parameters.robot_model_type;
  }
  return "";
}

rcl_interfaces::msg::SetParametersResult AmclNode::dynamicParametersCallback(
    std::vector<rclcpp::Parameter> parameters) {
  const std::lock_guard<std::recursive_mutex> lock(mutex_);
  AmclParameters changed = parameters_;
  Renewal renewal;
  for (const rclcpp::Parameter& parameter : parameters) {
    for_each_table([&](const auto& rows) { change(rows, parameter, changed, renewal); });
  }
  strip_slashes(changed);
  rcl_interfaces::msg::SetParametersResult result;
  result.reason = refusal(changed);
  result.successful = result.reason.empty();
  if (!result.successful) {
    RCLCPP_ERROR(get_logger(), "%s", result.reason.c_str());
    return result;
  }
  if (renewal.odometry) raiseNegativeAlphas(changed);
  parameters_ = changed;
  renew(renewal);
  return result;
}

void AmclNode::renew(const Renewal& renewal) {
  if (renewal.odometry) initOdometry();
  if (renewal.filter) initParticleFilter();
  if (renewal.laser) {
    scanners_.clear();
    laser_scan_filter_.reset();
    laser_scan_sub_.reset();
    initMessageFilters();
  }
  if (renewal.map) subscribeToMap();
}

}  // namespace nav2_amcl
