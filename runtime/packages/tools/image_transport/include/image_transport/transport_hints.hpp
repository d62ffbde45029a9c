// Which transport a subscriber wants: its node's parameter tells.
#pragma once

#include <string>

#include "rclcpp/node.hpp"

namespace image_transport {

class TransportHints {
 public:
  /// The parameter is not declared here; without one the default is taken.
  explicit TransportHints(const rclcpp::Node* node, const std::string& default_transport = "raw",
                          const std::string& parameter_name = "image_transport") {
    node->get_parameter_or<std::string>(parameter_name, transport_, default_transport);
  }

  const std::string& getTransport() const { return transport_; }

 private:
  std::string transport_;
};

}  // namespace image_transport
