// See plugin_checks.hpp.
#include "checks/plugin_checks.hpp"

#include <algorithm>
#include <array>
#include <string_view>

namespace ros2wasm_sim {
namespace {

struct Successor {
  std::string_view old;
  std::string_view now;
};

/// Plugins of ROS 1, and those of ROS 2 in Gazebo Classic.
constexpr std::array kOfRos1{
    Successor{"gazebo_ros_api_plugin", "libgazebo_ros_init.so and libgazebo_ros_factory.so"},
    Successor{
        "gazebo_ros_block_laser",
        "libgazebo_ros_ray_sensor.so with <output_type>sensor_msgs/PointCloud2</output_type>"},
    Successor{"gazebo_ros_control", "libgazebo_ros2_control.so"},
    Successor{"gazebo_ros_depth_camera", "libgazebo_ros_camera.so in a sensor of type depth"},
    Successor{"gazebo_ros_gpu_laser",
              "libgazebo_ros_ray_sensor.so with <output_type>sensor_msgs/LaserScan</output_type>"},
    Successor{"gazebo_ros_imu", "libgazebo_ros_imu_sensor.so in a sensor of type imu"},
    Successor{"gazebo_ros_laser",
              "libgazebo_ros_ray_sensor.so with <output_type>sensor_msgs/LaserScan</output_type>"},
    Successor{"gazebo_ros_openni_kinect", "libgazebo_ros_camera.so in a sensor of type depth"},
    Successor{"gazebo_ros_range",
              "libgazebo_ros_ray_sensor.so with <output_type>sensor_msgs/Range</output_type>"},
    Successor{"gazebo_ros_skid_steer_drive",
              "libgazebo_ros_diff_drive.so with <num_wheel_pairs>2</num_wheel_pairs>"},
    Successor{"hector_gazebo_ros_gps", "libgazebo_ros_gps_sensor.so in a sensor of type gps"},
    Successor{"hector_gazebo_ros_imu", "libgazebo_ros_imu_sensor.so in a sensor of type imu"},
    Successor{"roboticsgroup_gazebo_mimic_joint_plugin", "<mimic> of the joint in the URDF"},
};

/// One plugin under its names in both Gazebos: the library there, and the class or, for a
/// sensor, what is written in its place.
struct Twin {
  std::string_view classic, sim;
  std::string_view library;  ///< of Gazebo Sim, without gz-sim- and -system
};
constexpr std::array kTwins{
    Twin{"gazebo_ros_ackermann_drive", "AckermannSteering", "ackermann-steering"},
    Twin{"gazebo_ros_diff_drive", "DiffDrive", "diff-drive"},
    Twin{"gazebo_ros_joint_pose_trajectory", "JointTrajectoryController",
         "joint-trajectory-controller"},
    Twin{"gazebo_ros_joint_state_publisher", "JointStatePublisher", "joint-state-publisher"},
    Twin{"gazebo_ros_p3d", "OdometryPublisher", "odometry-publisher"},
    Twin{"gazebo_ros_planar_move", "VelocityControl", "velocity-control"},
};
constexpr std::array kClassicSensors{
    Successor{"gazebo_ros_bumper", "contact"},
    Successor{"gazebo_ros_camera", "camera"},
    Successor{"gazebo_ros_ft_sensor", "force_torque"},
    Successor{"gazebo_ros_gps_sensor", "navsat"},
    Successor{"gazebo_ros_imu_sensor", "imu"},
    Successor{"gazebo_ros_ray_sensor", "gpu_lidar"},
};

struct Unread {
  std::string_view plugin, element;
  std::string_view instead;
  std::string_view otherwise;  ///< the value that the plugin has without it
};
constexpr std::string_view kCommands = "<ros><remapping>cmd_vel:=NAME</remapping></ros>";
constexpr std::string_view kOdometry = "<ros><remapping>odom:=NAME</remapping></ros>";
constexpr std::string_view kOut = "<ros><remapping>~/out:=NAME</remapping></ros>";
constexpr std::string_view kNamespace = "<ros><namespace>NAME</namespace></ros>";
constexpr std::array kUnread{
    Unread{"gazebo_ros_diff_drive", "command_topic", kCommands, "cmd_vel"},
    Unread{"gazebo_ros_diff_drive", "commandTopic", kCommands, "cmd_vel"},
    Unread{"gazebo_ros_diff_drive", "odometry_topic", kOdometry, "odom"},
    Unread{"gazebo_ros_diff_drive", "odometryTopic", kOdometry, "odom"},
    Unread{"gazebo_ros_diff_drive", "odometryFrame", "<odometry_frame>", "odom"},
    Unread{"gazebo_ros_diff_drive", "robotBaseFrame", "<robot_base_frame>", "base_footprint"},
    Unread{"gazebo_ros_diff_drive", "robotNamespace", kNamespace, "/"},
    Unread{"gazebo_ros_diff_drive", "leftJoint", "<left_joint>", ""},
    Unread{"gazebo_ros_diff_drive", "rightJoint", "<right_joint>", ""},
    Unread{"gazebo_ros_diff_drive", "wheelSeparation", "<wheel_separation>", "0.34"},
    Unread{"gazebo_ros_diff_drive", "wheelDiameter", "<wheel_diameter>", "0.15"},
    Unread{"gazebo_ros_diff_drive", "torque", "<max_wheel_torque>", "5"},
    Unread{"gazebo_ros_diff_drive", "updateRate", "<update_rate>", "100"},
    Unread{"gazebo_ros_planar_move", "commandTopic", kCommands, "cmd_vel"},
    Unread{"gazebo_ros_planar_move", "odometryTopic", kOdometry, "odom"},
    Unread{"gazebo_ros_planar_move", "odometryFrame", "<odometry_frame>", "odom"},
    Unread{"gazebo_ros_planar_move", "robotBaseFrame", "<robot_base_frame>", "base_footprint"},
    Unread{"gazebo_ros_joint_state_publisher", "jointName", "<joint_name>", ""},
    Unread{"gazebo_ros_p3d", "bodyName", "<body_name>", ""},
    Unread{"gazebo_ros_p3d", "topicName", kOdometry, "odom"},
    Unread{"gazebo_ros_ray_sensor", "topicName", kOut, ""},
    Unread{"gazebo_ros_ray_sensor", "topic_name", kOut, ""},
    Unread{"gazebo_ros_ray_sensor", "frameName", "<frame_name>", ""},
    Unread{"gazebo_ros_imu_sensor", "topicName", kOut, ""},
    Unread{"gazebo_ros_camera", "imageTopicName",
           "<ros><remapping>~/image_raw:=NAME</remapping></ros>", "image_raw"},
    Unread{"gazebo_ros_camera", "cameraName", "<camera_name>", ""},
    Unread{"gazebo_ros_camera", "frameName", "<frame_name>", ""},
    Unread{"DiffDrive", "command_topic", "<topic>", ""},
    Unread{"DiffDrive", "cmd_vel_topic", "<topic>", ""},
    Unread{"DiffDrive", "odometry_topic", "<odom_topic>", ""},
    Unread{"DiffDrive", "odom_publisher_frequency", "<odom_publish_frequency>", "50"},
    Unread{"DiffDrive", "wheel_diameter", "<wheel_radius>", "0.4"},
    Unread{"DiffDrive", "odometry_frame", "<frame_id>", ""},
    Unread{"DiffDrive", "robot_base_frame", "<child_frame_id>", ""},
};

std::string line_of(const Twin& twin) {
  return "<plugin filename=\"gz-sim-" + std::string(twin.library) +
         "-system\" name=\"gz::sim::systems::" + std::string(twin.sim) + "\">";
}

}  // namespace

std::string successor_of(const std::string& name, bool is_classic) {
  const auto named = [&](const Successor& one) { return one.old == name; };
  const auto old = std::find_if(kOfRos1.begin(), kOfRos1.end(), named);
  const auto twin = std::find_if(kTwins.begin(), kTwins.end(), [&](const Twin& one) {
    return name == (is_classic ? one.sim : one.classic);
  });
  if (is_classic && old != kOfRos1.end())
    return "it is a plugin of ROS 1; in ROS 2 it is " + std::string(old->now);
  if (is_classic && twin != kTwins.end())
    return "it is a plugin of Gazebo Sim; Gazebo Classic has lib" + std::string(twin->classic) +
           ".so";
  if (is_classic) return "";
  if (twin != kTwins.end())
    return "it is a plugin of Gazebo Classic; Gazebo Sim has " + line_of(*twin);
  const auto sensor = std::find_if(kClassicSensors.begin(), kClassicSensors.end(), named);
  if (sensor != kClassicSensors.end())
    return "it is a plugin of Gazebo Classic; in Gazebo Sim a <sensor type=\"" +
           std::string(sensor->now) +
           "\"> with a <topic> needs no plugin, and a bridge carries its topic to ROS";
  return old == kOfRos1.end() ? "" : "it is a plugin of ROS 1 for Gazebo Classic";
}

std::vector<std::string> unread_elements(const std::string& name, const Parameters& given) {
  std::vector<std::string> remarks;
  for (const Unread& row : kUnread) {
    const std::string element(row.element);
    if (row.plugin != name || !given.has(element)) continue;
    std::string value = given.text(element, "");
    if (row.element.size() > 5 && row.element.find("opic") != std::string_view::npos &&
        value.rfind('/', 0) == 0)
      value.erase(0, 1);
    if (!row.otherwise.empty() && value == row.otherwise) continue;
    remarks.push_back("<" + element + "> is not read by this plugin: write " +
                      std::string(row.instead) + " in its place");
  }
  return remarks;
}

}  // namespace ros2wasm_sim
