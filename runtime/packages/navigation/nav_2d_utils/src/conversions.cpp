// See conversions.hpp.
#include "nav_2d_utils/conversions.hpp"

#include "nav2_util/geometry_utils.hpp"
#include "tf2/utils.h"
#include "tf2_geometry_msgs/tf2_geometry_msgs.hpp"

namespace nav_2d_utils {

geometry_msgs::msg::Twist twist2Dto3D(const nav_2d_msgs::msg::Twist2D& cmd_vel_2d) {
  geometry_msgs::msg::Twist result;
  result.linear.x = cmd_vel_2d.x;
  result.linear.y = cmd_vel_2d.y;
  result.angular.z = cmd_vel_2d.theta;
  return result;
}

nav_2d_msgs::msg::Twist2D twist3Dto2D(const geometry_msgs::msg::Twist& cmd_vel) {
  nav_2d_msgs::msg::Twist2D result;
  result.x = cmd_vel.linear.x;
  result.y = cmd_vel.linear.y;
  result.theta = cmd_vel.angular.z;
  return result;
}

geometry_msgs::msg::Pose2D poseToPose2D(const geometry_msgs::msg::Pose& pose) {
  geometry_msgs::msg::Pose2D result;
  result.x = pose.position.x;
  result.y = pose.position.y;
  result.theta = tf2::getYaw(pose.orientation);
  return result;
}

nav_2d_msgs::msg::Pose2DStamped poseStampedToPose2D(const geometry_msgs::msg::PoseStamped& pose) {
  nav_2d_msgs::msg::Pose2DStamped result;
  result.header = pose.header;
  result.pose = poseToPose2D(pose.pose);
  return result;
}

geometry_msgs::msg::Pose pose2DToPose(const geometry_msgs::msg::Pose2D& pose2d) {
  geometry_msgs::msg::Pose result;
  result.position.x = pose2d.x;
  result.position.y = pose2d.y;
  result.orientation = nav2_util::geometry_utils::orientationAroundZAxis(pose2d.theta);
  return result;
}

geometry_msgs::msg::PoseStamped pose2DToPoseStamped(const nav_2d_msgs::msg::Pose2DStamped& pose2d) {
  geometry_msgs::msg::PoseStamped result;
  result.header = pose2d.header;
  result.pose = pose2DToPose(pose2d.pose);
  return result;
}

geometry_msgs::msg::PoseStamped pose2DToPoseStamped(const geometry_msgs::msg::Pose2D& pose2d,
                                                    const std::string& frame,
                                                    const rclcpp::Time& stamp) {
  geometry_msgs::msg::PoseStamped result;
  result.header.frame_id = frame;
  result.header.stamp = stamp;
  result.pose = pose2DToPose(pose2d);
  return result;
}

nav_msgs::msg::Path posesToPath(const std::vector<geometry_msgs::msg::PoseStamped>& poses) {
  nav_msgs::msg::Path path;
  if (!poses.empty()) path.header = poses.front().header;
  path.poses = poses;
  return path;
}

nav_2d_msgs::msg::Path2D pathToPath2D(const nav_msgs::msg::Path& path) {
  nav_2d_msgs::msg::Path2D result;
  result.header = path.header;
  result.poses.reserve(path.poses.size());
  for (const auto& pose : path.poses) result.poses.push_back(poseToPose2D(pose.pose));
  return result;
}

nav_msgs::msg::Path poses2DToPath(const std::vector<geometry_msgs::msg::Pose2D>& poses,
                                  const std::string& frame, const rclcpp::Time& stamp) {
  nav_2d_msgs::msg::Path2D path;
  path.header.frame_id = frame;
  path.header.stamp = stamp;
  path.poses = poses;
  return pathToPath(path);
}

nav_msgs::msg::Path pathToPath(const nav_2d_msgs::msg::Path2D& path2d) {
  nav_msgs::msg::Path path;
  path.header = path2d.header;
  path.poses.resize(path2d.poses.size());
  for (size_t i = 0; i < path.poses.size(); ++i) {
    path.poses[i].header = path2d.header;
    path.poses[i].pose = pose2DToPose(path2d.poses[i]);
  }
  return path;
}

}  // namespace nav_2d_utils
