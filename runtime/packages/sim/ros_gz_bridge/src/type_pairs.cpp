// See type_pairs.hpp.
#include "type_pairs.hpp"

#include <algorithm>
#include <iterator>
#include <string_view>

#include "conversions.hpp"

namespace ros_gz_bridge {
namespace {

/// The same message on both sides.
constexpr TypePair same(const char* ros_type, const char* gz_type) {
  return {ros_type, gz_type, ros_type};
}
constexpr TypePair same_with_header(const char* ros_type, const char* gz_type) {
  return {ros_type, gz_type, ros_type, nullptr, true};
}
constexpr TypePair other(const char* ros_type, const char* gz_type, const char* hidden_type,
                         const Conversion& conversion, bool begins_with_header) {
  return {ros_type, gz_type, hidden_type, &conversion, begins_with_header};
}

const TypePair kPairs[] = {
    same("actuator_msgs/msg/Actuators", "Actuators"),
    same("builtin_interfaces/msg/Time", "Time"),
    other("geometry_msgs/msg/Point", "Vector3d", "geometry_msgs/msg/Vector3", kPointVector3, false),
    same("geometry_msgs/msg/Vector3", "Vector3d"),
    same("geometry_msgs/msg/Pose", "Pose"),
    other("geometry_msgs/msg/PoseStamped", "Pose", "geometry_msgs/msg/Pose", kPoseStampedPose,
          true),
    other("geometry_msgs/msg/PoseArray", "Pose_V", "tf2_msgs/msg/TFMessage", kPoseArrayTransforms,
          true),
    same("geometry_msgs/msg/PoseWithCovariance", "PoseWithCovariance"),
    other("geometry_msgs/msg/PoseWithCovarianceStamped", "PoseWithCovariance",
          "geometry_msgs/msg/PoseWithCovariance", kPoseCovarianceStamped, true),
    same("geometry_msgs/msg/Quaternion", "Quaternion"),
    other("geometry_msgs/msg/Transform", "Pose", "geometry_msgs/msg/Pose", kTransformPose, false),
    other("geometry_msgs/msg/TransformStamped", "Pose", "geometry_msgs/msg/Pose",
          kTransformStampedPose, true),
    same("geometry_msgs/msg/Twist", "Twist"),
    other("geometry_msgs/msg/TwistStamped", "Twist", "geometry_msgs/msg/Twist", kTwistStampedTwist,
          true),
    same("geometry_msgs/msg/TwistWithCovariance", "TwistWithCovariance"),
    other("geometry_msgs/msg/TwistWithCovarianceStamped", "TwistWithCovariance",
          "geometry_msgs/msg/TwistWithCovariance", kTwistCovarianceStamped, true),
    other("geometry_msgs/msg/Wrench", "Wrench", "geometry_msgs/msg/WrenchStamped",
          kWrenchWrenchStamped, false),
    same_with_header("geometry_msgs/msg/WrenchStamped", "Wrench"),
    other("gps_msgs/msg/GPSFix", "NavSat", "sensor_msgs/msg/NavSatFix", kGpsFixNavSat, true),
    same_with_header("nav_msgs/msg/Odometry", "Odometry"),
    same_with_header("nav_msgs/msg/Odometry", "OdometryWithCovariance"),
    same("rcl_interfaces/msg/ParameterValue", "Any"),
    same_with_header("ros_gz_interfaces/msg/Altimeter", "Altimeter"),
    same("ros_gz_interfaces/msg/Contact", "Contact"),
    same_with_header("ros_gz_interfaces/msg/Contacts", "Contacts"),
    same_with_header("ros_gz_interfaces/msg/Dataframe", "Dataframe"),
    same("ros_gz_interfaces/msg/Entity", "Entity"),
    same_with_header("ros_gz_interfaces/msg/EntityWrench", "EntityWrench"),
    same("ros_gz_interfaces/msg/Float32Array", "Float_V"),
    same_with_header("ros_gz_interfaces/msg/GuiCamera", "GUICamera"),
    same_with_header("ros_gz_interfaces/msg/JointWrench", "JointWrench"),
    same_with_header("ros_gz_interfaces/msg/Light", "Light"),
    same_with_header("ros_gz_interfaces/msg/LogicalCameraImage", "LogicalCameraImage"),
    same_with_header("ros_gz_interfaces/msg/MaterialColor", "MaterialColor"),
    same_with_header("ros_gz_interfaces/msg/ParamVec", "Param"),
    same_with_header("ros_gz_interfaces/msg/ParamVec", "Param_V"),
    same_with_header("ros_gz_interfaces/msg/SensorNoise", "SensorNoise"),
    same_with_header("ros_gz_interfaces/msg/StringVec", "StringMsg_V"),
    same_with_header("ros_gz_interfaces/msg/TrackVisual", "TrackVisual"),
    same_with_header("ros_gz_interfaces/msg/VideoRecord", "VideoRecord"),
    same("rosgraph_msgs/msg/Clock", "Clock"),
    same_with_header("sensor_msgs/msg/BatteryState", "BatteryState"),
    same_with_header("sensor_msgs/msg/CameraInfo", "CameraInfo"),
    same_with_header("sensor_msgs/msg/FluidPressure", "FluidPressure"),
    same_with_header("sensor_msgs/msg/Image", "Image"),
    same_with_header("sensor_msgs/msg/Imu", "IMU"),
    same_with_header("sensor_msgs/msg/JointState", "Model"),
    same_with_header("sensor_msgs/msg/Joy", "Joy"),
    same_with_header("sensor_msgs/msg/LaserScan", "LaserScan"),
    same_with_header("sensor_msgs/msg/MagneticField", "Magnetometer"),
    same_with_header("sensor_msgs/msg/NavSatFix", "NavSat"),
    same_with_header("sensor_msgs/msg/PointCloud2", "PointCloudPacked"),
    other("sensor_msgs/msg/Range", "LaserScan", "sensor_msgs/msg/LaserScan", kRangeLaserScan, true),
    same("std_msgs/msg/Bool", "Boolean"),
    same("std_msgs/msg/ColorRGBA", "Color"),
    same("std_msgs/msg/Empty", "Empty"),
    same("std_msgs/msg/Float32", "Float"),
    same("std_msgs/msg/Float64", "Double"),
    same_with_header("std_msgs/msg/Header", "Header"),
    same("std_msgs/msg/Int32", "Int32"),
    same("std_msgs/msg/String", "StringMsg"),
    same("std_msgs/msg/UInt32", "UInt32"),
    same("tf2_msgs/msg/TFMessage", "Pose_V"),
    same_with_header("trajectory_msgs/msg/JointTrajectory", "JointTrajectory"),
    same_with_header("vision_msgs/msg/Detection2D", "AnnotatedAxisAligned2DBox"),
    same_with_header("vision_msgs/msg/Detection2DArray", "AnnotatedAxisAligned2DBox_V"),
    same_with_header("vision_msgs/msg/Detection3D", "AnnotatedOriented3DBox"),
    same_with_header("vision_msgs/msg/Detection3DArray", "AnnotatedOriented3DBox_V"),
};

}  // namespace

const TypePair* find_type_pair(const std::string& ros_type, const std::string& gz_type) {
  for (const std::string_view prefix : {"gz.msgs.", "ignition.msgs."}) {
    if (gz_type.compare(0, prefix.size(), prefix) != 0) continue;
    const std::string name = gz_type.substr(prefix.size());
    const auto* const found = std::find_if(
        std::begin(kPairs), std::end(kPairs),
        [&](const TypePair& one) { return one.ros_type == ros_type && one.gz_type == name; });
    return found == std::end(kPairs) ? nullptr : found;
  }
  return nullptr;
}

}  // namespace ros_gz_bridge
