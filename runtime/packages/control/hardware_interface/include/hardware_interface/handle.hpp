// Named values that components and controllers share. A handle has its own value, or refers to a
// double of the component (the older form). Reads and writes try the lock and give up, so that a
// control loop never waits; see `wait_for_lock`. This file needs no ROS.
#pragma once

#include <functional>
#include <limits>
#include <memory>
#include <mutex>
#include <optional>
#include <shared_mutex>
#include <string>
#include <type_traits>
#include <utility>

#include "hardware_interface/hardware_info.hpp"
#include "hardware_interface/introspection.hpp"
#include "hardware_interface/lexical_casts.hpp"
#include "hardware_interface/macros.hpp"

namespace hardware_interface {

class Handle {
 public:
  [[deprecated("Use InterfaceDescription for initializing the Interface")]] Handle(
      const std::string& prefix_name, const std::string& interface_name, double* value_ptr)
      : prefix_name_(prefix_name),
        interface_name_(interface_name),
        handle_name_(prefix_name + "/" + interface_name),
        value_ptr_(value_ptr) {}
  /// Throws std::invalid_argument or std::out_of_range for an initial value of another type,
  /// std::runtime_error for an unknown type. Without an initial value a number is NaN or the
  /// largest of its type, and a bool false.
  explicit Handle(const std::string& prefix_name, const std::string& interface_name,
                  const std::string& data_type = "double", const std::string& initial_value = "");
  explicit Handle(const InterfaceDescription& interface_description)
      : Handle(interface_description.get_prefix_name(), interface_description.get_interface_name(),
               interface_description.get_data_type_string(),
               interface_description.interface_info.initial_value) {}
  [[deprecated("Use InterfaceDescription for initializing the Interface")]] explicit Handle(
      const std::string& interface_name)
      : interface_name_(interface_name), handle_name_("/" + interface_name_) {}
  [[deprecated("Use InterfaceDescription for initializing the Interface")]] explicit Handle(
      const char* interface_name)
      : interface_name_(interface_name), handle_name_("/" + interface_name_) {}

  Handle(const Handle& other) noexcept;
  Handle& operator=(const Handle& other);
  Handle(Handle&& other) noexcept;
  Handle& operator=(Handle&& other);
  virtual ~Handle() = default;

  inline operator bool() const { return value_ptr_ != nullptr; }

  /// prefix/interface
  const std::string& get_name() const { return handle_name_; }
  const std::string& get_interface_name() const { return interface_name_; }
  [[deprecated(
      "Replaced by get_name method, which is semantically more correct")]] const std::string&
  get_full_name() const {
    return get_name();
  }
  const std::string& get_prefix_name() const { return prefix_name_; }

  /// NaN while another thread writes.
  [[deprecated("Use std::optional<T> get_optional() instead to retrieve the value.")]] double
  get_value() const;

  /// Nothing while another thread writes. Throws std::runtime_error for another type.
  template <typename T = double>
  [[nodiscard]] std::optional<T> get_optional() const {
    std::shared_lock<std::shared_mutex> lock(handle_mutex_, std::try_to_lock);
    return get_optional<T>(lock);
  }
  template <typename T = double>
  [[nodiscard]] std::optional<T> get_optional(std::shared_lock<std::shared_mutex>& lock) const {
    std::optional<T> result;
    if (lock.owns_lock()) {
      result = value_as<T>();
    }
    return result;
  }

  template <typename T>
  [[deprecated(
      "Use std::optional<T> get_optional() instead to retrieve the value.")]] [[nodiscard]] bool
  get_value(T& value) const {
    return get_value(value, false);
  }
  template <typename T, typename = std::enable_if_t<
                            !std::is_same_v<std::decay_t<T>, std::shared_lock<std::shared_mutex>>>>
  [[nodiscard]] bool get_value(T& value, bool wait_for_lock) const {
    auto lock = wait_for_lock
                    ? std::shared_lock<std::shared_mutex>(handle_mutex_)
                    : std::shared_lock<std::shared_mutex>(handle_mutex_, std::try_to_lock);
    return get_value(lock, value);
  }

  template <typename T>
  [[nodiscard]] bool set_value(const T& value, bool wait_for_lock) {
    auto lock = wait_for_lock
                    ? std::unique_lock<std::shared_mutex>(handle_mutex_)
                    : std::unique_lock<std::shared_mutex>(handle_mutex_, std::try_to_lock);
    return set_value(lock, value);
  }
  template <typename T>
  [[nodiscard]] bool set_value(const T& value) {
    return set_value(value, false);
  }
  template <typename T>
  [[nodiscard]] bool set_value(std::unique_lock<std::shared_mutex>& lock, const T& value) {
    if (!lock.owns_lock()) {
      return false;
    }
    if constexpr (std::is_same_v<T, double>) {
      THROW_ON_NULLPTR(value_ptr_);
      *value_ptr_ = value;
    } else {
      if (!std::holds_alternative<T>(value_)) {
        refuse_access();
      }
      value_ = value;
    }
    return true;
  }

  std::shared_mutex& get_mutex() const { return handle_mutex_; }
  HandleDataType get_data_type() const { return data_type_; }
  bool is_castable_to_double() const { return data_type_.is_castable_to_double(); }
  bool is_valid() const {
    return value_ptr_ != nullptr || !std::holds_alternative<std::monostate>(value_);
  }

 protected:
  template <typename T>
  [[nodiscard]] bool get_value(std::shared_lock<std::shared_mutex>& lock, T& value) const {
    if (!lock.owns_lock()) {
      return false;
    }
    value = value_as<T>();
    return true;
  }

  std::string prefix_name_;
  std::string interface_name_;
  std::string handle_name_;
  HANDLE_DATATYPE value_ = std::monostate{};
  HandleDataType data_type_ = HandleDataType::DOUBLE;
  double* value_ptr_ = nullptr;  ///< into value_, or to a double of the component
  mutable std::shared_mutex handle_mutex_;

 private:
  template <typename T>
  T value_as() const {
    if constexpr (std::is_same_v<T, double>) {
      if (data_type_ != HandleDataType::DOUBLE) {
        refuse_double();
      }
      THROW_ON_NULLPTR(value_ptr_);
      return *value_ptr_;
    } else {
      const T* const found = std::get_if<T>(&value_);
      if (found == nullptr) {
        refuse_access();
      }
      return *found;
    }
  }
  [[noreturn]] void refuse_double() const;
  [[noreturn]] void refuse_access() const;
  void copy(const Handle& other) noexcept;
  void swap(Handle& other) noexcept;
};

class StateInterface : public Handle {
 public:
  explicit StateInterface(const InterfaceDescription& interface_description)
      : Handle(interface_description) {}
  StateInterface(const StateInterface& other) = default;
  StateInterface(StateInterface&& other) = default;

  void registerIntrospection() const {}
  void unregisterIntrospection() const {}

  using Handle::Handle;

  using SharedPtr = std::shared_ptr<StateInterface>;
  using ConstSharedPtr = std::shared_ptr<const StateInterface>;
};

class CommandInterface : public Handle {
 public:
  explicit CommandInterface(const InterfaceDescription& interface_description)
      : Handle(interface_description) {}
  /// One owner at a time: a copy would be a second one.
  CommandInterface(const CommandInterface& other) = delete;
  CommandInterface(CommandInterface&& other) = default;

  /// The limiter gets a command, and returns what may be done of it and whether that differs.
  void set_on_set_command_limiter(std::function<double(double, bool&)> on_set_command_limiter) {
    on_set_command_limiter_ = std::move(on_set_command_limiter);
  }
  template <typename T>
  [[nodiscard]] bool set_limited_value(const T& value) {
    if constexpr (std::is_same_v<T, double>) {
      return set_value(on_set_command_limiter_ ? on_set_command_limiter_(value, is_command_limited_)
                                               : value);
    } else {
      return set_value(value);
    }
  }
  const bool& is_limited() const { return is_command_limited_; }

  void registerIntrospection() const {}
  void unregisterIntrospection() const {}

  using Handle::Handle;

  using SharedPtr = std::shared_ptr<CommandInterface>;

 private:
  bool is_command_limited_ = false;
  std::function<double(double, bool&)> on_set_command_limiter_;
};

}  // namespace hardware_interface
