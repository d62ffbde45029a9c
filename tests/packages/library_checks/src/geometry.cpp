// Linear algebra of Eigen in a node, to and from messages, and arithmetic of angles.

// Compatibility, works: Eigen (`eigen`, `find_package(Eigen3)`) with fixed and dynamic sizes,
// solvers and decompositions; tf2_eigen; tf2_sensor_msgs (point clouds with normals); angles

#include <Eigen/Core>
#include <Eigen/Dense>
#include <Eigen/Geometry>
#include <Eigen/StdVector>
#include <cmath>
#include <vector>

#include "angles/angles.h"
#include "checks.hpp"
#include "geometry_msgs/msg/point_stamped.hpp"
#include "sensor_msgs/msg/point_cloud2.hpp"
#include "sensor_msgs/point_cloud2_iterator.hpp"
#include "tf2/convert.h"
#include "tf2_eigen/tf2_eigen.hpp"
#include "tf2_ros/buffer.h"
#include "tf2_sensor_msgs/tf2_sensor_msgs.hpp"

namespace {

constexpr double kNear = 1e-12;

geometry_msgs::msg::TransformStamped quarter_turn() {
  geometry_msgs::msg::TransformStamped t;
  t.header.frame_id = "world";
  t.child_frame_id = "robot";
  t.header.stamp.sec = 7;
  t.transform.translation.x = 1;
  t.transform.translation.y = 2;
  t.transform.translation.z = 3;
  t.transform.rotation.z = std::sqrt(0.5);
  t.transform.rotation.w = std::sqrt(0.5);
  return t;
}

void check_algebra(Checks& checks) {
  Eigen::Matrix3d a;
  a << 4, 1, 0, 1, 3, -1, 0, -1, 2;
  const Eigen::Vector3d b(1, 2, 3);
  CHECK((a * a.ldlt().solve(b) - b).norm() < kNear);
  CHECK((a * a.inverse() - Eigen::Matrix3d::Identity()).norm() < kNear);
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(a);
  CHECK(std::abs(eigen.eigenvalues().sum() - a.trace()) < kNear);
  CHECK(std::abs(eigen.eigenvalues().prod() - a.determinant()) < 1e-10);

  // A Kalman filter's step, with sizes that are known when it runs.
  const int n = 4;
  Eigen::MatrixXd p = Eigen::MatrixXd::Identity(n, n);
  const Eigen::MatrixXd h = Eigen::MatrixXd::Identity(2, n);
  const Eigen::MatrixXd r = 3 * Eigen::MatrixXd::Identity(2, 2);
  const Eigen::MatrixXd k = p * h.transpose() * (h * p * h.transpose() + r).inverse();
  p = (Eigen::MatrixXd::Identity(n, n) - k * h) * p;
  CHECK(std::abs(p(0, 0) - 0.75) < kNear && std::abs(p(3, 3) - 1) < kNear);

  std::vector<Eigen::Vector4f, Eigen::aligned_allocator<Eigen::Vector4f>> corners(
      4, Eigen::Vector4f::Ones());
  CHECK(corners.back().sum() == 4);
}

void check_conversions(Checks& checks) {
  const auto t = quarter_turn();
  const Eigen::Isometry3d isometry = tf2::transformToEigen(t);
  CHECK((isometry * Eigen::Vector3d(1, 0, 0) - Eigen::Vector3d(1, 3, 3)).norm() < kNear);
  const auto back = tf2::eigenToTransform(isometry);
  CHECK(std::abs(back.transform.rotation.z - t.transform.rotation.z) < kNear);
  CHECK(back.transform.translation == t.transform.translation);
  CHECK(tf2::eigenToTransform(Eigen::Affine3d(isometry)).transform.translation.y == 2);

  Eigen::Vector3d seen;
  tf2::doTransform(Eigen::Vector3d(0, 1, 0), seen, t);
  CHECK((seen - Eigen::Vector3d(0, 2, 3)).norm() < kNear);
  tf2::Stamped<Eigen::Vector3d> stamped(Eigen::Vector3d(1, 2, 3), tf2::TimePoint(), "robot");
  tf2::Stamped<Eigen::Vector3d> moved;
  tf2::doTransform(stamped, moved, t);
  CHECK(moved.frame_id_ == "world" && moved.isApprox(Eigen::Vector3d(-1, 3, 6)));
  CHECK(tf2::getTimestamp(moved) == tf2::TimePoint(std::chrono::seconds(7)));
  CHECK(tf2::toMsg(moved).header.frame_id == "world");

  Eigen::VectorXd twist(6);
  twist << 0, 0, 1, 0, 0, 0;
  Eigen::VectorXd elsewhere;
  tf2::doTransform(twist, elsewhere, t);
  CHECK(elsewhere.size() == 6 && std::abs(elsewhere[3] - 2) < kNear &&
        std::abs(elsewhere[4] + 1) < kNear);

  geometry_msgs::msg::Pose pose;
  tf2::convert(isometry, pose);
  Eigen::Affine3d affine;
  tf2::convert(pose, affine);
  CHECK(affine.isApprox(Eigen::Affine3d(isometry)));
  const Eigen::Matrix<double, 6, 1> velocity = Eigen::Matrix<double, 6, 1>::LinSpaced(1, 6);
  CHECK(tf2::toMsg(velocity).angular.x == 4 && tf2::toMsg2(seen).z == 3);
  Eigen::Quaterniond q;
  tf2::fromMsg(t.transform.rotation, q);
  CHECK(std::abs(q.angularDistance(Eigen::Quaterniond::Identity()) - M_PI_2) < kNear);

  // By way of a buffer.
  tf2_ros::Buffer buffer(std::make_shared<rclcpp::Clock>());
  buffer.setTransform(t, "checks", true);
  const auto by_buffer = buffer.transform(stamped, "world");
  CHECK(by_buffer.isApprox(Eigen::Vector3d(-1, 3, 6)) && by_buffer.frame_id_ == "world");
}

void check_clouds(Checks& checks) {
  sensor_msgs::msg::PointCloud2 cloud;
  sensor_msgs::PointCloud2Modifier modifier(cloud);
  const auto kFloat = sensor_msgs::msg::PointField::FLOAT32;
  modifier.setPointCloud2Fields(6, "x", 1, kFloat, "y", 1, kFloat, "z", 1, kFloat, "normal_x", 1,
                                kFloat, "normal_y", 1, kFloat, "normal_z", 1, kFloat);
  modifier.resize(2);
  cloud.header.frame_id = "robot";
  int value = 0;
  for (sensor_msgs::PointCloud2Iterator<float> x(cloud, "x"), n(cloud, "normal_x"); x != x.end();
       ++x, ++n) {
    for (int i = 0; i < 3; ++i) {
      x[i] = static_cast<float>(++value);
      n[i] = i == 0 ? 1.0F : 0.0F;
    }
  }
  sensor_msgs::msg::PointCloud2 seen;
  tf2::doTransform(cloud, seen, quarter_turn());
  sensor_msgs::PointCloud2ConstIterator<float> y(seen, "y");
  sensor_msgs::PointCloud2ConstIterator<float> normal_y(seen, "normal_y");
  CHECK(seen.header.frame_id == "world" && tf2::getFrameId(seen) == "world");
  CHECK(std::abs(*y - 3) < 1e-5F && std::abs(*normal_y - 1) < 1e-5F);
  ++y;
  CHECK(std::abs(*y - 6) < 1e-5F);
}

void check_angles(Checks& checks) {
  const auto near = [](double a, double b) { return std::abs(a - b) < kNear; };
  CHECK(near(angles::from_degrees(180), M_PI) && near(angles::to_degrees(M_PI_2), 90));
  CHECK(near(angles::normalize_angle_positive(-M_PI_2), 1.5 * M_PI));
  CHECK(near(angles::normalize_angle(3 * M_PI), M_PI) &&
        near(angles::normalize_angle(-M_PI), M_PI));
  CHECK(near(angles::normalize_angle(-7.5), -7.5 + 2 * M_PI));
  CHECK(near(angles::shortest_angular_distance(0.9 * M_PI, -0.9 * M_PI), 0.2 * M_PI));
  CHECK(near(angles::two_pi_complement(M_PI_4), -7 * M_PI_4));
  CHECK(near(angles::two_pi_complement(0), 2 * M_PI));

  // The cases that the package's documentation names.
  double way = 0;
  CHECK(!angles::shortest_angular_distance_with_limits(-0.5, 0.5, -0.25, 0.25, way));
  CHECK(angles::shortest_angular_distance_with_limits(-0.5, 0.5, 0.25, -0.25, way));
  CHECK(near(way, 1.0 - 2 * M_PI));
  CHECK(angles::shortest_angular_distance_with_limits(0.2, -0.2, -0.25, 0.25, way));
  CHECK(near(way, -0.4));
  double least = 0;
  double most = 0;
  CHECK(angles::find_min_max_delta(0.0, -0.25, 0.25, least, most));
  CHECK(near(least, -0.25) && near(most, 0.25));
  CHECK(!angles::find_min_max_delta(1.0, -0.25, 0.25, least, most));
  CHECK(angles::shortest_angular_distance_with_large_limits(0, 10.5 * M_PI, -2 * M_PI, 2 * M_PI,
                                                            way));
  CHECK(near(way, 0.5 * M_PI));
  CHECK(angles::shortest_angular_distance_with_large_limits(0, 10.5 * M_PI, -2 * M_PI, 0.1 * M_PI,
                                                            way));
  CHECK(near(way, -1.5 * M_PI));
  CHECK(!angles::shortest_angular_distance_with_large_limits(10.5 * M_PI, 0, -2 * M_PI, 2 * M_PI,
                                                             way));
}

}  // namespace

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  Checks checks("geometry");
  check_algebra(checks);
  check_conversions(checks);
  check_clouds(checks);
  check_angles(checks);
  return checks.finish();
}
