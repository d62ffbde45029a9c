// The options of rclcpp::init, in addition to the arguments.
#pragma once

#include <cstddef>

#include "rcl/allocator.h"
#include "rclcpp/visibility_control.hpp"

namespace rclcpp {

class InitOptions {
 public:
  /// Whether a stop request (Ctrl-C) shuts the context down.
  bool shutdown_on_signal = true;

  explicit InitOptions(rcl_allocator_t allocator = rcl_get_default_allocator()) { (void)allocator; }
  virtual ~InitOptions() = default;
  InitOptions(const InitOptions&) = default;
  InitOptions& operator=(const InitOptions&) = default;

  bool auto_initialize_logging() const { return initialize_logging_; }
  InitOptions& auto_initialize_logging(bool initialize_logging) {
    initialize_logging_ = initialize_logging;
    return *this;
  }
  void use_default_domain_id() { domain_id_ = 0; }
  void set_domain_id(size_t domain_id) { domain_id_ = domain_id; }
  size_t get_domain_id() const { return domain_id_; }

 private:
  bool initialize_logging_ = true;
  size_t domain_id_ = 0;
};

}  // namespace rclcpp
