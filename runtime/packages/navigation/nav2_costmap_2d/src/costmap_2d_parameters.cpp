// The parameters of the node of a costmap.
#include <stdexcept>
#include <utility>

#include "nav2_costmap_2d/costmap_2d_ros.hpp"
#include "nav2_util/node_utils.hpp"

namespace nav2_costmap_2d {
namespace {

/// A page has 4 GiB of memory at most, and each layer has as many cells, of a byte each.
constexpr double kMostCells = 1e8;

/// Why a costmap cannot have this size; empty: it can. Metres.
std::string problem_of(double width, double height, double resolution) {
  for (const auto& [name, value] : {std::pair("width", width), std::pair("height", height)}) {
    if (value > 0) continue;
    return std::string("You try to set ") + name +
           " of map to be negative or zero, this isn't allowed, please give a positive value.";
  }
  if (resolution > 0 && width / resolution * (height / resolution) <= kMostCells) return "";
  return "The parameter resolution must be a length in metres with which the costmap has at most "
         "100,000,000 cells";
}

}  // namespace

void Costmap2DROS::init() {
  RCLCPP_INFO(get_logger(), "Creating Costmap");
  declare_parameter("always_send_full_costmap", rclcpp::ParameterValue(false));
  declare_parameter("map_vis_z", rclcpp::ParameterValue(0.0));
  declare_parameter("footprint_padding", rclcpp::ParameterValue(0.01));
  declare_parameter("footprint", rclcpp::ParameterValue(std::string("[]")));
  declare_parameter("global_frame", rclcpp::ParameterValue(std::string("map")));
  declare_parameter("height", rclcpp::ParameterValue(5));
  declare_parameter("width", rclcpp::ParameterValue(5));
  declare_parameter("lethal_cost_threshold", rclcpp::ParameterValue(100));
  declare_parameter("observation_sources", rclcpp::ParameterValue(std::string("")));
  declare_parameter("origin_x", rclcpp::ParameterValue(0.0));
  declare_parameter("origin_y", rclcpp::ParameterValue(0.0));
  declare_parameter("plugins", rclcpp::ParameterValue(default_plugins_));
  declare_parameter("filters", rclcpp::ParameterValue(std::vector<std::string>()));
  declare_parameter("publish_frequency", rclcpp::ParameterValue(1.0));
  declare_parameter("resolution", rclcpp::ParameterValue(0.1));
  declare_parameter("robot_base_frame", rclcpp::ParameterValue(std::string("base_link")));
  declare_parameter("robot_radius", rclcpp::ParameterValue(0.1));
  declare_parameter("rolling_window", rclcpp::ParameterValue(false));
  declare_parameter("track_unknown_space", rclcpp::ParameterValue(false));
  declare_parameter("transform_tolerance", rclcpp::ParameterValue(0.3));
  declare_parameter("initial_transform_timeout", rclcpp::ParameterValue(60.0));
  declare_parameter("trinary_costmap", rclcpp::ParameterValue(true));
  declare_parameter("unknown_cost_value", rclcpp::ParameterValue(255));
  declare_parameter("update_frequency", rclcpp::ParameterValue(5.0));
  declare_parameter("use_maximum", rclcpp::ParameterValue(false));
}

void Costmap2DROS::getParameters() {
  get_parameter("always_send_full_costmap", always_send_full_costmap_);
  get_parameter("map_vis_z", map_vis_z_);
  get_parameter("footprint", footprint_);
  get_parameter("footprint_padding", footprint_padding_);
  get_parameter("global_frame", global_frame_);
  get_parameter("height", map_height_meters_);
  get_parameter("width", map_width_meters_);
  get_parameter("origin_x", origin_x_);
  get_parameter("origin_y", origin_y_);
  get_parameter("publish_frequency", map_publish_frequency_);
  get_parameter("resolution", resolution_);
  get_parameter("robot_base_frame", robot_base_frame_);
  get_parameter("robot_radius", robot_radius_);
  get_parameter("rolling_window", rolling_window_);
  get_parameter("track_unknown_space", track_unknown_space_);
  get_parameter("transform_tolerance", transform_tolerance_);
  get_parameter("initial_transform_timeout", initial_transform_timeout_);
  get_parameter("update_frequency", map_update_frequency_);
  plugin_names_ = get_parameter("plugins").as_string_array();
  filter_names_ = get_parameter("filters").as_string_array();
  if (plugin_names_ == default_plugins_) {
    for (size_t i = 0; i < default_plugins_.size(); ++i) {
      nav2_util::declare_parameter_if_not_declared(this, default_plugins_[i] + ".plugin",
                                                   rclcpp::ParameterValue(default_types_[i]));
    }
  }
  publish_cycle_ = map_publish_frequency_ > 0
                       ? rclcpp::Duration::from_seconds(1 / map_publish_frequency_)
                       : rclcpp::Duration(-1, 0);
  use_radius_ = true;
  if (!footprint_.empty() && footprint_ != "[]") {
    std::vector<geometry_msgs::msg::Point> footprint;
    use_radius_ = !makeFootprintFromString(footprint_, footprint);
    if (use_radius_) {
      RCLCPP_ERROR(get_logger(),
                   "The footprint parameter is invalid: \"%s\", using radius (%lf) instead",
                   footprint_.c_str(), robot_radius_);
    }
  }
  const std::string problem = problem_of(map_width_meters_, map_height_meters_, resolution_);
  if (!problem.empty()) throw std::runtime_error(problem);
}

std::string Costmap2DROS::applyParameter(const rclcpp::Parameter& parameter, bool& resized) {
  const std::string& name = parameter.get_name();
  switch (parameter.get_type()) {
    case rclcpp::ParameterType::PARAMETER_DOUBLE: {
      const double value = parameter.as_double();
      if (name == "robot_radius") {
        robot_radius_ = value;
        if (use_radius_) setRobotFootprint(makeFootprintFromRadius(robot_radius_));
      } else if (name == "footprint_padding") {
        footprint_padding_ = value;
        setRobotFootprint(getUnpaddedRobotFootprint());
      } else if (name == "transform_tolerance") {
        transform_tolerance_ = value;
      } else if (name == "publish_frequency") {
        map_publish_frequency_ = value;
        publish_cycle_ =
            value > 0 ? rclcpp::Duration::from_seconds(1 / value) : rclcpp::Duration(-1, 0);
      } else if (name == "resolution") {
        const std::string problem = problem_of(map_width_meters_, map_height_meters_, value);
        if (!problem.empty()) return problem;
        resolution_ = value;
        resized = true;
      } else if (name == "origin_x") {
        origin_x_ = value;
        resized = true;
      } else if (name == "origin_y") {
        origin_y_ = value;
        resized = true;
      }
      return "";
    }
    case rclcpp::ParameterType::PARAMETER_INTEGER: {
      int* size = name == "width"    ? &map_width_meters_
                  : name == "height" ? &map_height_meters_
                                     : nullptr;
      if (size == nullptr) return "";
      const auto value = static_cast<double>(parameter.as_int());
      const std::string problem =
          problem_of(name == "width" ? value : map_width_meters_,
                     name == "height" ? value : map_height_meters_, resolution_);
      if (!problem.empty()) return problem;
      *size = static_cast<int>(parameter.as_int());
      resized = true;
      return "";
    }
    case rclcpp::ParameterType::PARAMETER_STRING: {
      if (name == "footprint") {
        std::vector<geometry_msgs::msg::Point> footprint;
        if (!makeFootprintFromString(parameter.as_string(), footprint)) return "";
        footprint_ = parameter.as_string();
        setRobotFootprint(footprint);
      } else if (name == "robot_base_frame") {
        std::string error;
        RCLCPP_INFO(get_logger(), "Checking transform");
        if (!tf_buffer_->canTransform(global_frame_, parameter.as_string(), tf2::TimePointZero,
                                      tf2::durationFromSec(1.0), &error)) {
          RCLCPP_WARN(get_logger(),
                      "Timed out waiting for transform from %s to %s to become available, tf "
                      "error: %s",
                      parameter.as_string().c_str(), global_frame_.c_str(), error.c_str());
          RCLCPP_WARN(get_logger(),
                      "Rejecting robot_base_frame change to %s , leaving it to its original value "
                      "of %s",
                      parameter.as_string().c_str(), robot_base_frame_.c_str());
          return "the costmap has no transform from " + parameter.as_string();
        }
        robot_base_frame_ = parameter.as_string();
      }
      return "";
    }
    default:
      return "";
  }
}

rcl_interfaces::msg::SetParametersResult Costmap2DROS::dynamicParametersCallback(
    std::vector<rclcpp::Parameter> parameters) {
  rcl_interfaces::msg::SetParametersResult result;
  result.successful = true;
  bool resized = false;
  const std::lock_guard<std::mutex> lock(dynamic_parameter_mutex_);
  for (const rclcpp::Parameter& parameter : parameters) {
    const std::string problem = applyParameter(parameter, resized);
    if (problem.empty()) continue;
    RCLCPP_ERROR(get_logger(), "%s", problem.c_str());
    result.successful = false;
    result.reason = problem;
    return result;
  }
  if (resized && !layered_costmap_->isSizeLocked()) {
    resizeToParameters();
    updateMap();
  }
  return result;
}

}  // namespace nav2_costmap_2d
