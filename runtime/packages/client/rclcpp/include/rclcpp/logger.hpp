// A name to log under.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <utility>

#include "rclcpp/detail/string_format.hpp"
#include "rclcpp/visibility_control.hpp"
#include "rcutils/logging.h"

namespace rclcpp {

namespace node_interfaces {
class NodeLogging;
}

class Logger;

Logger get_logger(const std::string& name);
/// Where log files would be: ROS_LOG_DIR, else `log` in ROS_HOME, else ~/.ros/log. None are written
/// in a site.
std::filesystem::path get_log_directory();
/// Its older name.
std::filesystem::path get_logging_directory();

class Logger {
 public:
  enum class Level {
    Unset = RCUTILS_LOG_SEVERITY_UNSET,
    Debug = RCUTILS_LOG_SEVERITY_DEBUG,
    Info = RCUTILS_LOG_SEVERITY_INFO,
    Warn = RCUTILS_LOG_SEVERITY_WARN,
    Error = RCUTILS_LOG_SEVERITY_ERROR,
    Fatal = RCUTILS_LOG_SEVERITY_FATAL,
  };

  Logger(const Logger&) = default;
  Logger& operator=(const Logger&) = default;

  const char* get_name() const { return name_ ? name_->c_str() : nullptr; }
  Logger get_child(const std::string& suffix);
  void set_level(Level level);
  Level get_effective_level() const;

 private:
  friend Logger rclcpp::get_logger(const std::string& name);
  friend ::rclcpp::node_interfaces::NodeLogging;
  Logger() = default;
  explicit Logger(const std::string& name) : name_(std::make_shared<const std::string>(name)) {}

  std::shared_ptr<const std::string> name_;
};

}  // namespace rclcpp
