// See source.hpp.
#include "nav2_collision_monitor/source.hpp"

#include <utility>

#include "nav2_util/robot_utils.hpp"
#include "read_parameters.hpp"

namespace nav2_collision_monitor {

Source::Source(const nav2_util::LifecycleNode::WeakPtr& node, const std::string& source_name,
               const std::shared_ptr<tf2_ros::Buffer> tf_buffer, const std::string& base_frame_id,
               const std::string& global_frame_id, const tf2::Duration& transform_tolerance,
               const rclcpp::Duration& source_timeout, const bool base_shift_correction)
    : node_(node),
      source_name_(source_name),
      tf_buffer_(tf_buffer),
      base_frame_id_(base_frame_id),
      global_frame_id_(global_frame_id),
      transform_tolerance_(transform_tolerance),
      source_timeout_(source_timeout),
      base_shift_correction_(base_shift_correction) {}

Source::~Source() = default;

void Source::configure() {
  dyn_params_handler_ = locked(node_)->add_on_set_parameters_callback(
      [this](std::vector<rclcpp::Parameter> parameters) {
        return dynamicParametersCallback(std::move(parameters));
      });
}

void Source::getCommonParameters(std::string& source_topic) {
  const NodePtr node = locked(node_);
  source_topic = read<std::string>(node, source_name_ + ".topic", "scan");
  enabled_ = read<bool>(node, source_name_ + ".enabled", true);
  source_timeout_ = rclcpp::Duration::from_seconds(
      read_number(node, source_name_ + ".source_timeout", source_timeout_.seconds(), 0.0));
}

bool Source::sourceValid(const rclcpp::Time& source_time, const rclcpp::Time& curr_time) const {
  const rclcpp::Duration age = curr_time - source_time;
  if (source_timeout_.nanoseconds() == 0 || age <= source_timeout_) return true;
  RCLCPP_WARN(logger_,
              "[%s]: Latest source and current collision monitor node timestamps differ on %f "
              "seconds. Ignoring the source.",
              source_name_.c_str(), age.seconds());
  return false;
}

rcl_interfaces::msg::SetParametersResult Source::dynamicParametersCallback(
    std::vector<rclcpp::Parameter> parameters) {
  for (const rclcpp::Parameter& parameter : parameters) {
    if (parameter.get_type() == rclcpp::ParameterType::PARAMETER_BOOL &&
        parameter.get_name() == source_name_ + ".enabled") {
      enabled_ = parameter.as_bool();
    }
  }
  rcl_interfaces::msg::SetParametersResult result;
  result.successful = true;
  return result;
}

bool Source::getTransform(const rclcpp::Time& curr_time, const std_msgs::msg::Header& data_header,
                          tf2::Transform& tf_transform) const {
  if (!base_shift_correction_) {
    return nav2_util::getTransform(data_header.frame_id, base_frame_id_, transform_tolerance_,
                                   tf_buffer_, tf_transform);
  }
  return nav2_util::getTransform(data_header.frame_id, data_header.stamp, base_frame_id_, curr_time,
                                 global_frame_id_, transform_tolerance_, tf_buffer_, tf_transform);
}

void appendTransformed(const std::vector<Point>& points, const tf2::Transform& transform,
                       std::vector<Point>& data) {
  for (const Point& point : points) {
    const tf2::Vector3 moved = transform * tf2::Vector3(point.x, point.y, 0.0);
    data.push_back({moved.x(), moved.y()});
  }
}

}  // namespace nav2_collision_monitor
