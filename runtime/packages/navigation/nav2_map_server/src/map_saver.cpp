// See map_saver.hpp.
#include "nav2_map_server/map_saver.hpp"

#include <future>
#include <stdexcept>

#include "rclcpp_components/register_node_macro.hpp"

namespace nav2_map_server {

using nav2_util::CallbackReturn;
using nav_msgs::msg::OccupancyGrid;

MapSaver::MapSaver(const rclcpp::NodeOptions& options)
    : nav2_util::LifecycleNode("map_saver", "", options) {
  RCLCPP_INFO(get_logger(), "Creating");
  declare_parameter("save_map_timeout", 2.0);
  declare_parameter("free_thresh_default", 0.25);
  declare_parameter("occupied_thresh_default", 0.65);
  declare_parameter("map_subscribe_transient_local", true);
}

MapSaver::~MapSaver() = default;

CallbackReturn MapSaver::on_configure(const rclcpp_lifecycle::State&) {
  RCLCPP_INFO(get_logger(), "Configuring");
  save_map_timeout_ = std::make_shared<rclcpp::Duration>(
      rclcpp::Duration::from_seconds(get_parameter("save_map_timeout").as_double()));
  free_thresh_default_ = get_parameter("free_thresh_default").as_double();
  occupied_thresh_default_ = get_parameter("occupied_thresh_default").as_double();
  map_subscribe_transient_local_ = get_parameter("map_subscribe_transient_local").as_bool();
  save_map_service_ = create_service<nav2_msgs::srv::SaveMap>(
      std::string(get_name()) + "/" + save_map_service_name_,
      [this](const std::shared_ptr<rmw_request_id_t> header,
             const std::shared_ptr<nav2_msgs::srv::SaveMap::Request> request,
             std::shared_ptr<nav2_msgs::srv::SaveMap::Response> response) {
        saveMapCallback(header, request, response);
      });
  return CallbackReturn::SUCCESS;
}

CallbackReturn MapSaver::on_activate(const rclcpp_lifecycle::State&) {
  RCLCPP_INFO(get_logger(), "Activating");
  createBond();
  return CallbackReturn::SUCCESS;
}

CallbackReturn MapSaver::on_deactivate(const rclcpp_lifecycle::State&) {
  RCLCPP_INFO(get_logger(), "Deactivating");
  destroyBond();
  return CallbackReturn::SUCCESS;
}

CallbackReturn MapSaver::on_cleanup(const rclcpp_lifecycle::State&) {
  RCLCPP_INFO(get_logger(), "Cleaning up");
  save_map_service_.reset();
  return CallbackReturn::SUCCESS;
}

CallbackReturn MapSaver::on_shutdown(const rclcpp_lifecycle::State&) {
  RCLCPP_INFO(get_logger(), "Shutting down");
  return CallbackReturn::SUCCESS;
}

void MapSaver::saveMapCallback(const std::shared_ptr<rmw_request_id_t>,
                               const std::shared_ptr<nav2_msgs::srv::SaveMap::Request> request,
                               std::shared_ptr<nav2_msgs::srv::SaveMap::Response> response) {
  SaveParameters parameters;
  parameters.map_file_name = request->map_url;
  parameters.image_format = request->image_format;
  parameters.free_thresh = request->free_thresh;
  parameters.occupied_thresh = request->occupied_thresh;
  try {
    parameters.mode = map_mode_from_string(request->map_mode);
  } catch (const std::invalid_argument&) {
    parameters.mode = MapMode::Trinary;
    RCLCPP_WARN(get_logger(),
                "Map mode parameter not recognized: '%s', using default value (trinary)",
                request->map_mode.c_str());
  }
  response->result = saveMapTopicToFile(request->map_topic, parameters);
}

bool MapSaver::saveMapTopicToFile(const std::string& map_topic,
                                  const SaveParameters& save_parameters) {
  std::string topic = map_topic;
  SaveParameters parameters = save_parameters;
  RCLCPP_INFO(get_logger(), "Saving map from '%s' topic to '%s' file", topic.c_str(),
              parameters.map_file_name.c_str());
  try {
    if (topic.empty()) {
      topic = "map";
      RCLCPP_WARN(get_logger(), "Map topic unspecified. Map messages will be read from '%s' topic",
                  topic.c_str());
    }
    if (parameters.free_thresh == 0.0) {
      RCLCPP_WARN(get_logger(), "Free threshold unspecified. Setting it to default value: %f",
                  free_thresh_default_);
      parameters.free_thresh = free_thresh_default_;
    }
    if (parameters.occupied_thresh == 0.0) {
      RCLCPP_WARN(get_logger(), "Occupied threshold unspecified. Setting it to default value: %f",
                  occupied_thresh_default_);
      parameters.occupied_thresh = occupied_thresh_default_;
    }
    rclcpp::QoS qos(10);
    if (map_subscribe_transient_local_) {
      qos = rclcpp::QoS(rclcpp::KeepLast(1)).transient_local().reliable();
    }
    // The node may be in a callback: only the subscription is spun.
    const auto group = create_callback_group(rclcpp::CallbackGroupType::MutuallyExclusive, false);
    rclcpp::SubscriptionOptions options;
    options.callback_group = group;
    std::promise<OccupancyGrid::SharedPtr> promise;
    std::future<OccupancyGrid::SharedPtr> future = promise.get_future();
    bool is_received = false;
    auto subscription = create_subscription<OccupancyGrid>(
        topic, qos,
        [&promise, &is_received](const OccupancyGrid::SharedPtr map) {
          if (!is_received) promise.set_value(map);
          is_received = true;
        },
        options);
    rclcpp::executors::SingleThreadedExecutor executor;
    executor.add_callback_group(group, get_node_base_interface());
    if (executor.spin_until_future_complete(
            future, save_map_timeout_->to_chrono<std::chrono::nanoseconds>()) !=
        rclcpp::FutureReturnCode::SUCCESS) {
      RCLCPP_ERROR(get_logger(), "Failed to spin map subscription");
      return false;
    }
    subscription.reset();
    if (saveMapToFile(*future.get(), parameters)) {
      RCLCPP_INFO(get_logger(), "Map saved successfully");
      return true;
    }
    RCLCPP_ERROR(get_logger(), "Failed to save the map");
  } catch (const std::exception& error) {
    RCLCPP_ERROR(get_logger(), "Failed to save the map: %s", error.what());
  }
  return false;
}

}  // namespace nav2_map_server

RCLCPP_COMPONENTS_REGISTER_NODE(nav2_map_server::MapSaver)
