// An Updater runs its tasks at a period and publishes what they report on /diagnostics.
#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "diagnostic_msgs/msg/diagnostic_array.hpp"
#include "diagnostic_updater/diagnostic_status_wrapper.hpp"
#include "rclcpp/rclcpp.hpp"

namespace diagnostic_updater {

using TaskFunction = std::function<void(DiagnosticStatusWrapper&)>;
using UnwrappedTaskFunction = std::function<void(diagnostic_msgs::msg::DiagnosticStatus&)>;

class DiagnosticTask {
 public:
  explicit DiagnosticTask(const std::string name) : name_(name) {}
  virtual ~DiagnosticTask() = default;
  const std::string& getName() const { return name_; }
  virtual void run(DiagnosticStatusWrapper& stat) = 0;

 private:
  const std::string name_;
};

template <class T>
class GenericFunctionDiagnosticTask : public DiagnosticTask {
 public:
  GenericFunctionDiagnosticTask(const std::string& name, std::function<void(T&)> fn)
      : DiagnosticTask(name), function_(std::move(fn)) {}
  void run(DiagnosticStatusWrapper& stat) override { function_(stat); }

 private:
  const std::function<void(T&)> function_;
};
using FunctionDiagnosticTask = GenericFunctionDiagnosticTask<DiagnosticStatusWrapper>;
using UnwrappedFunctionDiagnosticTask =
    GenericFunctionDiagnosticTask<diagnostic_msgs::msg::DiagnosticStatus>;

/// Several tasks as one: values of all, and their summaries merged. The tasks belong to the caller.
class CompositeDiagnosticTask : public DiagnosticTask {
 public:
  explicit CompositeDiagnosticTask(const std::string name) : DiagnosticTask(name) {}
  void run(DiagnosticStatusWrapper& stat) override;
  void addTask(DiagnosticTask* task) { tasks_.push_back(task); }

 private:
  std::vector<DiagnosticTask*> tasks_;
};

class DiagnosticTaskVector {
 public:
  virtual ~DiagnosticTaskVector() = default;

  void add(const std::string& name, TaskFunction f);
  /// The task belongs to the caller.
  void add(DiagnosticTask& task);
  template <class T>
  void add(const std::string name, T* c, void (T::*f)(DiagnosticStatusWrapper&)) {
    add(name, [c, f](DiagnosticStatusWrapper& stat) { (c->*f)(stat); });
  }
  /// Was there one?
  bool removeByName(const std::string name);

 protected:
  class DiagnosticTaskInternal {
   public:
    DiagnosticTaskInternal(std::string name, TaskFunction f)
        : name_(std::move(name)), fn_(std::move(f)) {}
    void run(DiagnosticStatusWrapper& stat) const {
      stat.name = name_;
      fn_(stat);
    }
    const std::string& getName() const { return name_; }

   private:
    std::string name_;
    TaskFunction fn_;
  };

  const std::vector<DiagnosticTaskInternal>& getTasks() { return tasks_; }

  std::mutex lock_;

 private:
  virtual void addedTaskCallback(DiagnosticTaskInternal&) {}

  std::vector<DiagnosticTaskInternal> tasks_;
};

class Updater : public DiagnosticTaskVector {
 public:
  bool verbose_ = false;

  template <class NodeT>
  explicit Updater(NodeT node, double period = 1.0)
      : Updater(node->get_node_base_interface(), node->get_node_clock_interface(),
                node->get_node_logging_interface(), node->get_node_parameters_interface(),
                node->get_node_timers_interface(), node->get_node_topics_interface(), period) {}
  Updater(std::shared_ptr<rclcpp::node_interfaces::NodeBaseInterface> base_interface,
          std::shared_ptr<rclcpp::node_interfaces::NodeClockInterface> clock_interface,
          std::shared_ptr<rclcpp::node_interfaces::NodeLoggingInterface> logging_interface,
          std::shared_ptr<rclcpp::node_interfaces::NodeParametersInterface> parameters_interface,
          std::shared_ptr<rclcpp::node_interfaces::NodeTimersInterface> timers_interface,
          std::shared_ptr<rclcpp::node_interfaces::NodeTopicsInterface> topics_interface,
          double period = 1.0);

  rclcpp::Duration getPeriod() const { return period_; }
  void setPeriod(rclcpp::Duration period);
  void setPeriod(double period) { setPeriod(rclcpp::Duration::from_seconds(period)); }
  /// Runs the tasks now.
  void force_update() { update(); }
  /// The same for all tasks.
  void broadcast(unsigned char lvl, const std::string msg);
  void setHardwareIDf(const char* format, ...) __attribute__((format(printf, 2, 3)));
  void setHardwareID(const std::string& hwid) { hwid_ = hwid; }

 private:
  void reset_timer();
  void update();
  void publish(diagnostic_msgs::msg::DiagnosticStatus& stat);
  void publish(std::vector<diagnostic_msgs::msg::DiagnosticStatus>& status_vec);
  void addedTaskCallback(DiagnosticTaskInternal& task) override;

  std::shared_ptr<rclcpp::node_interfaces::NodeBaseInterface> base_interface_;
  std::shared_ptr<rclcpp::node_interfaces::NodeTimersInterface> timers_interface_;
  rclcpp::Clock::SharedPtr clock_;
  rclcpp::Duration period_;
  rclcpp::TimerBase::SharedPtr update_timer_;
  rclcpp::Logger logger_;
  rclcpp::Publisher<diagnostic_msgs::msg::DiagnosticArray>::SharedPtr publisher_;
  std::string hwid_;
  std::string node_name_;
  bool warn_nohwid_done_ = false;
};

}  // namespace diagnostic_updater
