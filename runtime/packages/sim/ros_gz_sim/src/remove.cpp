// remove: takes a model out of the world of a running Gazebo Sim, and ends. The lines of the log
// are those of ros_gz_sim.
#include "rclcpp/rclcpp.hpp"
#include "ros_gz_interfaces/srv/delete_entity.hpp"
#include "world.hpp"

namespace ros_gz_sim {
namespace {

using DeleteEntity = ros_gz_interfaces::srv::DeleteEntity;

int remove_entity(const rclcpp::Node::SharedPtr& node) {
  std::string world = node->declare_parameter("world", "");
  const std::string name = node->declare_parameter("entity_name", "");
  if (name.empty()) {
    RCLCPP_ERROR(node->get_logger(),
                 "Entity to remove name is not provided, entity will not be removed.");
    return -1;
  }
  if (world.empty()) {
    const auto found = name_of_world(node);
    if (!found) {
      RCLCPP_INFO(node->get_logger(), "Timed out when getting world names.");
      return -1;
    }
    world = *found;
  }
  const auto request = std::make_shared<DeleteEntity::Request>();
  request->entity.name = name;
  request->entity.type = ros_gz_interfaces::msg::Entity::MODEL;
  const auto answer = answer_of<DeleteEntity>(node, "/world/" + world + "/remove", request);
  if (!answer) {
    RCLCPP_INFO(node->get_logger(), "Entity removal was interrupted.");
    return 0;
  }
  if (answer->success) {
    RCLCPP_INFO(node->get_logger(), "Entity removal successful.");
    return 0;
  }
  RCLCPP_ERROR(node->get_logger(), "Entity removal failed.\n name: \"%s\"", name.c_str());
  return 1;
}

}  // namespace
}  // namespace ros_gz_sim

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  const int exit_code = ros_gz_sim::remove_entity(rclcpp::Node::make_shared("ros_gz_sim"));
  rclcpp::shutdown();
  return exit_code;
}
