// The service ~/get_type_description.
#pragma once

#include <memory>

#include "rclcpp/macros.hpp"
#include "rclcpp/node_interfaces/node_base_interface.hpp"
#include "rclcpp/node_interfaces/node_logging_interface.hpp"
#include "rclcpp/node_interfaces/node_parameters_interface.hpp"
#include "rclcpp/node_interfaces/node_services_interface.hpp"
#include "rclcpp/node_interfaces/node_type_descriptions_interface.hpp"

namespace rclcpp {

class ServiceBase;

namespace node_interfaces {

class NodeTypeDescriptions : public NodeTypeDescriptionsInterface {
 public:
  RCLCPP_SMART_PTR_ALIASES_ONLY(NodeTypeDescriptions)

  /// Declares the parameter `start_type_description_service`; while it is true, as it is when not
  /// said otherwise, there is the service. Throws InvalidParameterTypeException.
  NodeTypeDescriptions(NodeBaseInterface::SharedPtr node_base,
                       NodeLoggingInterface::SharedPtr node_logging,
                       NodeParametersInterface::SharedPtr node_parameters,
                       NodeServicesInterface::SharedPtr node_services);
  ~NodeTypeDescriptions() override;

 private:
  RCLCPP_DISABLE_COPY(NodeTypeDescriptions)
  std::shared_ptr<ServiceBase> service_;
};

}  // namespace node_interfaces
}  // namespace rclcpp
