// See map_server.hpp.
#include "nav2_map_server/map_server.hpp"

#include <functional>
#include <stdexcept>

#include "lifecycle_msgs/msg/state.hpp"
#include "nav2_map_server/map_io.hpp"
#include "rclcpp_components/register_node_macro.hpp"

namespace nav2_map_server {

using lifecycle_msgs::msg::State;
using nav2_util::CallbackReturn;
using std::placeholders::_1;
using std::placeholders::_2;
using std::placeholders::_3;

MapServer::MapServer(const rclcpp::NodeOptions& options)
    : nav2_util::LifecycleNode("map_server", "", options), map_available_(false) {
  RCLCPP_INFO(get_logger(), "Creating");
  declare_parameter("yaml_filename", rclcpp::PARAMETER_STRING);
  declare_parameter("topic_name", "map");
  declare_parameter("frame_id", "map");
}

MapServer::~MapServer() = default;

CallbackReturn MapServer::on_configure(const rclcpp_lifecycle::State&) {
  RCLCPP_INFO(get_logger(), "Configuring");
  const std::string yaml_filename = get_parameter("yaml_filename").as_string();
  const std::string topic_name = get_parameter("topic_name").as_string();
  frame_id_ = get_parameter("frame_id").as_string();
  if (yaml_filename.empty()) {
    RCLCPP_INFO(get_logger(), "yaml-filename parameter is empty, set map through '%s'-service",
                load_map_service_name_.c_str());
  } else if (!loadMapResponseFromYaml(yaml_filename,
                                      std::make_shared<nav2_msgs::srv::LoadMap::Response>())) {
    throw std::runtime_error("Failed to load map yaml file: " + yaml_filename);
  }
  const std::string prefix = std::string(get_name()) + "/";
  occ_service_ = create_service<nav_msgs::srv::GetMap>(
      prefix + service_name_, std::bind(&MapServer::getMapCallback, this, _1, _2, _3));
  occ_pub_ = create_publisher<nav_msgs::msg::OccupancyGrid>(
      topic_name, rclcpp::QoS(rclcpp::KeepLast(1)).transient_local().reliable());
  load_map_service_ = create_service<nav2_msgs::srv::LoadMap>(
      prefix + load_map_service_name_, std::bind(&MapServer::loadMapCallback, this, _1, _2, _3));
  return CallbackReturn::SUCCESS;
}

CallbackReturn MapServer::on_activate(const rclcpp_lifecycle::State&) {
  RCLCPP_INFO(get_logger(), "Activating");
  occ_pub_->on_activate();
  if (map_available_) occ_pub_->publish(msg_);
  createBond();
  return CallbackReturn::SUCCESS;
}

CallbackReturn MapServer::on_deactivate(const rclcpp_lifecycle::State&) {
  RCLCPP_INFO(get_logger(), "Deactivating");
  occ_pub_->on_deactivate();
  destroyBond();
  return CallbackReturn::SUCCESS;
}

CallbackReturn MapServer::on_cleanup(const rclcpp_lifecycle::State&) {
  RCLCPP_INFO(get_logger(), "Cleaning up");
  occ_pub_.reset();
  occ_service_.reset();
  load_map_service_.reset();
  map_available_ = false;
  msg_ = nav_msgs::msg::OccupancyGrid();
  return CallbackReturn::SUCCESS;
}

CallbackReturn MapServer::on_shutdown(const rclcpp_lifecycle::State&) {
  RCLCPP_INFO(get_logger(), "Shutting down");
  return CallbackReturn::SUCCESS;
}

void MapServer::getMapCallback(const std::shared_ptr<rmw_request_id_t>,
                               const std::shared_ptr<nav_msgs::srv::GetMap::Request>,
                               std::shared_ptr<nav_msgs::srv::GetMap::Response> response) {
  if (get_current_state().id() != State::PRIMARY_STATE_ACTIVE) {
    RCLCPP_WARN(get_logger(), "Received GetMap request but not in ACTIVE state, ignoring!");
    return;
  }
  RCLCPP_INFO(get_logger(), "Handling GetMap request");
  response->map = msg_;
}

void MapServer::loadMapCallback(const std::shared_ptr<rmw_request_id_t>,
                                const std::shared_ptr<nav2_msgs::srv::LoadMap::Request> request,
                                std::shared_ptr<nav2_msgs::srv::LoadMap::Response> response) {
  if (get_current_state().id() != State::PRIMARY_STATE_ACTIVE) {
    RCLCPP_WARN(get_logger(), "Received LoadMap request but not in ACTIVE state, ignoring!");
    response->result = response->RESULT_UNDEFINED_FAILURE;
    return;
  }
  RCLCPP_INFO(get_logger(), "Handling LoadMap request");
  if (loadMapResponseFromYaml(request->map_url, response)) occ_pub_->publish(msg_);
}

bool MapServer::loadMapResponseFromYaml(
    const std::string& yaml_file, std::shared_ptr<nav2_msgs::srv::LoadMap::Response> response) {
  using Response = nav2_msgs::srv::LoadMap::Response;
  switch (loadMapFromYaml(yaml_file, msg_)) {
    case MAP_DOES_NOT_EXIST:
      response->result = Response::RESULT_MAP_DOES_NOT_EXIST;
      return false;
    case INVALID_MAP_METADATA:
      response->result = Response::RESULT_INVALID_MAP_METADATA;
      return false;
    case INVALID_MAP_DATA:
      response->result = Response::RESULT_INVALID_MAP_DATA;
      return false;
    case LOAD_MAP_SUCCESS:
      break;
  }
  updateMsgHeader();
  map_available_ = true;
  response->map = msg_;
  response->result = Response::RESULT_SUCCESS;
  return true;
}

void MapServer::updateMsgHeader() {
  msg_.info.map_load_time = now();
  msg_.header.frame_id = frame_id_;
  msg_.header.stamp = now();
}

}  // namespace nav2_map_server

RCLCPP_COMPONENTS_REGISTER_NODE(nav2_map_server::MapServer)
