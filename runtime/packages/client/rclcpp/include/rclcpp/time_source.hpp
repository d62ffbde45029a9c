// Feeds clocks from /clock when the parameter use_sim_time is true.
#pragma once

#include <memory>

#include "rclcpp/clock.hpp"
#include "rclcpp/macros.hpp"
#include "rclcpp/qos.hpp"

namespace rclcpp {

class Node;

namespace node_interfaces {
class NodeBaseInterface;
class NodeTopicsInterface;
class NodeGraphInterface;
class NodeServicesInterface;
class NodeLoggingInterface;
class NodeClockInterface;
class NodeParametersInterface;
}  // namespace node_interfaces

class TimeSource {
 public:
  RCLCPP_SMART_PTR_DEFINITIONS(TimeSource)

  explicit TimeSource(std::shared_ptr<rclcpp::Node> node,
                      const rclcpp::QoS& qos = rclcpp::ClockQoS(), bool use_clock_thread = true);
  explicit TimeSource(const rclcpp::QoS& qos = rclcpp::ClockQoS(), bool use_clock_thread = true);
  TimeSource(TimeSource&&) = delete;
  ~TimeSource();

  void attachNode(std::shared_ptr<rclcpp::Node> node);
  void attachNode(std::shared_ptr<node_interfaces::NodeBaseInterface> node_base,
                  std::shared_ptr<node_interfaces::NodeTopicsInterface> node_topics,
                  std::shared_ptr<node_interfaces::NodeGraphInterface> node_graph,
                  std::shared_ptr<node_interfaces::NodeServicesInterface> node_services,
                  std::shared_ptr<node_interfaces::NodeLoggingInterface> node_logging,
                  std::shared_ptr<node_interfaces::NodeClockInterface> node_clock,
                  std::shared_ptr<node_interfaces::NodeParametersInterface> node_parameters);
  void detachNode();
  /// Throws std::invalid_argument unless it is a ROS clock.
  void attachClock(rclcpp::Clock::SharedPtr clock);
  void detachClock(rclcpp::Clock::SharedPtr clock);
  bool get_use_clock_thread();
  void set_use_clock_thread(bool use_clock_thread);
  bool clock_thread_is_joinable();

 private:
  class State;
  std::shared_ptr<State> state_;
};

}  // namespace rclcpp
