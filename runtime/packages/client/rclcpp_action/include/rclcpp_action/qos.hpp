// The QoS of a server's status topic.
#pragma once

#include "rclcpp/qos.hpp"
#include "rclcpp_action/visibility_control.hpp"

namespace rclcpp_action {

/// The last status only, for those who come late too.
class DefaultActionStatusQoS : public rclcpp::QoS {
 public:
  DefaultActionStatusQoS() : rclcpp::QoS(1) { this->reliable().transient_local(); }
};

}  // namespace rclcpp_action
