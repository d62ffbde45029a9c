// Point clouds for tf2: how one is seen from another frame.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <string>

#include "geometry_msgs/msg/transform_stamped.hpp"
#include "sensor_msgs/msg/point_cloud2.hpp"
#include "sensor_msgs/point_cloud2_iterator.hpp"
#include "tf2/convert.hpp"
#include "tf2/time.hpp"
#include "tf2_ros/buffer_interface.hpp"

namespace tf2 {

namespace impl {

/// Replaces the vectors in three float fields by what `change` makes of them.
template <typename ChangeT>
void change_vectors(sensor_msgs::msg::PointCloud2& cloud, const std::string& prefix,
                    ChangeT change) {
  sensor_msgs::PointCloud2Iterator<float> x(cloud, prefix + "x");
  sensor_msgs::PointCloud2Iterator<float> y(cloud, prefix + "y");
  sensor_msgs::PointCloud2Iterator<float> z(cloud, prefix + "z");
  for (; x != x.end(); ++x, ++y, ++z) {
    const Eigen::Vector3f changed = change(Eigen::Vector3f(*x, *y, *z));
    *x = changed.x();
    *y = changed.y();
    *z = changed.z();
  }
}

}  // namespace impl

template <>
inline TimePoint getTimestamp(const sensor_msgs::msg::PointCloud2& p) {
  return tf2_ros::fromMsg(p.header.stamp);
}
template <>
inline std::string getFrameId(const sensor_msgs::msg::PointCloud2& p) {
  return p.header.frame_id;
}

/// Moves the points, and turns their normals when the cloud has a field `normal_x`.
template <>
inline void doTransform(const sensor_msgs::msg::PointCloud2& p_in,
                        sensor_msgs::msg::PointCloud2& p_out,
                        const geometry_msgs::msg::TransformStamped& t_in) {
  const auto& move = t_in.transform.translation;
  const auto& turn = t_in.transform.rotation;
  const Eigen::Vector3f translation = Eigen::Vector3d(move.x, move.y, move.z).cast<float>();
  const Eigen::Matrix3f rotation =
      Eigen::Quaterniond(turn.w, turn.x, turn.y, turn.z).cast<float>().toRotationMatrix();
  if (&p_out != &p_in) {
    p_out = p_in;
  }
  p_out.header = t_in.header;
  impl::change_vectors(p_out, "", [&](const Eigen::Vector3f& point) {
    return Eigen::Vector3f(rotation * point + translation);
  });
  if (std::any_of(p_out.fields.begin(), p_out.fields.end(),
                  [](const auto& field) { return field.name == "normal_x"; })) {
    impl::change_vectors(p_out, "normal_", [&](const Eigen::Vector3f& normal) {
      return Eigen::Vector3f(rotation * normal);
    });
  }
}

inline sensor_msgs::msg::PointCloud2 toMsg(const sensor_msgs::msg::PointCloud2& in) {
  return in;
}
inline void fromMsg(const sensor_msgs::msg::PointCloud2& msg, sensor_msgs::msg::PointCloud2& out) {
  out = msg;
}

}  // namespace tf2
