// A node's time source, for real.
#pragma once

#include "rclcpp/node_interfaces/node_time_source_interface.hpp"
#include "rclcpp/time_source.hpp"

namespace rclcpp {
namespace node_interfaces {

class NodeTimeSource : public NodeTimeSourceInterface {
 public:
  RCLCPP_SMART_PTR_ALIASES_ONLY(NodeTimeSource)
  NodeTimeSource(std::shared_ptr<NodeBaseInterface> node_base,
                 std::shared_ptr<NodeTopicsInterface> node_topics,
                 std::shared_ptr<NodeGraphInterface> node_graph,
                 std::shared_ptr<NodeServicesInterface> node_services,
                 std::shared_ptr<NodeLoggingInterface> node_logging,
                 std::shared_ptr<NodeClockInterface> node_clock,
                 std::shared_ptr<NodeParametersInterface> node_parameters,
                 const rclcpp::QoS& qos = rclcpp::ClockQoS(), bool use_clock_thread = true);

 private:
  RCLCPP_DISABLE_COPY(NodeTimeSource)
  TimeSource time_source_;
};

}  // namespace node_interfaces
}  // namespace rclcpp
