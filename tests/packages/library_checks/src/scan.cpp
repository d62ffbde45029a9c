// A laser's scan as points, where it stands and in a frame that it moves in.

// Compatibility, works: laser_geometry (`LaserProjection`): scans as clouds, with all channels, cut
// off, and in another frame while the laser moves

#include <cmath>
#include <limits>
#include <string>

#include "checks.hpp"
#include "laser_geometry/laser_geometry.hpp"
#include "sensor_msgs/point_cloud2_iterator.hpp"

using sensor_msgs::PointCloud2ConstIterator;
using sensor_msgs::msg::PointCloud2;

namespace {

sensor_msgs::msg::LaserScan five_ranges() {
  sensor_msgs::msg::LaserScan scan;
  scan.header.frame_id = "laser";
  scan.header.stamp.sec = 5;
  scan.angle_min = 0;
  scan.angle_increment = static_cast<float>(M_PI_2);
  scan.angle_max = static_cast<float>(2 * M_PI);
  scan.time_increment = 0.25F;
  scan.range_min = 0.5F;
  scan.range_max = 10;
  scan.ranges = {1, 2, 0.25F, std::numeric_limits<float>::quiet_NaN(), 4};
  scan.intensities = {10, 20, 30, 40, 50};
  return scan;
}

std::string names_of(const PointCloud2& cloud) {
  std::string names;
  for (const auto& field : cloud.fields) names += field.name + " ";
  return names;
}

bool is_near(double a, double b) {
  return std::abs(a - b) < 1e-5;
}

void check_projection(Checks& checks) {
  const laser_geometry::LaserProjection projection;
  PointCloud2 cloud;
  projection.projectLaser(five_ranges(), cloud);
  CHECK(cloud.header.frame_id == "laser" && cloud.header.stamp.sec == 5);
  CHECK(names_of(cloud) == "x y z intensity index ");
  CHECK(cloud.height == 1 && cloud.width == 3 && !cloud.is_dense);
  CHECK(cloud.point_step == 20 && cloud.row_step == 60 && cloud.data.size() == 60);
  PointCloud2ConstIterator<float> x(cloud, "x");
  PointCloud2ConstIterator<float> y(cloud, "y");
  PointCloud2ConstIterator<float> intensity(cloud, "intensity");
  PointCloud2ConstIterator<int32_t> index(cloud, "index");
  CHECK(is_near(x[0], 1) && is_near(y[0], 0) && intensity[0] == 10 && index[0] == 0);
  ++x, ++y, ++intensity, ++index;
  CHECK(is_near(x[0], 0) && is_near(y[0], 2) && intensity[0] == 20 && index[0] == 1);
  ++x, ++y, ++intensity, ++index;
  CHECK(is_near(x[0], 4) && is_near(y[0], 0) && intensity[0] == 50 && index[0] == 4);

  using namespace laser_geometry::channel_option;
  projection.projectLaser(five_ranges(), cloud, 3.0, Distance | Timestamp | Viewpoint);
  CHECK(names_of(cloud) == "x y z distances stamps vp_x vp_y vp_z ");
  CHECK(cloud.width == 2);
  PointCloud2ConstIterator<float> stamps(cloud, "stamps");
  ++stamps;
  CHECK(is_near(stamps[0], 0.25));
  projection.projectLaser(sensor_msgs::msg::LaserScan(), cloud);
  CHECK(cloud.width == 0 && cloud.data.empty());
}

void check_motion(Checks& checks) {
  // It drives one metre while it scans, from 1 to 2.
  tf2::BufferCore buffer;
  for (const int second : {5, 6}) {
    geometry_msgs::msg::TransformStamped pose;
    pose.header.frame_id = "odom";
    pose.header.stamp.sec = second;
    pose.child_frame_id = "laser";
    pose.transform.translation.x = second - 4;
    pose.transform.rotation.w = 1;
    CHECK(buffer.setTransform(pose, "scan"));
  }
  const laser_geometry::LaserProjection projection;
  PointCloud2 cloud;
  projection.transformLaserScanToPointCloud("odom", five_ranges(), cloud, buffer, -1.0,
                                            laser_geometry::channel_option::Viewpoint);
  CHECK(cloud.header.frame_id == "odom");
  CHECK(names_of(cloud) == "x y z vp_x vp_y vp_z ");
  PointCloud2ConstIterator<float> x(cloud, "x");
  PointCloud2ConstIterator<float> from(cloud, "vp_x");
  CHECK(is_near(x[0], 2) && is_near(from[0], 1));
  ++x, ++from;
  CHECK(is_near(x[0], 1.25) && is_near(from[0], 1.25));
  ++x, ++from;
  CHECK(is_near(x[0], 6) && is_near(from[0], 2));
  CHECK_THROWS(tf2::LookupException,
               projection.transformLaserScanToPointCloud("nowhere", five_ranges(), cloud, buffer));
}

}  // namespace

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  Checks checks("scan");
  check_projection(checks);
  check_motion(checks);
  return checks.finish();
}
