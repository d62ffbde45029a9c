// A program without a buffer of its own: it asks the program `buffer_server` of tf2_ros, which
// hears of `map` -> `base` (2, 0, 0, turned by a quarter).

// Compatibility, works: the programs of tf2_ros (`tf2_echo`, `tf2_monitor`, `buffer_server`) with
// upstream's arguments and output; `tf2_ros::BufferServer` and `BufferClient`

#include <cmath>
#include <string>
#include <thread>

#include "checks.hpp"
#include "geometry_msgs/msg/point_stamped.hpp"
#include "rclcpp/rclcpp.hpp"
#include "tf2/exceptions.h"
#include "tf2_geometry_msgs/tf2_geometry_msgs.hpp"
#include "tf2_ros/buffer_client.h"
#include "tf2_ros/buffer_server.h"

using std::chrono_literals::operator""ms;
using std::chrono_literals::operator""s;

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  Checks checks("remote");
  const auto node = std::make_shared<rclcpp::Node>("remote");
  std::thread spinner([node] { rclcpp::spin(node); });

  tf2_ros::BufferClient client(node, "tf2_buffer_server");
  CHECK(client.waitForServer(30s));
  const auto found = client.lookupTransform("map", "base", tf2::TimePointZero, 30s);
  CHECK(found.header.frame_id == "map" && found.child_frame_id == "base");
  CHECK(found.transform.translation.x == 2);
  CHECK(std::abs(found.transform.rotation.z - std::sqrt(0.5)) < 1e-6);
  const auto moved =
      client.lookupTransform("map", tf2::TimePointZero, "base", tf2::TimePointZero, "map", 1s);
  CHECK(moved.transform.translation.x == 2);

  geometry_msgs::msg::PointStamped point;
  point.header.frame_id = "base";
  point.point.x = 1;
  const auto there = client.transform(point, "map", 1s);
  CHECK(std::abs(there.point.x - 2) < 1e-6 && std::abs(there.point.y - 1) < 1e-6);

  CHECK_THROWS(tf2::LookupException, client.lookupTransform("map", "nowhere", tf2::TimePointZero));
  CHECK_THROWS(tf2_ros::GoalAbortedException,
               client.lookupTransform("map", "nowhere", tf2::TimePointZero, 50ms));
  std::string why;
  CHECK(client.canTransform("base", "map", tf2::TimePointZero));
  CHECK(!client.canTransform("map", "nowhere", tf2::TimePointZero, 0s, &why));
  CHECK(why.find("nowhere") != std::string::npos);
  CHECK_THROWS(tf2::ConnectivityException,
               tf2_ros::BufferClient(node, "nobody").lookupTransform("a", "b", tf2::TimePointZero));
  const int code = checks.finish();
  spinner.join();
  return code;
}
