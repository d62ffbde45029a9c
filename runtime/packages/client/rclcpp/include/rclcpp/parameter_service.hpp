// The six services through which others see and set a node's parameters.
#pragma once

#include <memory>
#include <vector>

#include "rclcpp/macros.hpp"
#include "rclcpp/node_interfaces/node_base_interface.hpp"
#include "rclcpp/node_interfaces/node_parameters_interface.hpp"
#include "rclcpp/node_interfaces/node_services_interface.hpp"
#include "rclcpp/qos.hpp"
#include "rclcpp/service.hpp"

namespace rclcpp {

class ParameterService {
 public:
  RCLCPP_SMART_PTR_DEFINITIONS(ParameterService)

  ParameterService(const node_interfaces::NodeBaseInterface::SharedPtr& node_base,
                   const node_interfaces::NodeServicesInterface::SharedPtr& node_services,
                   node_interfaces::NodeParametersInterface* node_params,
                   const rclcpp::QoS& qos_profile = rclcpp::ParametersQoS());

 private:
  std::vector<rclcpp::ServiceBase::SharedPtr> services_;
};

}  // namespace rclcpp
