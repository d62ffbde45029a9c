// init, ok, shutdown, and the command line.
#pragma once

#include <chrono>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "rclcpp/context.hpp"
#include "rclcpp/contexts/default_context.hpp"
#include "rclcpp/init_options.hpp"
#include "rclcpp/visibility_control.hpp"

namespace rclcpp {

enum class SignalHandlerOptions {
  All,
  SigInt,
  SigTerm,
  None,
};

void init(int argc, char const* const* argv, const InitOptions& init_options = InitOptions(),
          SignalHandlerOptions signal_handler_options = SignalHandlerOptions::All);
bool install_signal_handlers(
    SignalHandlerOptions signal_handler_options = SignalHandlerOptions::All);
bool signal_handlers_installed();
SignalHandlerOptions get_current_signal_handler_options();
bool uninstall_signal_handlers();
/// Initialises the default context and returns the arguments that are not ROS'.
std::vector<std::string> init_and_remove_ros_arguments(
    int argc, char const* const* argv, const InitOptions& init_options = InitOptions());
std::vector<std::string> remove_ros_arguments(int argc, char const* const* argv);
bool ok(rclcpp::Context::SharedPtr context = nullptr);
bool shutdown(rclcpp::Context::SharedPtr context = nullptr,
              const std::string& reason = "user called rclcpp::shutdown()");
void on_shutdown(std::function<void()> callback, rclcpp::Context::SharedPtr context = nullptr);
/// False when the sleep was cut short.
bool sleep_for(const std::chrono::nanoseconds& nanoseconds,
               rclcpp::Context::SharedPtr context = nullptr);

template <typename T>
bool add_will_overflow(const T x, const T y) {
  return y > 0 && x > std::numeric_limits<T>::max() - y;
}
template <typename T>
bool add_will_underflow(const T x, const T y) {
  return y < 0 && x < std::numeric_limits<T>::min() - y;
}
template <typename T>
bool sub_will_overflow(const T x, const T y) {
  return y < 0 && x > std::numeric_limits<T>::max() + y;
}
template <typename T>
bool sub_will_underflow(const T x, const T y) {
  return y > 0 && x < std::numeric_limits<T>::min() + y;
}

/// The text itself: lets macros take a char array or a std::string.
const char* get_c_string(const char* string_in);
const char* get_c_string(const std::string& string_in);
std::vector<const char*> get_c_vector_string(const std::vector<std::string>& strings_in);

}  // namespace rclcpp
