// Loggers.
#include "rclcpp/logger.hpp"

#include <cstdlib>
#include <string>

#include "rcl/error_handling.h"
#include "rclcpp/exceptions.hpp"

namespace rclcpp {

Logger get_logger(const std::string& name) {
  return Logger(name);
}

Logger Logger::get_child(const std::string& suffix) {
  return name_ ? Logger(*name_ + RCUTILS_LOGGING_SEPARATOR_STRING + suffix) : Logger();
}

void Logger::set_level(Level level) {
  const rcutils_ret_t result =
      rcutils_logging_set_logger_level(name_ ? name_->c_str() : "", static_cast<int>(level));
  if (result != RCUTILS_RET_OK) {
    exceptions::throw_from_rcl_error(RCL_RET_INVALID_ARGUMENT, "rcutils_logging_set_logger_level");
  }
}

Logger::Level Logger::get_effective_level() const {
  return static_cast<Level>(
      rcutils_logging_get_logger_effective_level(name_ ? name_->c_str() : ""));
}

std::filesystem::path get_log_directory() {
  const auto variable = [](const char* name) {
    const char* const value = std::getenv(name);
    return std::string(value == nullptr ? "" : value);
  };
  if (const std::string folder = variable("ROS_LOG_DIR"); !folder.empty()) {
    return folder;
  }
  const std::string home = variable("ROS_HOME");
  const std::filesystem::path ros =
      home.empty() ? std::filesystem::path(variable("HOME")) / ".ros" : std::filesystem::path(home);
  return ros / "log";
}

std::filesystem::path get_logging_directory() {
  return get_log_directory();
}

}  // namespace rclcpp
