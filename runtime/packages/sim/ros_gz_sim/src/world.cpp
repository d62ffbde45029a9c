// See world.hpp.
#include "world.hpp"

#include <chrono>
#include <future>
#include <utility>

#include "ros2wasm_sim/gz_names.hpp"
#include "ros_gz_interfaces/srv/delete_entity.hpp"
#include "ros_gz_interfaces/srv/spawn_entity.hpp"
#include "std_msgs/msg/string.hpp"

namespace ros_gz_sim {
namespace {

constexpr std::chrono::seconds kPatience{5};
constexpr int kTriesBeforeHint = 2;

/// The other world, when one runs.
void report_other_world(const rclcpp::Node::SharedPtr& node, const std::string& service) {
  std::promise<std::string> promise;
  auto name = promise.get_future().share();
  bool is_known = false;
  const auto subscription = node->create_subscription<std_msgs::msg::String>(
      ros2wasm_sim::kWorldName, rclcpp::QoS(1).transient_local(),
      [&](const std_msgs::msg::String& message) {
        if (!std::exchange(is_known, true)) promise.set_value(message.data);
      });
  if (rclcpp::spin_until_future_complete(node, name, std::chrono::seconds(1)) ==
          rclcpp::FutureReturnCode::SUCCESS &&
      service.rfind("/world/" + name.get() + "/", 0) != 0)
    RCLCPP_WARN(node->get_logger(),
                "the world that runs is [%s]: write `-world %s`, or leave -world away",
                name.get().c_str(), name.get().c_str());
}

}  // namespace

std::optional<std::string> name_of_world(const rclcpp::Node::SharedPtr& node) {
  std::promise<std::string> promise;
  const std::shared_future<std::string> name = promise.get_future();
  bool is_known = false;
  const auto subscription = node->create_subscription<std_msgs::msg::String>(
      ros2wasm_sim::kWorldName, rclcpp::QoS(1).transient_local(),
      [&](const std_msgs::msg::String& message) {
        if (!std::exchange(is_known, true)) promise.set_value(message.data);
      });
  for (int tries = 0; rclcpp::ok(); ++tries) {
    if (tries == kTriesBeforeHint)
      RCLCPP_WARN(
          node->get_logger(),
          "no world of Gazebo Sim answers: gz_sim.launch.py of ros_gz_sim, or `gz sim WORLD`, "
          "starts one. If it was started, its own messages say why it has ended");
    RCLCPP_INFO(node->get_logger(), "Requesting list of world names.");
    if (rclcpp::spin_until_future_complete(node, name, kPatience) ==
        rclcpp::FutureReturnCode::SUCCESS)
      return name.get();
  }
  return std::nullopt;
}

template <typename Service>
typename Service::Response::SharedPtr answer_of(const rclcpp::Node::SharedPtr& node,
                                                const std::string& service,
                                                typename Service::Request::SharedPtr request) {
  const auto client = node->create_client<Service>(ros2wasm_sim::hidden_name(service));
  bool has_waited = false;
  while (rclcpp::ok()) {
    if (client->wait_for_service(kPatience)) {
      auto answer = client->async_send_request(request);
      if (rclcpp::spin_until_future_complete(node, answer) == rclcpp::FutureReturnCode::SUCCESS)
        return answer.get();
    } else if (rclcpp::ok()) {
      if (!std::exchange(has_waited, true)) report_other_world(node, service);
      RCLCPP_WARN(node->get_logger(), "Waiting for service [%s] to become available ...",
                  service.c_str());
    }
  }
  return nullptr;
}

template ros_gz_interfaces::srv::SpawnEntity::Response::SharedPtr answer_of<
    ros_gz_interfaces::srv::SpawnEntity>(const rclcpp::Node::SharedPtr&, const std::string&,
                                         ros_gz_interfaces::srv::SpawnEntity::Request::SharedPtr);
template ros_gz_interfaces::srv::DeleteEntity::Response::SharedPtr answer_of<
    ros_gz_interfaces::srv::DeleteEntity>(const rclcpp::Node::SharedPtr&, const std::string&,
                                          ros_gz_interfaces::srv::DeleteEntity::Request::SharedPtr);

}  // namespace ros_gz_sim
