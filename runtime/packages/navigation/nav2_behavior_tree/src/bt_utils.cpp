// See bt_utils.hpp.
#include "nav2_behavior_tree/bt_utils.hpp"

#include <stdexcept>

namespace BT {
namespace {

using geometry_msgs::msg::Point;
using geometry_msgs::msg::PoseStamped;
using geometry_msgs::msg::Quaternion;
using Parts = std::vector<StringView>;

constexpr size_t kPartsOfPose = 9;

bool is_json(StringView key) {
  return StartWith(key, "json:");
}

StringView json_of(StringView key) {
  key.remove_prefix(5);
  return key;
}

Parts parts_of(StringView key, size_t count, const char* what) {
  Parts parts = splitString(key, ';');
  if (parts.size() == count) return parts;
  throw std::runtime_error(std::string("invalid number of fields for ") + what + " attribute)");
}

double number(StringView text) {
  return convertFromString<double>(text);
}

rclcpp::Time time(StringView nanoseconds) {
  return rclcpp::Time(convertFromString<int64_t>(nanoseconds));
}

PoseStamped pose_at(const Parts& parts, size_t begin) {
  PoseStamped pose;
  pose.header.stamp = time(parts[begin]);
  pose.header.frame_id = convertFromString<std::string>(parts[begin + 1]);
  pose.pose.position.x = number(parts[begin + 2]);
  pose.pose.position.y = number(parts[begin + 3]);
  pose.pose.position.z = number(parts[begin + 4]);
  pose.pose.orientation.x = number(parts[begin + 5]);
  pose.pose.orientation.y = number(parts[begin + 6]);
  pose.pose.orientation.z = number(parts[begin + 7]);
  pose.pose.orientation.w = number(parts[begin + 8]);
  return pose;
}

std::vector<PoseStamped> poses_from(const Parts& parts, size_t begin, const char* what) {
  if (parts.size() < begin || (parts.size() - begin) % kPartsOfPose != 0) {
    throw std::runtime_error(std::string("invalid number of fields for ") + what + " attribute)");
  }
  std::vector<PoseStamped> poses;
  for (; begin < parts.size(); begin += kPartsOfPose) poses.push_back(pose_at(parts, begin));
  return poses;
}

}  // namespace

template <>
Point convertFromString(StringView key) {
  if (is_json(key)) return convertFromJSON<Point>(json_of(key));
  const Parts parts = parts_of(key, 3, "point");
  Point point;
  point.x = number(parts[0]);
  point.y = number(parts[1]);
  point.z = number(parts[2]);
  return point;
}

template <>
Quaternion convertFromString(StringView key) {
  if (is_json(key)) return convertFromJSON<Quaternion>(json_of(key));
  const Parts parts = parts_of(key, 4, "orientation");
  Quaternion orientation;
  orientation.x = number(parts[0]);
  orientation.y = number(parts[1]);
  orientation.z = number(parts[2]);
  orientation.w = number(parts[3]);
  return orientation;
}

template <>
PoseStamped convertFromString(StringView key) {
  if (is_json(key)) return convertFromJSON<PoseStamped>(json_of(key));
  return pose_at(parts_of(key, kPartsOfPose, "PoseStamped"), 0);
}

template <>
std::vector<PoseStamped> convertFromString(StringView key) {
  if (is_json(key)) return convertFromJSON<std::vector<PoseStamped>>(json_of(key));
  return poses_from(splitString(key, ';'), 0, "std::vector<PoseStamped>");
}

template <>
nav_msgs::msg::Path convertFromString(StringView key) {
  if (is_json(key)) return convertFromJSON<nav_msgs::msg::Path>(json_of(key));
  const Parts parts = splitString(key, ';');
  nav_msgs::msg::Path path;
  path.poses = poses_from(parts, 2, "Path");
  path.header.stamp = time(parts[0]);
  path.header.frame_id = convertFromString<std::string>(parts[1]);
  return path;
}

template <>
std::chrono::milliseconds convertFromString(StringView key) {
  using std::chrono::milliseconds;
  if (is_json(key)) return convertFromJSON<milliseconds>(json_of(key));
  return milliseconds(convertFromString<int64_t>(key));
}

template <>
std::set<int> convertFromString(StringView key) {
  std::set<int> result;
  for (const StringView part : splitString(key, ';')) result.insert(convertFromString<int>(part));
  return result;
}

}  // namespace BT
