// create: puts a model into the world of a running Gazebo Sim, and ends. The lines of the log are
// those of ros_gz_sim.
#include <cmath>
#include <iostream>
#include <utility>

#include "create_flags.hpp"
#include "rclcpp/rclcpp.hpp"
#include "ros2wasm_sim/description_topic.hpp"
#include "ros_gz_interfaces/srv/spawn_entity.hpp"
#include "std_msgs/msg/string.hpp"
#include "world.hpp"

namespace ros_gz_sim {
namespace {

using SpawnEntity = ros_gz_interfaces::srv::SpawnEntity;
using EntityFactory = ros_gz_interfaces::msg::EntityFactory;

constexpr int kFailed = 1;
constexpr int kRefused = -1;  // 255 for the shell

void declare_parameters(rclcpp::Node& node) {
  for (const char* name : {"world", "file", "string", "topic", "name"})
    node.declare_parameter(name, "");
  node.declare_parameter("allow_renaming", false);
  for (const char* name : {"x", "y", "z", "R", "P", "Y"}) node.declare_parameter(name, 0.0);
}

std::string text_parameter(const rclcpp::Node& node, const char* name) {
  return node.get_parameter(name).as_string();
}

bool take_from_topic(const rclcpp::Node::SharedPtr& node, const std::string& topic,
                     EntityFactory& entity) {
  std::promise<std::string> promise;
  const std::shared_future<std::string> text = promise.get_future();
  bool is_known = false;
  const auto subscription = node->create_subscription<std_msgs::msg::String>(
      topic, rclcpp::QoS(1).transient_local(), [&](const std_msgs::msg::String& message) {
        if (!std::exchange(is_known, true)) promise.set_value(message.data);
      });
  constexpr int kPatience = 5;  // seconds
  for (int waited = 0; rclcpp::ok(); ++waited) {
    if (waited == kPatience)
      RCLCPP_WARN(node->get_logger(), "%s", ros2wasm_sim::silent_description(*node, topic).c_str());
    RCLCPP_INFO(node->get_logger(), "Waiting messages on topic [%s].", topic.c_str());
    if (rclcpp::spin_until_future_complete(node, text, std::chrono::seconds(1)) ==
        rclcpp::FutureReturnCode::SUCCESS) {
      entity.sdf = text.get();
      return true;
    }
  }
  RCLCPP_ERROR(node->get_logger(), "Failed to get XML from topic [%s].", topic.c_str());
  return false;
}

/// The description, from where parameters or else flags say. False when there is none, which is
/// reported.
bool take_description(const rclcpp::Node::SharedPtr& node, const CreateFlags& flags, bool has_flags,
                      EntityFactory& entity) {
  const std::string file = text_parameter(*node, "file");
  const std::string string = text_parameter(*node, "string");
  const std::string topic = text_parameter(*node, "topic");
  if (!file.empty() || !string.empty()) {
    (file.empty() ? entity.sdf : entity.sdf_filename) = file.empty() ? string : file;
    return true;
  }
  if (!topic.empty()) return take_from_topic(node, topic, entity);
  if (!has_flags) {
    RCLCPP_ERROR(node->get_logger(),
                 "Must specify either file, string or topic as ROS 2 parameters");
    return false;
  }
  if (!flags.file.empty()) {
    entity.sdf_filename = flags.file;
  } else if (!flags.param.empty()) {
    if (!node->has_parameter(flags.param)) node->declare_parameter(flags.param, "");
    entity.sdf = text_parameter(*node, flags.param.c_str());
    if (!entity.sdf.empty()) return true;
    RCLCPP_ERROR(node->get_logger(), "Failed to get XML from param [%s].", flags.param.c_str());
    return false;
  } else if (!flags.string.empty()) {
    entity.sdf = flags.string;
  } else if (!flags.topic.empty()) {
    return take_from_topic(node, flags.topic, entity);
  } else {
    RCLCPP_ERROR(node->get_logger(), "Must specify either -file, -param, -string or -topic");
    return false;
  }
  return true;
}

/// A parameter that is not 0 wins.
geometry_msgs::msg::Pose pose_of(const rclcpp::Node& node, const CreateFlags& flags) {
  const auto number = [&](const char* name, double flag) {
    const double set = node.get_parameter(name).as_double();
    return set != 0 ? set : flag;
  };
  const double roll = number("R", flags.roll) / 2;
  const double pitch = number("P", flags.pitch) / 2;
  const double yaw = number("Y", flags.yaw) / 2;
  const double cr = std::cos(roll), sr = std::sin(roll);
  const double cp = std::cos(pitch), sp = std::sin(pitch);
  const double cy = std::cos(yaw), sy = std::sin(yaw);
  geometry_msgs::msg::Pose pose;
  pose.position.x = number("x", flags.x);
  pose.position.y = number("y", flags.y);
  pose.position.z = number("z", flags.z);
  pose.orientation.w = cr * cp * cy + sr * sp * sy;
  pose.orientation.x = sr * cp * cy - cr * sp * sy;
  pose.orientation.y = cr * sp * cy + sr * cp * sy;
  pose.orientation.z = cr * cp * sy - sr * sp * cy;
  return pose;
}

std::string shown(const EntityFactory& entity) {
  std::string text = "name: \"" + entity.name + "\"";
  if (!entity.sdf_filename.empty()) text += "\n sdf_filename: \"" + entity.sdf_filename + "\"";
  if (!entity.sdf.empty()) text += "\n sdf: \"" + entity.sdf + "\"";
  return text;
}

int create(const rclcpp::Node::SharedPtr& node, const CreateFlags& flags, bool has_flags) {
  declare_parameters(*node);
  std::string world = text_parameter(*node, "world");
  if (world.empty()) world = flags.world;
  if (world.empty()) {
    const auto name = name_of_world(node);
    if (!name) {
      RCLCPP_INFO(node->get_logger(), "Timed out when getting world names.");
      return kRefused;
    }
    world = *name;
  }
  const auto request = std::make_shared<SpawnEntity::Request>();
  EntityFactory& entity = request->entity_factory;
  if (!take_description(node, flags, has_flags, entity)) return kRefused;
  entity.pose = pose_of(*node, flags);
  entity.name = text_parameter(*node, "name");
  if (entity.name.empty()) entity.name = flags.name;
  entity.allow_renaming = node->get_parameter("allow_renaming").as_bool() || flags.allow_renaming;
  const auto answer = answer_of<SpawnEntity>(node, "/world/" + world + "/create", request);
  if (!answer) {
    RCLCPP_INFO(node->get_logger(), "Entity creation was interrupted.");
    return 0;
  }
  if (answer->success) {
    RCLCPP_INFO(node->get_logger(), "Entity creation successful.");
    return 0;
  }
  RCLCPP_ERROR(node->get_logger(), "Entity creation failed.\n %s", shown(entity).c_str());
  return kFailed;
}

}  // namespace
}  // namespace ros_gz_sim

int main(int argc, char** argv) {
  auto words = rclcpp::init_and_remove_ros_arguments(argc, argv);
  if (!words.empty()) words.erase(words.begin());
  const auto flags = ros_gz_sim::read_create_flags(words);
  if (!flags.fault.empty()) {
    std::cerr << "ERROR: " << flags.fault << std::endl;
    rclcpp::shutdown();
    return 1;
  }
  const int exit_code =
      ros_gz_sim::create(rclcpp::Node::make_shared("ros_gz_sim"), flags, !words.empty());
  rclcpp::shutdown();
  return exit_code;
}
