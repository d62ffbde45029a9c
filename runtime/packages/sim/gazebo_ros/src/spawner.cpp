// See spawner.hpp. The lines of the log are those of gazebo_ros.
#include "spawner.hpp"

#include <sys/stat.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <fstream>
#include <iostream>
#include <iterator>
#include <utility>

#include "entity_text.hpp"
#include "gazebo_msgs/msg/model_states.hpp"
#include "gazebo_msgs/srv/delete_entity.hpp"
#include "gazebo_msgs/srv/spawn_entity.hpp"
#include "ros2wasm_sim/description_topic.hpp"
#include "std_msgs/msg/string.hpp"
#include "std_srvs/srv/empty.hpp"

namespace gazebo_ros {
namespace {

constexpr const char* kFactory = "GazeboRosFactory";
constexpr std::chrono::seconds kPatience{5};

std::string all_of(std::istream& from) {
  return {std::istreambuf_iterator<char>(from), {}};
}

}  // namespace

Spawner::Spawner(Arguments arguments)
    : arguments_(std::move(arguments)), node_(rclcpp::Node::make_shared("spawn_entity")) {
  executor_.add_node(node_);
}

int Spawner::run() {
  const auto logger = node_->get_logger();
  RCLCPP_INFO(logger, "Spawn Entity started");
  if (!arguments_.wait_for.empty()) wait_for_entity();
  auto text = description();
  if (!text) return 1;
  if (const std::string fault = fault_of_xml(*text); !fault.empty()) {
    RCLCPP_ERROR(logger, "Invalid XML: %s", fault.c_str());
    return 1;
  }
  if (arguments_.package_to_model) text = with_models_for_packages(*text);
  if (arguments_.pauses) call_empty("pause_physics");
  if (!spawn(*text)) {
    RCLCPP_ERROR(logger, "Spawn service failed. Exiting.");
    return 1;
  }
  if (arguments_.unpauses) call_empty("unpause_physics");
  if (arguments_.is_bound) {
    RCLCPP_INFO(logger, "Waiting for shutdown to delete entity [%s]", arguments_.entity.c_str());
    executor_.spin();
    remove();
  }
  return 0;
}

void Spawner::wait_for_entity() {
  bool is_there = false;
  const auto subscription = node_->create_subscription<gazebo_msgs::msg::ModelStates>(
      arguments_.gazebo_namespace + "/model_states", 10,
      [&](const gazebo_msgs::msg::ModelStates& states) {
        is_there = std::count(states.name.begin(), states.name.end(), arguments_.wait_for) > 0;
      });
  RCLCPP_INFO(node_->get_logger(), "Waiting for entity %s before proceeding.",
              arguments_.wait_for.c_str());
  while (rclcpp::ok() && !is_there) executor_.spin_once();
}

std::optional<std::string> Spawner::description() {
  const auto logger = node_->get_logger();
  if (!arguments_.file.empty()) return text_of_file();
  if (!arguments_.topic.empty()) return text_of_topic();
  if (!arguments_.database.empty()) {
    RCLCPP_INFO(logger, "Loading entity XML from Gazebo Model Database");
    return database_entity(arguments_.database);
  }
  RCLCPP_INFO(logger, "Loading entity XML from stdin");
  std::string text = all_of(std::cin);
  if (!text.empty()) return text;
  RCLCPP_ERROR(logger, "Error: stdin buffer was empty");
  return std::nullopt;
}

std::optional<std::string> Spawner::text_of_file() {
  const auto logger = node_->get_logger();
  const char* const path = arguments_.file.c_str();
  RCLCPP_INFO(logger, "Loading entity XML from file %s", path);
  struct stat facts {};
  if (stat(path, &facts) != 0) {
    RCLCPP_ERROR(logger, "Error: specified file %s does not exist", path);
    return std::nullopt;
  }
  if (!S_ISREG(facts.st_mode)) {
    RCLCPP_ERROR(logger, "Error: specified file %s is not a file", path);
    return std::nullopt;
  }
  std::ifstream file(path);
  if (!file) {
    RCLCPP_ERROR(logger, "Error reading file %s: it cannot be opened", path);
    return std::nullopt;
  }
  std::string text = all_of(file);
  if (!text.empty()) return text;
  RCLCPP_ERROR(logger, "Error: file %s is empty", path);
  return std::nullopt;
}

std::optional<std::string> Spawner::text_of_topic() {
  const auto logger = node_->get_logger();
  const char* const topic = arguments_.topic.c_str();
  RCLCPP_INFO(logger, "Loading entity published on topic %s", topic);
  std::string text;
  const auto subscription = node_->create_subscription<std_msgs::msg::String>(
      arguments_.topic, rclcpp::QoS(1).transient_local(),
      [&](const std_msgs::msg::String& message) { text = message.data; });
  bool has_waited = false;
  while (rclcpp::ok() && text.empty()) {
    RCLCPP_INFO(logger, "Waiting for entity xml on %s", topic);
    executor_.spin_once(has_waited ? std::chrono::nanoseconds(-1) : kPatience);
    if (text.empty() && rclcpp::ok() && !std::exchange(has_waited, true))
      RCLCPP_WARN(logger, "%s", ros2wasm_sim::silent_description(*node_, arguments_.topic).c_str());
  }
  return text.empty() ? std::nullopt : std::optional(text);
}

geometry_msgs::msg::Pose Spawner::pose() const {
  const double cr = std::cos(arguments_.roll / 2), sr = std::sin(arguments_.roll / 2);
  const double cp = std::cos(arguments_.pitch / 2), sp = std::sin(arguments_.pitch / 2);
  const double cy = std::cos(arguments_.yaw / 2), sy = std::sin(arguments_.yaw / 2);
  geometry_msgs::msg::Pose result;
  result.position.x = arguments_.x;
  result.position.y = arguments_.y;
  result.position.z = arguments_.z;
  result.orientation.w = cr * cp * cy + sr * sp * sy;
  result.orientation.x = sr * cp * cy - cr * sp * sy;
  result.orientation.y = cr * sp * cy + sr * cp * sy;
  result.orientation.z = cr * cp * sy - sr * sp * cy;
  return result;
}

template <typename Service>
typename Service::Response::SharedPtr Spawner::call(const std::string& name, double timeout_s,
                                                    const char* provider,
                                                    typename Service::Request::SharedPtr request) {
  const std::string whole = arguments_.gazebo_namespace + "/" + name;
  const auto client = node_->create_client<Service>(whole);
  if (!client->wait_for_service(std::chrono::duration_cast<std::chrono::nanoseconds>(
          std::chrono::duration<double>(timeout_s)))) {
    RCLCPP_ERROR(node_->get_logger(), "Service %s unavailable. Was Gazebo started with %s?",
                 whole.c_str(), provider);
    return nullptr;
  }
  RCLCPP_INFO(node_->get_logger(), "Calling service %s", whole.c_str());
  auto answer = client->async_send_request(request);
  if (executor_.spin_until_future_complete(answer) != rclcpp::FutureReturnCode::SUCCESS)
    return nullptr;
  return answer.get();
}

bool Spawner::spawn(const std::string& text) {
  const auto logger = node_->get_logger();
  double timeout_s = arguments_.timeout_s;
  if (arguments_.old_timeout_s) {
    RCLCPP_WARN(logger, "'-spawn_service_timeout' is deprecated, use '-timeout' instead");
    timeout_s = *arguments_.old_timeout_s;
  }
  if (timeout_s < 0) {
    RCLCPP_ERROR(logger, "spawn_entity timeout must be greater than zero");
    return false;
  }
  const std::string service = arguments_.gazebo_namespace + "/spawn_entity";
  RCLCPP_INFO(logger, "Waiting for service %s, timeout = %.f", service.c_str(), timeout_s);
  RCLCPP_INFO(logger, "Waiting for service %s", service.c_str());
  const auto request = std::make_shared<gazebo_msgs::srv::SpawnEntity::Request>();
  request->name = arguments_.entity;
  request->xml = text;
  request->robot_namespace = arguments_.robot_namespace;
  request->initial_pose = pose();
  request->reference_frame = arguments_.reference_frame;
  const auto answer =
      call<gazebo_msgs::srv::SpawnEntity>("spawn_entity", timeout_s, kFactory, request);
  if (!answer) return false;
  RCLCPP_INFO(logger, "Spawn status: %s", answer->status_message.c_str());
  return answer->success;
}

void Spawner::remove() {
  RCLCPP_INFO(node_->get_logger(), "Deleting entity [%s]", arguments_.entity.c_str());
  const auto request = std::make_shared<gazebo_msgs::srv::DeleteEntity::Request>();
  request->name = arguments_.entity;
  const auto answer = call<gazebo_msgs::srv::DeleteEntity>("delete_entity", arguments_.timeout_s,
                                                           kFactory, request);
  if (answer)
    RCLCPP_INFO(node_->get_logger(), "Deleting status: %s", answer->status_message.c_str());
}

void Spawner::call_empty(const std::string& name) {
  call<std_srvs::srv::Empty>(name, arguments_.timeout_s, "GazeboRosInit",
                             std::make_shared<std_srvs::srv::Empty::Request>());
}

}  // namespace gazebo_ros
