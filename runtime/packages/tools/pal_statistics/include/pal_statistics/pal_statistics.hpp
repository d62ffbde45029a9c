// A registry of variables, which publishes their values.
#pragma once

#include <condition_variable>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <thread>

#include "pal_statistics/pal_statistics_utils.hpp"
#include "rclcpp_lifecycle/lifecycle_node.hpp"

namespace pal_statistics {

/// Publishes on TOPIC/full, and on TOPIC/names (for late subscribers too) with TOPIC/values. Before
/// it has a node (attach()), it takes registrations and publishes nothing.
class StatisticsRegistry : public std::enable_shared_from_this<StatisticsRegistry> {
 public:
  StatisticsRegistry() = default;
  template <typename NodeT>
  StatisticsRegistry(const std::shared_ptr<NodeT>& node, const std::string& topic) {
    attach(node, topic);
  }
  StatisticsRegistry(
      const rclcpp::node_interfaces::NodeParametersInterface::SharedPtr& parameters_interface,
      const rclcpp::node_interfaces::NodeTopicsInterface::SharedPtr& topics_interface,
      const rclcpp::node_interfaces::NodeLoggingInterface::SharedPtr& logging_interface,
      const rclcpp::node_interfaces::NodeClockInterface::SharedPtr& clock_interface,
      const std::string& topic);
  virtual ~StatisticsRegistry();

  template <typename NodeT>
  void attach(const std::shared_ptr<NodeT>& node, const std::string& topic) {
    attach(node->get_node_parameters_interface(), node->get_node_topics_interface(),
           node->get_node_clock_interface(), topic);
  }
  void attach(const rclcpp::node_interfaces::NodeParametersInterface::SharedPtr& parameters,
              const rclcpp::node_interfaces::NodeTopicsInterface::SharedPtr& topics,
              const rclcpp::node_interfaces::NodeClockInterface::SharedPtr& clock,
              const std::string& topic);

  /// The variable must outlive its registration.
  IdType registerVariable(const std::string& name, const double* variable,
                          RegistrationsRAII* bookkeeping = nullptr, bool enabled = true);
  IdType registerFunction(const std::string& name, const std::function<double()>& funct,
                          RegistrationsRAII* bookkeeping = nullptr, bool enabled = true);
  void unregisterVariable(const std::string& name, RegistrationsRAII* bookkeeping = nullptr);
  void unregisterVariable(IdType id, RegistrationsRAII* bookkeeping = nullptr);
  bool enable(const IdType& id) { return set_enabled(id, true); }
  bool disable(const IdType& id) { return set_enabled(id, false); }

  void publish();
  /// Reads the values now; the thread of startPublishThread() publishes them. False while the
  /// registry is in use.
  bool publishAsync();
  void startPublishThread();
  pal_statistics_msgs::msg::Statistics createMsg();

  template <typename T>
  void publishCustomStatistic(const std::string& name, T value) {
    pal_statistics_msgs::msg::Statistics message;
    message.statistics.resize(1);
    message.statistics[0].name = name;
    message.statistics[0].value = static_cast<double>(value);
    {
      const std::lock_guard lock(mutex_);
      message = stamped(std::move(message));
    }
    publishCustomStatistics(message);
  }
  void publishCustomStatistics(const pal_statistics_msgs::msg::Statistics& message);

 private:
  struct Variable {
    std::string name;
    std::function<double()> read;
    bool is_enabled;
  };

  bool set_enabled(IdType id, bool is_enabled);
  pal_statistics_msgs::msg::Statistics stamped(pal_statistics_msgs::msg::Statistics message) const;
  pal_statistics_msgs::msg::Statistics values() const;
  void send(const pal_statistics_msgs::msg::Statistics& message);
  void run();

  std::mutex mutex_;                      ///< of the variables, the clock and of what waits
  std::map<IdType, Variable> variables_;  ///< in the order in which they were registered
  IdType next_id_ = 0;
  bool has_waiting_ = false;
  bool ends_ = false;
  pal_statistics_msgs::msg::Statistics waiting_;
  rclcpp::Clock::SharedPtr clock_;
  std::condition_variable wakes_;
  std::thread thread_;

  std::mutex publish_mutex_;  ///< of what follows
  rclcpp::Publisher<pal_statistics_msgs::msg::Statistics>::SharedPtr full_;
  rclcpp::Publisher<pal_statistics_msgs::msg::StatisticsNames>::SharedPtr names_;
  rclcpp::Publisher<pal_statistics_msgs::msg::StatisticsValues>::SharedPtr values_;
  pal_statistics_msgs::msg::StatisticsNames last_names_;
};

}  // namespace pal_statistics
