// See photo_at_waypoint.hpp.
#include "nav2_waypoint_follower/plugins/photo_at_waypoint.hpp"

#include <fstream>
#include <memory>
#include <stdexcept>
#include <system_error>

#include "nav2_util/node_utils.hpp"
#include "photo_file.hpp"
#include "pluginlib/class_list_macros.hpp"
#include "ros2wasm/files.hpp"

namespace nav2_waypoint_follower {

void PhotoAtWaypoint::initialize(const rclcpp_lifecycle::LifecycleNode::WeakPtr& parent,
                                 const std::string& plugin_name) {
  const auto node = parent.lock();
  if (!node) throw std::runtime_error{"Failed to lock node in photo at waypoint plugin!"};
  curr_frame_msg_ = std::make_shared<sensor_msgs::msg::Image>();
  const auto read = [&node, &plugin_name](const std::string& name, const auto& value) {
    const std::string full = plugin_name + "." + name;
    nav2_util::declare_parameter_if_not_declared(node, full, rclcpp::ParameterValue(value));
    return node->get_parameter(full);
  };
  is_enabled_ = read("enabled", true).as_bool();
  image_topic_ = read("image_topic", "/camera/color/image_raw").as_string();
  save_dir_ = read("save_dir", "/tmp/waypoint_images").as_string();
  image_format_ = read("image_format", "png").as_string();
  is_enabled_ = makeFolder() && is_enabled_;
  if (!is_enabled_) {
    RCLCPP_INFO(logger_, "Photo at waypoint plugin is disabled.");
    return;
  }
  if (const std::string error = unsupported_format(image_format_); !error.empty()) {
    throw std::runtime_error(plugin_name + ".image_format: " + error);
  }
  RCLCPP_INFO(logger_,
              "Initializing photo at waypoint plugin, subscribing to camera topic named; %s",
              image_topic_.c_str());
  camera_image_subscriber_ = node->create_subscription<sensor_msgs::msg::Image>(
      image_topic_, rclcpp::SystemDefaultsQoS(),
      [this](const sensor_msgs::msg::Image::SharedPtr msg) { imageCallback(msg); });
}

bool PhotoAtWaypoint::makeFolder() {
  std::error_code error;
  if (std::filesystem::exists(save_dir_, error)) return true;
  RCLCPP_WARN(logger_,
              "Provided save directory for photo at waypoint plugin does not exist,"
              "provided directory is: %s, the directory will be created automatically.",
              save_dir_.c_str());
  if (std::filesystem::create_directory(save_dir_, error)) return true;
  RCLCPP_ERROR(logger_,
               "Failed to create directory!: %s required by photo at waypoint plugin, "
               "exiting the plugin with failure!",
               save_dir_.c_str());
  return false;
}

bool PhotoAtWaypoint::processAtWaypoint(const geometry_msgs::msg::PoseStamped& curr_pose,
                                        const int& curr_waypoint_index) {
  if (!is_enabled_) {
    RCLCPP_WARN(logger_, "Photo at waypoint plugin is disabled. Not performing anything");
    return true;
  }
  const std::lock_guard<std::mutex> lock(global_mutex_);
  try {
    const sensor_msgs::msg::Image& image = *curr_frame_msg_;
    const std::string bytes = photo_file(
        {image.width, image.height, image.step, image.encoding, image.data}, image_format_);
    const std::filesystem::path path =
        save_dir_ / (std::to_string(curr_waypoint_index) + "_" +
                     std::to_string(curr_pose.header.stamp.sec) + "." + image_format_);
    std::ofstream file(path, std::ios::binary);
    file << bytes;
    file.close();
    if (!file) throw std::runtime_error("cannot write " + path.string());
    ros2wasm::give_file(path.string());
  } catch (const std::exception& error) {
    RCLCPP_ERROR(logger_,
                 "Couldn't take photo at waypoint %i! Caught exception: %s \n"
                 "Make sure that the image topic named: %s is valid and active!",
                 curr_waypoint_index, error.what(), image_topic_.c_str());
    return false;
  }
  RCLCPP_INFO(logger_, "Photo has been taken sucessfully at waypoint %i", curr_waypoint_index);
  return true;
}

void PhotoAtWaypoint::imageCallback(const sensor_msgs::msg::Image::SharedPtr msg) {
  const std::lock_guard<std::mutex> lock(global_mutex_);
  curr_frame_msg_ = msg;
}

}  // namespace nav2_waypoint_follower

PLUGINLIB_EXPORT_CLASS(nav2_waypoint_follower::PhotoAtWaypoint, nav2_core::WaypointTaskExecutor)
