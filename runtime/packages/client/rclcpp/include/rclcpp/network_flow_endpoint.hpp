// An address on a network. There is none on the bus of a page; asking for one throws.
#pragma once

#include <cstdint>
#include <iosfwd>
#include <string>

namespace rclcpp {

class NetworkFlowEndpoint {
 public:
  const std::string& transport_protocol() const { return transport_protocol_; }
  const std::string& internet_protocol() const { return internet_protocol_; }
  uint16_t transport_port() const { return 0; }
  uint32_t flow_label() const { return 0; }
  uint8_t dscp() const { return 0; }
  const std::string& internet_address() const { return internet_address_; }

  friend bool operator==(const NetworkFlowEndpoint& left, const NetworkFlowEndpoint& right) {
    return left.internet_address_ == right.internet_address_;
  }
  friend bool operator!=(const NetworkFlowEndpoint& left, const NetworkFlowEndpoint& right) {
    return !(left == right);
  }
  friend std::ostream& operator<<(std::ostream& os, const NetworkFlowEndpoint&) { return os; }

 private:
  std::string transport_protocol_;
  std::string internet_protocol_;
  std::string internet_address_;
};

}  // namespace rclcpp
