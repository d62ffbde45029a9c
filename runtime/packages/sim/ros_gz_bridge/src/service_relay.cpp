// See service_relay.hpp. One row per service.
#include "service_relay.hpp"

#include <iterator>
#include <stdexcept>

#include "ros2wasm_sim/gz_names.hpp"
#include "ros_gz_interfaces/srv/control_world.hpp"
#include "ros_gz_interfaces/srv/delete_entity.hpp"
#include "ros_gz_interfaces/srv/set_entity_pose.hpp"
#include "ros_gz_interfaces/srv/spawn_entity.hpp"

namespace ros_gz_bridge {
namespace {

template <typename ServiceT>
struct ServiceRelay {
  typename rclcpp::Client<ServiceT>::SharedPtr client;
  typename rclcpp::Service<ServiceT>::SharedPtr service;
};

/// The request waits for the answer of Gazebo, without keeping the bridge.
template <typename ServiceT>
std::shared_ptr<void> relay(rclcpp::Node& node, const std::string& name) {
  const auto result = std::make_shared<ServiceRelay<ServiceT>>();
  result->client = node.create_client<ServiceT>(ros2wasm_sim::hidden_name(name));
  const auto client = result->client;
  result->service =
      node.create_service<ServiceT>(name, [client, logger = node.get_logger(), name](
                                              std::shared_ptr<rclcpp::Service<ServiceT>> service,
                                              std::shared_ptr<rmw_request_id_t> id,
                                              std::shared_ptr<typename ServiceT::Request> request) {
        if (!client->service_is_ready()) {
          RCLCPP_ERROR(logger, "Failed to create request: no service [%s] in Gazebo", name.c_str());
          typename ServiceT::Response failed;
          failed.success = false;
          service->send_response(*id, failed);
          return;
        }
        client->async_send_request(
            request, [service, id](typename rclcpp::Client<ServiceT>::SharedFuture answer) {
              service->send_response(*id, *answer.get());
            });
      });
  return result;
}

struct ServicePair {
  const char* ros_type;
  const char* gz_request;  ///< without `gz.msgs.`
  std::shared_ptr<void> (*relay)(rclcpp::Node& node, const std::string& name);
};

const ServicePair kServices[] = {
    {"ros_gz_interfaces/srv/ControlWorld", "WorldControl",
     relay<ros_gz_interfaces::srv::ControlWorld>},
    {"ros_gz_interfaces/srv/DeleteEntity", "Entity", relay<ros_gz_interfaces::srv::DeleteEntity>},
    {"ros_gz_interfaces/srv/SetEntityPose", "Pose", relay<ros_gz_interfaces::srv::SetEntityPose>},
    {"ros_gz_interfaces/srv/SpawnEntity", "EntityFactory",
     relay<ros_gz_interfaces::srv::SpawnEntity>},
};

bool fits(const std::string& given, const std::string& name) {
  return given.empty() || given == "gz.msgs." + name || given == "ignition.msgs." + name;
}

}  // namespace

std::shared_ptr<void> relay_service(rclcpp::Node& node, const ServiceEntry& entry) {
  for (const ServicePair& one : kServices) {
    if (entry.ros_type == one.ros_type && fits(entry.gz_request, one.gz_request) &&
        fits(entry.gz_answer, "Boolean"))
      return one.relay(node, entry.service);
  }
  throw std::runtime_error("No template specialization for the specified service type {" +
                           entry.ros_type + "}, gz request type {" + entry.gz_request +
                           "}, gz response type {" + entry.gz_answer + "}");
}

}  // namespace ros_gz_bridge
