// Pictures, distances and points of cameras as messages of sensor_msgs. Headers are left empty.
#pragma once

#include <sensor_msgs/msg/camera_info.hpp>
#include <sensor_msgs/msg/compressed_image.hpp>
#include <sensor_msgs/msg/image.hpp>
#include <sensor_msgs/msg/point_cloud2.hpp>

#include <optional>
#include <string>

#include "sensors/camera_settings.hpp"

namespace ros2wasm_sim {

/// The encoding of ROS for a format of SDF, such as rgb8 for R8G8B8. Nothing when it is not
/// supported.
std::optional<std::string> encoding_of(const std::string& format);

/// `encoding` is rgb8, bgr8 or mono8.
sensor_msgs::msg::Image image_message(const Picture& picture, const std::string& encoding);
sensor_msgs::msg::CompressedImage jpeg_message(const Picture& picture);

/// Depths in metres: -infinity below `min`, infinity from `max` on.
sensor_msgs::msg::Image depth_message(const Camera& camera, double min, double max);

/// `cx`, `cy`: where the axis meets the picture by the count of pixels that the simulator has.
/// `baseline`: metres from the left camera of a pair.
sensor_msgs::msg::CameraInfo info_message(const CameraSettings& settings, double cx, double cy,
                                          double baseline);

/// Along which axes the points of a depth camera are given.
enum class CloudAxes { kOptical, kBody };

/// x, y, z and rgb for each pixel. Points outside of `min` to `max` are infinite in the body's
/// axes, as in Gazebo Sim, and NaN in the optical ones, as in Gazebo Classic.
sensor_msgs::msg::PointCloud2 depth_cloud_message(const Camera& camera, CloudAxes axes, double min,
                                                  double max);

}  // namespace ros2wasm_sim
