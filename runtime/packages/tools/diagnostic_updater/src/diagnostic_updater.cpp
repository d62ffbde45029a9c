// See diagnostic_updater.hpp and diagnostic_status_wrapper.hpp.
#include "diagnostic_updater/diagnostic_updater.hpp"

#include <algorithm>
#include <cstdarg>
#include <cstdio>

namespace diagnostic_updater {
namespace {

std::string printed(const char* format, va_list arguments) {
  va_list again;
  va_copy(again, arguments);
  const int length = std::vsnprintf(nullptr, 0, format, arguments);
  std::string text(length > 0 ? static_cast<size_t>(length) : 0, '\0');
  std::vsnprintf(text.data(), text.size() + 1, format, again);
  va_end(again);
  return text;
}

template <typename T>
T parameter(rclcpp::node_interfaces::NodeParametersInterface& parameters, const std::string& name,
            const T& value) {
  if (!parameters.has_parameter(name)) {
    parameters.declare_parameter(name, rclcpp::ParameterValue(value));
  }
  return parameters.get_parameter(name).get_value<T>();
}

}  // namespace

void DiagnosticStatusWrapper::summaryf(unsigned char lvl, const char* format, ...) {
  va_list arguments;
  va_start(arguments, format);
  summary(lvl, printed(format, arguments));
  va_end(arguments);
}

void DiagnosticStatusWrapper::mergeSummary(unsigned char lvl, const std::string s) {
  if ((lvl > OK) == (level > OK)) {
    message += (message.empty() ? "" : "; ") + s;
  } else if (lvl > level) {
    message = s;
  }
  level = std::max(level, lvl);
}

void DiagnosticStatusWrapper::mergeSummaryf(unsigned char lvl, const char* format, ...) {
  va_list arguments;
  va_start(arguments, format);
  mergeSummary(lvl, printed(format, arguments));
  va_end(arguments);
}

void DiagnosticStatusWrapper::add(const std::string& key, const std::string& val) {
  diagnostic_msgs::msg::KeyValue value;
  value.key = key;
  value.value = val;
  values.push_back(std::move(value));
}

void DiagnosticStatusWrapper::addf(const std::string& key, const char* format, ...) {
  va_list arguments;
  va_start(arguments, format);
  add(key, printed(format, arguments));
  va_end(arguments);
}

void CompositeDiagnosticTask::run(DiagnosticStatusWrapper& stat) {
  DiagnosticStatusWrapper merged;
  const DiagnosticStatusWrapper original = stat;
  for (DiagnosticTask* const task : tasks_) {
    stat.summary(original);
    task->run(stat);
    merged.mergeSummary(stat);
  }
  stat.summary(merged);
}

void DiagnosticTaskVector::add(const std::string& name, TaskFunction f) {
  const std::lock_guard<std::mutex> lock(lock_);
  tasks_.emplace_back(name, std::move(f));
  addedTaskCallback(tasks_.back());
}

void DiagnosticTaskVector::add(DiagnosticTask& task) {
  add(task.getName(), [&task](DiagnosticStatusWrapper& stat) { task.run(stat); });
}

bool DiagnosticTaskVector::removeByName(const std::string name) {
  const std::lock_guard<std::mutex> lock(lock_);
  const auto found =
      std::find_if(tasks_.begin(), tasks_.end(),
                   [&name](const DiagnosticTaskInternal& task) { return task.getName() == name; });
  if (found == tasks_.end()) {
    return false;
  }
  tasks_.erase(found);
  return true;
}

Updater::Updater(
    std::shared_ptr<rclcpp::node_interfaces::NodeBaseInterface> base_interface,
    std::shared_ptr<rclcpp::node_interfaces::NodeClockInterface> clock_interface,
    std::shared_ptr<rclcpp::node_interfaces::NodeLoggingInterface> logging_interface,
    std::shared_ptr<rclcpp::node_interfaces::NodeParametersInterface> parameters_interface,
    std::shared_ptr<rclcpp::node_interfaces::NodeTimersInterface> timers_interface,
    std::shared_ptr<rclcpp::node_interfaces::NodeTopicsInterface> topics_interface, double period)
    : base_interface_(std::move(base_interface)),
      timers_interface_(std::move(timers_interface)),
      clock_(clock_interface->get_clock()),
      period_(rclcpp::Duration::from_seconds(
          parameter(*parameters_interface, "diagnostic_updater.period", period))),
      logger_(logging_interface->get_logger()),
      publisher_(rclcpp::create_publisher<diagnostic_msgs::msg::DiagnosticArray>(
          topics_interface, "/diagnostics", 1)) {
  const bool full = parameter(*parameters_interface, "diagnostic_updater.use_fqn", false);
  node_name_ = full ? base_interface_->get_fully_qualified_name() : base_interface_->get_name();
  reset_timer();
}

void Updater::setPeriod(rclcpp::Duration period) {
  period_ = period;
  reset_timer();
}

void Updater::reset_timer() {
  update_timer_ = rclcpp::create_timer(base_interface_, timers_interface_, clock_, period_,
                                       [this] { update(); });
}

void Updater::update() {
  if (!rclcpp::ok()) {
    return;
  }
  bool warn_nohwid = hwid_.empty();
  std::vector<diagnostic_msgs::msg::DiagnosticStatus> all;
  {
    const std::lock_guard<std::mutex> lock(lock_);
    for (const DiagnosticTaskInternal& task : getTasks()) {
      DiagnosticStatusWrapper status;
      status.level = DiagnosticStatusWrapper::ERROR;
      status.message = "No message was set";
      status.hardware_id = hwid_;
      task.run(status);
      if (status.level != DiagnosticStatusWrapper::OK) {
        warn_nohwid = false;
      }
      if (verbose_ && status.level != DiagnosticStatusWrapper::OK) {
        RCLCPP_WARN(logger_, "Non-zero diagnostic status. Name: '%s', status %i: '%s'",
                    status.name.c_str(), status.level, status.message.c_str());
      }
      all.push_back(status);
    }
  }
  if (warn_nohwid && !warn_nohwid_done_) {
    RCLCPP_WARN(logger_,
                "diagnostic_updater: No HW_ID was set. This is probably a bug. Please report it. "
                "For devices that do not have a HW_ID, set this value to 'none'. This warning "
                "only occurs once all diagnostics are OK. It is okay to wait until the device is "
                "open before calling setHardwareID.");
    warn_nohwid_done_ = true;
  }
  publish(all);
}

void Updater::broadcast(unsigned char lvl, const std::string msg) {
  std::vector<diagnostic_msgs::msg::DiagnosticStatus> all;
  {
    const std::lock_guard<std::mutex> lock(lock_);
    for (const DiagnosticTaskInternal& task : getTasks()) {
      DiagnosticStatusWrapper status;
      status.name = task.getName();
      status.summary(lvl, msg);
      all.push_back(status);
    }
  }
  publish(all);
}

void Updater::setHardwareIDf(const char* format, ...) {
  va_list arguments;
  va_start(arguments, format);
  hwid_ = printed(format, arguments);
  va_end(arguments);
}

void Updater::publish(diagnostic_msgs::msg::DiagnosticStatus& stat) {
  std::vector<diagnostic_msgs::msg::DiagnosticStatus> all = {stat};
  publish(all);
}

void Updater::publish(std::vector<diagnostic_msgs::msg::DiagnosticStatus>& status_vec) {
  for (auto& status : status_vec) {
    status.name.insert(0, node_name_ + ": ");
  }
  diagnostic_msgs::msg::DiagnosticArray message;
  message.status = status_vec;
  message.header.stamp = clock_->now();
  publisher_->publish(message);
}

/// Publishes a first status, so that viewers of diagnostics show a task before it has run.
void Updater::addedTaskCallback(DiagnosticTaskInternal& task) {
  DiagnosticStatusWrapper status;
  status.name = task.getName();
  status.summary(DiagnosticStatusWrapper::OK, "Node starting up");
  publish(status);
}

}  // namespace diagnostic_updater
