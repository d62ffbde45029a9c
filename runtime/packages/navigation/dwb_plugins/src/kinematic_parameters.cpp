// See kinematic_parameters.hpp.
#include "dwb_plugins/kinematic_parameters.hpp"

#include <cmath>
#include <stdexcept>

#include "nav2_util/node_utils.hpp"

namespace dwb_plugins {

struct KinematicsHandler::Row {
  const char* name;
  double KinematicParameters::*value;
  double KinematicParameters::*base;  // null: a speed limit does not touch it
};

const std::vector<KinematicsHandler::Row>& KinematicsHandler::rows() {
  using Limits = KinematicParameters;
  static const std::vector<Row> result{
      {"min_vel_x", &Limits::min_vel_x_, nullptr},
      {"min_vel_y", &Limits::min_vel_y_, nullptr},
      {"max_vel_x", &Limits::max_vel_x_, &Limits::base_max_vel_x_},
      {"max_vel_y", &Limits::max_vel_y_, &Limits::base_max_vel_y_},
      {"max_vel_theta", &Limits::max_vel_theta_, &Limits::base_max_vel_theta_},
      {"min_speed_xy", &Limits::min_speed_xy_, nullptr},
      {"max_speed_xy", &Limits::max_speed_xy_, &Limits::base_max_speed_xy_},
      {"min_speed_theta", &Limits::min_speed_theta_, nullptr},
      {"acc_lim_x", &Limits::acc_lim_x_, nullptr},
      {"acc_lim_y", &Limits::acc_lim_y_, nullptr},
      {"acc_lim_theta", &Limits::acc_lim_theta_, nullptr},
      {"decel_lim_x", &Limits::decel_lim_x_, nullptr},
      {"decel_lim_y", &Limits::decel_lim_y_, nullptr},
      {"decel_lim_theta", &Limits::decel_lim_theta_, nullptr},
  };
  return result;
}

bool KinematicsHandler::write(KinematicParameters& kinematics, const Row& row, double value) {
  if (!std::isfinite(value)) return false;
  kinematics.*row.value = value;
  if (row.base != nullptr) kinematics.*row.base = value;
  kinematics.squareSpeeds();
  return true;
}

KinematicsHandler::KinematicsHandler() = default;

KinematicsHandler::~KinematicsHandler() {
  const auto node = node_.lock();
  if (dyn_params_handler_ && node) {
    node->remove_on_set_parameters_callback(dyn_params_handler_.get());
    node->get_node_parameters_interface()->remove_post_set_parameters_callback(
        post_set_handler_.get());
  }
}

void KinematicsHandler::initialize(const nav2_util::LifecycleNode::SharedPtr& nh,
                                   const std::string& plugin_name) {
  node_ = nh;
  plugin_name_ = plugin_name;
  KinematicParameters kinematics;
  for (const Row& row : rows()) {
    const std::string name = plugin_name + "." + row.name;
    nav2_util::declare_parameter_if_not_declared(nh, name, rclcpp::ParameterValue(0.0));
    if (!write(kinematics, row, nh->get_parameter(name).as_double())) {
      throw std::runtime_error(name + " must be a finite number");
    }
  }
  update_kinematics(kinematics);
  dyn_params_handler_ =
      nh->add_on_set_parameters_callback([this](std::vector<rclcpp::Parameter> parameters) {
        return dynamicParametersCallback(parameters);
      });
  // Another callback may refuse the change, so it is applied once all have accepted it.
  post_set_handler_ = nh->get_node_parameters_interface()->add_post_set_parameters_callback(
      [this](const std::vector<rclcpp::Parameter>& parameters) {
        KinematicParameters changed = getKinematics();
        if (change(changed, parameters).empty()) update_kinematics(changed);
      });
}

void KinematicsHandler::setSpeedLimit(const double& speed_limit, const bool& percentage) {
  if (!std::isfinite(speed_limit) || speed_limit < 0.0) {
    RCLCPP_ERROR(rclcpp::get_logger("DWBLocalPlanner"),
                 "A speed limit of %g is ignored: it must be finite and at least 0", speed_limit);
    return;
  }
  KinematicParameters kinematics = getKinematics();
  kinematics.limitSpeed(speed_limit, percentage);
  update_kinematics(kinematics);
}

rcl_interfaces::msg::SetParametersResult KinematicsHandler::dynamicParametersCallback(
    std::vector<rclcpp::Parameter> parameters) {
  rcl_interfaces::msg::SetParametersResult result;
  KinematicParameters kinematics = getKinematics();
  const std::string refused = change(kinematics, parameters);
  result.successful = refused.empty();
  if (!result.successful) result.reason = refused + " must be a finite number";
  return result;
}

std::string KinematicsHandler::change(KinematicParameters& kinematics,
                                      const std::vector<rclcpp::Parameter>& parameters) const {
  for (const rclcpp::Parameter& parameter : parameters) {
    if (parameter.get_type() != rclcpp::ParameterType::PARAMETER_DOUBLE) continue;
    for (const Row& row : rows()) {
      if (parameter.get_name() != plugin_name_ + "." + row.name) continue;
      if (!write(kinematics, row, parameter.as_double())) return parameter.get_name();
    }
  }
  return "";
}

void KinematicsHandler::update_kinematics(KinematicParameters kinematics) {
  const std::lock_guard<std::mutex> lock(mutex_);
  kinematics_ = kinematics;
}

}  // namespace dwb_plugins
