// Messages of ports as JSON.
#pragma once

#include <chrono>
#include <string>
#include <vector>

#include "behaviortree_cpp/json_export.h"
#include "builtin_interfaces/msg/time.hpp"
#include "geometry_msgs/msg/point.hpp"
#include "geometry_msgs/msg/pose_stamped.hpp"
#include "geometry_msgs/msg/quaternion.hpp"
#include "nav_msgs/msg/path.hpp"
#include "std_msgs/msg/header.hpp"

namespace builtin_interfaces::msg {
BT_JSON_CONVERTER(builtin_interfaces::msg::Time, msg) {
  add_field("sec", &msg.sec);
  add_field("nanosec", &msg.nanosec);
}
}  // namespace builtin_interfaces::msg

namespace std_msgs::msg {
BT_JSON_CONVERTER(std_msgs::msg::Header, msg) {
  add_field("stamp", &msg.stamp);
  add_field("frame_id", &msg.frame_id);
}
}  // namespace std_msgs::msg

namespace geometry_msgs::msg {
BT_JSON_CONVERTER(geometry_msgs::msg::Point, msg) {
  add_field("x", &msg.x);
  add_field("y", &msg.y);
  add_field("z", &msg.z);
}
BT_JSON_CONVERTER(geometry_msgs::msg::Quaternion, msg) {
  add_field("x", &msg.x);
  add_field("y", &msg.y);
  add_field("z", &msg.z);
  add_field("w", &msg.w);
}
BT_JSON_CONVERTER(geometry_msgs::msg::Pose, msg) {
  add_field("position", &msg.position);
  add_field("orientation", &msg.orientation);
}
BT_JSON_CONVERTER(geometry_msgs::msg::PoseStamped, msg) {
  add_field("header", &msg.header);
  add_field("pose", &msg.pose);
}
}  // namespace geometry_msgs::msg

namespace nav_msgs::msg {
BT_JSON_CONVERTER(nav_msgs::msg::Path, msg) {
  add_field("header", &msg.header);
  add_field("poses", &msg.poses);
}
}  // namespace nav_msgs::msg

namespace std::chrono {
inline void to_json(nlohmann::json& destination, const std::chrono::milliseconds& source) {
  destination["ms"] = source.count();
}
inline void from_json(const nlohmann::json& source, std::chrono::milliseconds& destination) {
  destination = std::chrono::milliseconds(source.at("ms").get<int64_t>());
}
}  // namespace std::chrono
