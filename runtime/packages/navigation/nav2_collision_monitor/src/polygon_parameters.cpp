// Reads the parameters of a zone: its shape, its action, and the sources that it watches.
#include <algorithm>
#include <exception>
#include <limits>

#include "nav2_collision_monitor/polygon.hpp"
#include "nav2_util/array_parser.hpp"
#include "read_parameters.hpp"

namespace nav2_collision_monitor {
namespace {

// Bounds what one command of velocity can cost.
constexpr double kMostSteps = 10'000;

}  // namespace

bool Polygon::getCommonParameters(std::string& polygon_sub_topic, std::string& polygon_pub_topic,
                                  std::string& footprint_topic, bool use_dynamic_sub) {
  const NodePtr node = locked(node_);
  const std::string prefix = polygon_name_ + ".";
  try {
    if (!readAction(
            read_required<std::string>(node, prefix + "action_type", rclcpp::PARAMETER_STRING))) {
      return false;
    }
    enabled_ = read<bool>(node, prefix + "enabled", true);
    readMinPoints(node);
    readActionNumbers(node);
    visualize_ = read<bool>(node, prefix + "visualize", false);
    if (visualize_) {
      polygon_pub_topic = read<std::string>(node, prefix + "polygon_pub_topic", polygon_name_);
    }
    polygon_subscribe_transient_local_ =
        read<bool>(node, prefix + "polygon_subscribe_transient_local", false);
    if (use_dynamic_sub && action_type_ == APPROACH) {
      footprint_topic =
          read<std::string>(node, prefix + "footprint_topic", "local_costmap/published_footprint");
    } else if (use_dynamic_sub) {
      polygon_sub_topic =
          read_required<std::string>(node, prefix + "polygon_sub_topic", rclcpp::PARAMETER_STRING);
    }
    return readSources(node);
  } catch (const std::exception& error) {
    RCLCPP_ERROR(logger_, "[%s]: Error while getting common polygon parameters: %s",
                 polygon_name_.c_str(), error.what());
    return false;
  }
}

bool Polygon::readAction(const std::string& name) {
  const std::pair<const char*, ActionType> actions[] = {{"stop", STOP},
                                                        {"slowdown", SLOWDOWN},
                                                        {"limit", LIMIT},
                                                        {"approach", APPROACH},
                                                        {"none", DO_NOTHING}};
  for (const auto& [known, type] : actions) {
    if (name != known) continue;
    action_type_ = type;
    return true;
  }
  RCLCPP_ERROR(logger_, "[%s]: Unknown action type: %s", polygon_name_.c_str(), name.c_str());
  return false;
}

void Polygon::readMinPoints(const NodePtr& node) {
  constexpr int64_t kMost = std::numeric_limits<int>::max() - 1;
  int64_t points = read<int64_t>(node, polygon_name_ + ".min_points", 4);
  const std::string older = polygon_name_ + ".max_points";
  nav2_util::declare_parameter_if_not_declared(node, older, rclcpp::PARAMETER_INTEGER);
  rclcpp::Parameter most;
  if (node->get_node_parameters_interface()->get_parameter(older, most) &&
      most.get_type() == rclcpp::PARAMETER_INTEGER) {
    points = std::clamp<int64_t>(most.as_int(), -kMost, kMost) + 1;
    RCLCPP_WARN(logger_,
                "[%s]: \"max_points\" parameter was deprecated. Use \"min_points\" instead to "
                "specify the minimum number of data readings within a zone to trigger the action",
                polygon_name_.c_str());
  }
  min_points_ = static_cast<int>(std::clamp<int64_t>(points, -kMost, kMost));
}

void Polygon::readActionNumbers(const NodePtr& node) {
  const std::string prefix = polygon_name_ + ".";
  if (action_type_ == SLOWDOWN) {
    slowdown_ratio_ = read_number(node, prefix + "slowdown_ratio", 0.5, 0.0, 1.0);
  } else if (action_type_ == LIMIT) {
    linear_limit_ = read_number(node, prefix + "linear_limit", 0.5, 0.0);
    angular_limit_ = read_number(node, prefix + "angular_limit", 0.5, 0.0);
  } else if (action_type_ == APPROACH) {
    time_before_collision_ = read_number(node, prefix + "time_before_collision", 2.0, 0.0);
    simulation_time_step_ = read_number(node, prefix + "simulation_time_step", 0.1,
                                        std::max(time_before_collision_ / kMostSteps, 1e-6));
  }
}

bool Polygon::readSources(const NodePtr& node) {
  using Names = std::vector<std::string>;
  const Names known =
      read_required<Names>(node, "observation_sources", rclcpp::PARAMETER_STRING_ARRAY);
  sources_names_ = read<Names>(node, polygon_name_ + ".sources_names", known);
  for (const std::string& name : sources_names_) {
    if (std::find(known.begin(), known.end(), name) != known.end()) continue;
    RCLCPP_ERROR_STREAM(logger_,
                        "Observation source ["
                            << name << "] configured for polygon [" << getName()
                            << "] is not defined as one of the node's observation_source!");
    return false;
  }
  return true;
}

bool Polygon::getParameters(std::string& polygon_sub_topic, std::string& polygon_pub_topic,
                            std::string& footprint_topic) {
  polygon_sub_topic.clear();
  footprint_topic.clear();
  bool is_dynamic = true;
  try {
    std::string text = read_required<std::string>(locked(node_), polygon_name_ + ".points",
                                                  rclcpp::PARAMETER_STRING);
    if (!getPolygonFromString(text, poly_)) return false;
    is_dynamic = false;
  } catch (const rclcpp::exceptions::ParameterUninitializedException&) {
    RCLCPP_INFO(logger_,
                "[%s]: Polygon points are not defined. Using dynamic subscription instead.",
                polygon_name_.c_str());
  }
  if (getCommonParameters(polygon_sub_topic, polygon_pub_topic, footprint_topic, is_dynamic)) {
    return true;
  }
  if (is_dynamic && polygon_sub_topic.empty() && footprint_topic.empty()) {
    RCLCPP_ERROR(logger_,
                 "[%s]: Error while getting polygon parameters: static points and sub topic both "
                 "not defined",
                 polygon_name_.c_str());
  }
  return false;
}

bool Polygon::getPolygonFromString(std::string& poly_string, std::vector<Point>& polygon) {
  std::string error;
  const std::vector<std::vector<float>> lists = nav2_util::parseVVF(poly_string, error);
  polygon.clear();
  if (!error.empty()) {
    RCLCPP_ERROR(logger_, "Error parsing polygon parameter %s: '%s'", poly_string.c_str(),
                 error.c_str());
    return false;
  }
  // Upstream's rule, and its text: a triangle is refused.
  if (lists.size() <= 3) {
    RCLCPP_ERROR(logger_, "Polygon must have at least three points.");
    return false;
  }
  for (const std::vector<float>& list : lists) {
    if (list.size() != 2) {
      RCLCPP_ERROR(logger_,
                   "Points in the polygon specification must be pairs of numbersFound a point with "
                   "%d numbers.",
                   static_cast<int>(list.size()));
      polygon.clear();
      return false;
    }
    polygon.push_back({list[0], list[1]});
  }
  return true;
}

}  // namespace nav2_collision_monitor
