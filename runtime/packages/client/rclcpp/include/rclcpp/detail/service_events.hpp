// Tells those who watch a service what happens on one side of it: `<service>/_service_event`.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "rcl/service_introspection.h"
#include "rclcpp/clock.hpp"
#include "rclcpp/detail/message_type.hpp"
#include "rclcpp/qos.hpp"

namespace rclcpp {
namespace detail {

/// As service_msgs/msg/ServiceEventInfo numbers them.
enum class ServiceEventKind : uint8_t {
  request_sent = 0,
  request_received = 1,
  response_sent = 2,
  response_received = 3
};

class ServiceEvents {
 public:
  virtual ~ServiceEvents() = default;
  virtual void set_state(rcl_service_introspection_state_t state) = 0;
  /// `message` is the request or the response. After shutdown nothing happens.
  virtual void tell(ServiceEventKind kind, const uint8_t* client_gid, int64_t sequence_number,
                    const void* message) = 0;
};

/// Makes, changes or ends (OFF) the events of a service. A publisher that there is keeps its clock
/// and QoS. Programs that never call this carry no code for it.
void configure_service_events(std::shared_ptr<ServiceEvents>& events, int32_t node_id,
                              const std::string& service_name, const ServiceCallbacks& type,
                              Clock::SharedPtr clock, const rclcpp::QoS& qos,
                              rcl_service_introspection_state_t state);

}  // namespace detail
}  // namespace rclcpp
