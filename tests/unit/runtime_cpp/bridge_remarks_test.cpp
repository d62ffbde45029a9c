// The remarks of a bridge on topics that nothing crosses.
#include "bridge_remarks.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace ros_gz_bridge {
namespace {

using testing::HasSubstr;

constexpr const char* kTwist = "geometry_msgs/msg/Twist";
constexpr const char* kScan = "sensor_msgs/msg/LaserScan";

/// The same name on both sides.
BridgeEntry entry(const std::string& topic, const std::string& ros_type, const std::string& gz_type,
                  Direction direction) {
  BridgeEntry result;
  result.ros_topic = result.gz_topic = topic;
  result.ros_type = ros_type;
  result.gz_type = gz_type;
  result.direction = direction;
  return result;
}
BridgeEntry commands(Direction direction, const std::string& topic = "/cmd_vel") {
  return entry(topic, kTwist, "gz.msgs.Twist", direction);
}
BridgeEntry scan(Direction direction, const std::string& topic = "/scan") {
  return entry(topic, kScan, "gz.msgs.LaserScan", direction);
}

const GzTopics kTopics{{"/clock", {"rosgraph_msgs/msg/Clock", true, false}},
                       {"/model/m/cmd_vel", {kTwist, false, true}},
                       {"/scan", {kScan, true, false}}};

TEST(BridgeRemarks, TopicsThatAreConnected) {
  EXPECT_TRUE(is_connected(scan(Direction::kGzToRos), kScan, kTopics));
  EXPECT_TRUE(is_connected(scan(Direction::kBoth, "scan"), kScan, kTopics)) << "without a slash";
  EXPECT_TRUE(is_connected(commands(Direction::kRosToGz, "/model/m/cmd_vel"), kTwist, kTopics));
  EXPECT_FALSE(is_connected(scan(Direction::kRosToGz), kScan, kTopics));
  EXPECT_FALSE(is_connected(commands(Direction::kRosToGz), kTwist, kTopics));
  EXPECT_FALSE(is_connected(scan(Direction::kGzToRos), "sensor_msgs/msg/PointCloud2", kTopics));
}

TEST(BridgeRemarks, TheNameOfTheModelIsMissing) {
  EXPECT_EQ(gz_remark(commands(Direction::kRosToGz), kTwist, kTopics),
            "nothing in Gazebo reads [/cmd_vel]; the nearest topic is [/model/m/cmd_vel]. Write "
            "`/model/m/cmd_vel@geometry_msgs/msg/Twist]gz.msgs.Twist` and remap it "
            "(`/model/m/cmd_vel:=/cmd_vel`), or give the plugin or sensor a <topic>");
  EXPECT_THAT(gz_remark(scan(Direction::kGzToRos, "/scna"), kScan, kTopics),
              HasSubstr("publishes [/scna]; the nearest topic is [/scan]"));
}

TEST(BridgeRemarks, TheDirectionIsWrong) {
  EXPECT_EQ(gz_remark(scan(Direction::kRosToGz), kScan, kTopics),
            "the bridge of [/scan] goes the wrong way: Gazebo publishes it. Write "
            "`/scan@sensor_msgs/msg/LaserScan[gz.msgs.LaserScan`, or in a YAML file `direction: "
            "GZ_TO_ROS`");
  EXPECT_THAT(gz_remark(commands(Direction::kGzToRos, "/model/m/cmd_vel"), kTwist, kTopics),
              HasSubstr("Gazebo reads it. Write `/model/m/cmd_vel@geometry_msgs/msg/Twist]"));
}

TEST(BridgeRemarks, NothingIsLikeIt) {
  EXPECT_EQ(gz_remark(entry("/imu", "sensor_msgs/msg/Imu", "gz.msgs.IMU", Direction::kGzToRos),
                      "sensor_msgs/msg/Imu", kTopics),
            "nothing in Gazebo publishes [/imu]. Topics that it publishes: /clock, /scan. Is the "
            "model there, with its plugin or sensor?");
  EXPECT_THAT(gz_remark(entry("/scan", "sensor_msgs/msg/PointCloud2", "gz.msgs.PointCloudPacked",
                              Direction::kGzToRos),
                        "sensor_msgs/msg/PointCloud2", kTopics),
              HasSubstr("[/scan] is not of the type gz.msgs.PointCloudPacked: in ROS it is "
                        "sensor_msgs/msg/LaserScan"));
}

TEST(BridgeRemarks, BothWays) {
  EXPECT_THAT(
      both_ways_remark({scan(Direction::kBoth), commands(Direction::kBoth, "/model/m/cmd_vel")},
                       kTopics),
      HasSubstr("carries [/scan] both ways"));
  EXPECT_EQ(both_ways_remark({scan(Direction::kGzToRos)}, kTopics), "");
  EXPECT_EQ(both_ways_remark({commands(Direction::kBoth, "/model/m/cmd_vel")}, kTopics), "");
}

TEST(BridgeRemarks, ANodeWithAnotherType) {
  EXPECT_EQ(
      type_remark(commands(Direction::kRosToGz), "teleop", "geometry_msgs/msg/TwistStamped", true,
                  true),
      "[teleop] publishes [/cmd_vel] as geometry_msgs/msg/TwistStamped, but the bridge has it "
      "as geometry_msgs/msg/Twist, so no message arrives. Write "
      "`/cmd_vel@geometry_msgs/msg/TwistStamped]gz.msgs.Twist`, or let the node use "
      "geometry_msgs/msg/Twist (many nodes have a parameter for it, such as `stamped` or "
      "`use_stamped`)");
  EXPECT_THAT(type_remark(scan(Direction::kGzToRos), "viewer", "std_msgs/msg/String", false, false),
              HasSubstr("[viewer] reads [/scan] as std_msgs/msg/String, but the bridge has it as "
                        "sensor_msgs/msg/LaserScan, so no message arrives. Let the node use"));
}

}  // namespace
}  // namespace ros_gz_bridge
