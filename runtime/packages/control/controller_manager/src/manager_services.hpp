// The services and topics by which others see and steer the manager.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "controller_manager_msgs/msg/controller_manager_activity.hpp"
#include "controller_manager_msgs/srv/list_controllers.hpp"
#include "controller_manager_msgs/srv/list_hardware_components.hpp"
#include "controller_manager_msgs/srv/list_hardware_interfaces.hpp"
#include "controller_manager_msgs/srv/set_hardware_component_state.hpp"
#include "rclcpp/callback_group.hpp"
#include "rclcpp/publisher.hpp"
#include "rclcpp/service.hpp"

namespace controller_manager {

class ControllerManager;

class ManagerServices {
 public:
  explicit ManagerServices(ControllerManager& manager);

  /// Makes the services: not before the hardware is there.
  void start();
  void publish_activity();

 private:
  template <typename ServiceT, typename CallbackT>
  void add(const char* name, CallbackT callback);
  void add_steering();
  void add_listing();

  void list_controllers(controller_manager_msgs::srv::ListControllers::Response& response);
  void list_types(std::vector<std::string>& types, std::vector<std::string>& bases);
  void list_components(controller_manager_msgs::srv::ListHardwareComponents::Response& response);
  void list_interfaces(controller_manager_msgs::srv::ListHardwareInterfaces::Response& response);
  void set_component_state(
      const controller_manager_msgs::srv::SetHardwareComponentState::Request& request,
      controller_manager_msgs::srv::SetHardwareComponentState::Response& response);

  ControllerManager& manager_;
  rclcpp::CallbackGroup::SharedPtr group_;
  std::vector<rclcpp::ServiceBase::SharedPtr> services_;
  rclcpp::Publisher<controller_manager_msgs::msg::ControllerManagerActivity>::SharedPtr activity_;
};

}  // namespace controller_manager
