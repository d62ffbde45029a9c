// The data that arrives with a message: times, sequence numbers and the publisher's id.
#pragma once

#include "rclcpp/visibility_control.hpp"
#include "rmw/types.h"

namespace rclcpp {

class MessageInfo {
 public:
  MessageInfo() = default;
  MessageInfo(const rmw_message_info_t& rmw_message_info)  // NOLINT: conversion wanted
      : rmw_message_info_(rmw_message_info) {}
  virtual ~MessageInfo() = default;

  const rmw_message_info_t& get_rmw_message_info() const { return rmw_message_info_; }
  rmw_message_info_t& get_rmw_message_info() { return rmw_message_info_; }

 private:
  rmw_message_info_t rmw_message_info_{};
};

}  // namespace rclcpp
