// A value of a joint or an actuator that a transmission reads and writes. It belongs to the caller.
#pragma once

#include <optional>
#include <string>

#include "hardware_interface/macros.hpp"

namespace transmission_interface {

class Handle {
 public:
  Handle(const std::string& prefix_name, const std::string& interface_name, double* value_ptr)
      : prefix_name_(prefix_name), interface_name_(interface_name), value_ptr_(value_ptr) {}
  virtual ~Handle() = default;
  Handle(const Handle&) = default;
  Handle(Handle&&) = default;
  Handle& operator=(const Handle&) = default;
  Handle& operator=(Handle&&) = default;

  inline operator bool() const { return value_ptr_ != nullptr; }
  const std::string get_name() const { return prefix_name_ + "/" + interface_name_; }
  const std::string& get_interface_name() const { return interface_name_; }
  const std::string& get_prefix_name() const { return prefix_name_; }
  /// Throw std::runtime_error without a value.
  double get_value() const {
    THROW_ON_NULLPTR(value_ptr_);
    return *value_ptr_;
  }
  bool set_value(double value) {
    THROW_ON_NULLPTR(value_ptr_);
    *value_ptr_ = value;
    return true;
  }
  [[deprecated("For Transmission Handles use get_value() instead.")]] std::optional<double>
  get_optional() const {
    return value_ptr_ == nullptr ? std::nullopt : std::optional<double>(*value_ptr_);
  }

 protected:
  std::string prefix_name_;
  std::string interface_name_;
  double* value_ptr_ = nullptr;
};

class ActuatorHandle : public Handle {
 public:
  using Handle::Handle;
};

class JointHandle : public Handle {
 public:
  using Handle::Handle;
};

}  // namespace transmission_interface
