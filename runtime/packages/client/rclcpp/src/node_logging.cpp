// A node's logger and its /rosout publisher. The log handler writes to the console and, through
// the publisher of the node that the logger belongs to, to /rosout.
#include "rclcpp/node_interfaces/node_logging.hpp"

#include <cstdarg>
#include <cstdio>
#include <map>
#include <mutex>
#include <string>

#include "rcl_interfaces/msg/log.hpp"
#include "rcl_interfaces/srv/get_logger_levels.hpp"
#include "rcl_interfaces/srv/set_logger_levels.hpp"
#include "rclcpp/create_service.hpp"
#include "rclcpp/detail/background.hpp"
#include "rclcpp/publisher.hpp"
#include "rclcpp/time.hpp"
#include "rcutils/logging.h"

namespace rclcpp {
namespace {

using Log = rcl_interfaces::msg::Log;

struct Rosout {
  std::recursive_mutex mutex;
  // Name of the logger (a node's; children find it by their prefix).
  std::map<std::string, std::weak_ptr<rclcpp::Publisher<Log>>> publishers;
  bool console = true;
  bool enabled = true;
  bool publishing = false;
};

Rosout& rosout() {
  static Rosout instance;
  return instance;
}

std::shared_ptr<rclcpp::Publisher<Log>> find_publisher(std::string name) {
  while (!name.empty()) {
    const auto found = rosout().publishers.find(name);
    if (found != rosout().publishers.end()) {
      return found->second.lock();
    }
    const size_t dot = name.rfind('.');
    name = dot == std::string::npos ? std::string() : name.substr(0, dot);
  }
  return nullptr;
}

std::string format_text(const char* format, va_list* args) {
  va_list copy;
  va_copy(copy, *args);
  char small[512];
  const int length = std::vsnprintf(small, sizeof(small), format, copy);
  va_end(copy);
  if (length < static_cast<int>(sizeof(small))) {
    return length < 0 ? std::string() : std::string(small, static_cast<size_t>(length));
  }
  std::string text(static_cast<size_t>(length), '\0');
  va_copy(copy, *args);
  std::vsnprintf(text.data(), text.size() + 1, format, copy);
  va_end(copy);
  return text;
}

void publish_log(const rcutils_log_location_t* location, int severity, const char* name,
                 rcutils_time_point_value_t timestamp, const char* format, va_list* args) {
  const std::lock_guard<std::recursive_mutex> lock(rosout().mutex);
  // Messages that publishing itself logs do not go to /rosout: that would recurse without end.
  if (!rosout().enabled || rosout().publishing) {
    return;
  }
  const auto publisher = find_publisher(name);
  if (!publisher) {
    return;
  }
  Log log;
  log.stamp = Time(timestamp);
  log.level = static_cast<uint8_t>(severity);
  log.name = name;
  log.msg = format_text(format, args);
  if (location != nullptr) {
    log.file = location->file_name;
    log.function = location->function_name;
    log.line = static_cast<uint32_t>(location->line_number);
  }
  rosout().publishing = true;
  struct Done {
    ~Done() { rosout().publishing = false; }
  } done;
  publisher->publish(log);
}

void handle_log(const rcutils_log_location_t* location, int severity, const char* name,
                rcutils_time_point_value_t timestamp, const char* format, va_list* args) {
  if (rosout().console) {
    rcutils_logging_console_output_handler(location, severity, name, timestamp, format, args);
  }
  publish_log(location, severity, name, timestamp, format, args);
}

}  // namespace

void detail::install_log_handler(bool console, bool with_rosout) {
  rosout().console = console;
  rosout().enabled = with_rosout;
  rcutils_logging_set_output_handler(&handle_log);
}

namespace node_interfaces {

NodeLogging::NodeLogging(NodeBaseInterface* node_base)
    : NodeLogging(node_base, true, rclcpp::RosoutQoS()) {}

NodeLogging::NodeLogging(NodeBaseInterface* node_base, bool enable_rosout,
                         const rclcpp::QoS& rosout_qos)
    : logger_(node_base->get_logger_name()) {
  if (!enable_rosout || !rosout().enabled) {
    return;
  }
  rclcpp::PublisherOptions options;
  options.use_default_callbacks = false;
  options.use_intra_process_comm = rclcpp::IntraProcessSetting::Disable;
  auto publisher =
      std::make_shared<rclcpp::Publisher<Log>>(node_base, "/rosout", rosout_qos, options);
  rosout_ = publisher;
  const std::lock_guard<std::recursive_mutex> lock(rosout().mutex);
  auto& slot = rosout().publishers[logger_.get_name()];
  if (!slot.expired()) {
    std::fprintf(stderr,
                 "Publisher already registered for node name: '%s'. If this is due to multiple "
                 "nodes with the same name then all logs for the logger named '%s' will go out "
                 "over the existing publisher. As soon as any node with that name is destructed "
                 "it will unregister the publisher, preventing any further logs for that name "
                 "from being published on the rosout topic.\n",
                 node_base->get_name(), logger_.get_name());
    return;
  }
  slot = publisher;
}

NodeLogging::~NodeLogging() {
  const std::lock_guard<std::recursive_mutex> lock(rosout().mutex);
  rosout().publishers.erase(logger_.get_name());
}

void NodeLogging::create_logger_services(NodeBaseInterface* node_base,
                                         NodeServicesInterface* node_services) {
  using rcl_interfaces::srv::GetLoggerLevels;
  using rcl_interfaces::srv::SetLoggerLevels;
  const auto add = [&](auto service) {
    node_services->add_service(service, nullptr);
    services_.push_back(service);
  };
  AnyServiceCallback<GetLoggerLevels> get;
  get.set([](std::shared_ptr<GetLoggerLevels::Request> request,
             std::shared_ptr<GetLoggerLevels::Response> response) {
    for (const std::string& name : request->names) {
      rcl_interfaces::msg::LoggerLevel level;
      level.name = name;
      const int found = rcutils_logging_get_logger_level(name.c_str());
      level.level = static_cast<uint8_t>(found < 0 ? 0 : found);
      response->levels.push_back(level);
    }
  });
  add(std::make_shared<rclcpp::Service<GetLoggerLevels>>(node_base, "~/get_logger_levels",
                                                         std::move(get), rclcpp::ServicesQoS()));
  AnyServiceCallback<SetLoggerLevels> set;
  set.set([](std::shared_ptr<SetLoggerLevels::Request> request,
             std::shared_ptr<SetLoggerLevels::Response> response) {
    for (const auto& level : request->levels) {
      rcl_interfaces::msg::SetLoggerLevelsResult result;
      result.successful = rcutils_logging_set_logger_level(
                              level.name.c_str(), static_cast<int>(level.level)) == RCUTILS_RET_OK;
      if (!result.successful) {
        result.reason = rcutils_get_error_string().str;
        rcutils_reset_error();
      }
      response->results.push_back(result);
    }
  });
  add(std::make_shared<rclcpp::Service<SetLoggerLevels>>(node_base, "~/set_logger_levels",
                                                         std::move(set), rclcpp::ServicesQoS()));
}

}  // namespace node_interfaces
}  // namespace rclcpp
