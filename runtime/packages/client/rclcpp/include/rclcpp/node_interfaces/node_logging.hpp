// A node's logger, and the publisher of its lines on /rosout.
#pragma once

#include <memory>
#include <vector>

#include "rclcpp/node_interfaces/node_base_interface.hpp"
#include "rclcpp/node_interfaces/node_logging_interface.hpp"
#include "rclcpp/publisher_base.hpp"
#include "rclcpp/service.hpp"

namespace rclcpp {
namespace node_interfaces {

class NodeLogging : public NodeLoggingInterface {
 public:
  RCLCPP_SMART_PTR_ALIASES_ONLY(NodeLogging)
  explicit NodeLogging(NodeBaseInterface* node_base);
  NodeLogging(NodeBaseInterface* node_base, bool enable_rosout, const rclcpp::QoS& rosout_qos);
  ~NodeLogging() override;

  rclcpp::Logger get_logger() const override { return logger_; }
  const char* get_logger_name() const override { return logger_.get_name(); }
  void create_logger_services(NodeBaseInterface* node_base,
                              NodeServicesInterface* node_services) override;

 private:
  RCLCPP_DISABLE_COPY(NodeLogging)
  rclcpp::Logger logger_;
  rclcpp::PublisherBase::SharedPtr rosout_;
  std::vector<rclcpp::ServiceBase::SharedPtr> services_;
};

}  // namespace node_interfaces
}  // namespace rclcpp
