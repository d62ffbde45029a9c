// The options of a node.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "rcl/allocator.h"
#include "rcl/time.h"
#include "rclcpp/context.hpp"
#include "rclcpp/contexts/default_context.hpp"
#include "rclcpp/parameter.hpp"
#include "rclcpp/publisher_options.hpp"
#include "rclcpp/qos.hpp"

namespace rclcpp {

class NodeOptions {
 public:
  explicit NodeOptions(rcl_allocator_t allocator = rcl_get_default_allocator())
      : allocator_(allocator) {}
  virtual ~NodeOptions() = default;
  NodeOptions(const NodeOptions& other) = default;
  NodeOptions& operator=(const NodeOptions& other) = default;

#define RCLCPP_NODE_OPTION_(TYPE, NAME)  \
  const TYPE& NAME() const {             \
    return NAME##_;                      \
  }                                      \
  NodeOptions& NAME(const TYPE& value) { \
    NAME##_ = value;                     \
    return *this;                        \
  }
#define RCLCPP_NODE_FLAG_(NAME)   \
  bool NAME() const {             \
    return NAME##_;               \
  }                               \
  NodeOptions& NAME(bool value) { \
    NAME##_ = value;              \
    return *this;                 \
  }

  rclcpp::Context::SharedPtr context() const {
    return context_;
  }
  NodeOptions& context(rclcpp::Context::SharedPtr context) {
    context_ = std::move(context);
    return *this;
  }
  RCLCPP_NODE_OPTION_(std::vector<std::string>, arguments)
  std::vector<rclcpp::Parameter>& parameter_overrides() {
    return parameter_overrides_;
  }
  RCLCPP_NODE_OPTION_(std::vector<rclcpp::Parameter>, parameter_overrides)
  template <typename ParameterT>
  NodeOptions& append_parameter_override(const std::string& name, const ParameterT& value) {
    parameter_overrides_.emplace_back(name, rclcpp::ParameterValue(value));
    return *this;
  }
  RCLCPP_NODE_FLAG_(use_global_arguments)
  RCLCPP_NODE_FLAG_(enable_rosout)
  RCLCPP_NODE_FLAG_(use_intra_process_comms)
  RCLCPP_NODE_FLAG_(enable_topic_statistics)
  RCLCPP_NODE_FLAG_(start_parameter_services)
  RCLCPP_NODE_FLAG_(enable_logger_service)
  RCLCPP_NODE_FLAG_(start_parameter_event_publisher)
  RCLCPP_NODE_OPTION_(rcl_clock_type_t, clock_type)
  RCLCPP_NODE_OPTION_(rclcpp::QoS, clock_qos)
  /// Kept for code that sets it: /clock is read whenever the program waits, without a thread.
  RCLCPP_NODE_FLAG_(use_clock_thread)
  RCLCPP_NODE_OPTION_(rclcpp::QoS, parameter_event_qos)
  RCLCPP_NODE_OPTION_(rclcpp::QoS, rosout_qos)
  RCLCPP_NODE_OPTION_(rclcpp::PublisherOptionsBase, parameter_event_publisher_options)
  RCLCPP_NODE_FLAG_(allow_undeclared_parameters)
  RCLCPP_NODE_FLAG_(automatically_declare_parameters_from_overrides)
  RCLCPP_NODE_OPTION_(rcl_allocator_t, allocator)

#undef RCLCPP_NODE_OPTION_
#undef RCLCPP_NODE_FLAG_

 private:
  rclcpp::Context::SharedPtr context_{rclcpp::contexts::get_global_default_context()};
  std::vector<std::string> arguments_;
  std::vector<rclcpp::Parameter> parameter_overrides_;
  bool use_global_arguments_ = true;
  bool enable_rosout_ = true;
  bool use_intra_process_comms_ = false;
  bool enable_topic_statistics_ = false;
  bool start_parameter_services_ = true;
  bool enable_logger_service_ = false;
  bool start_parameter_event_publisher_ = true;
  rcl_clock_type_t clock_type_ = RCL_ROS_TIME;
  rclcpp::QoS clock_qos_ = rclcpp::ClockQoS();
  bool use_clock_thread_ = true;
  rclcpp::QoS parameter_event_qos_ = rclcpp::ParameterEventsQoS();
  rclcpp::QoS rosout_qos_ = rclcpp::RosoutQoS();
  rclcpp::PublisherOptionsBase parameter_event_publisher_options_;
  bool allow_undeclared_parameters_ = false;
  bool automatically_declare_parameters_from_overrides_ = false;
  rcl_allocator_t allocator_;
};

}  // namespace rclcpp
