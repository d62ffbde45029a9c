// See pal_statistics.hpp and pal_statistics_macros.hpp.
#include <algorithm>
#include <utility>

#include "pal_statistics/pal_statistics_macros.hpp"

namespace pal_statistics {
namespace {

using pal_statistics_msgs::msg::Statistic;
using pal_statistics_msgs::msg::Statistics;

struct Registries {
  std::mutex mutex;
  std::map<std::string, std::shared_ptr<StatisticsRegistry>> by_key;
};

Registries& registries() {
  static Registries all;
  return all;
}

}  // namespace

Registration::~Registration() {
  if (const auto registry = obj_.lock()) registry->unregisterVariable(id_);
}

void RegistrationsRAII::add(Registration&& registration) {
  const std::lock_guard lock(mutex_);
  registrations_.push_back(std::move(registration));
}

bool RegistrationsRAII::remove(const std::string& name) {
  const std::lock_guard lock(mutex_);
  const auto found = std::find_if(registrations_.begin(), registrations_.end(),
                                  [&](const Registration& one) { return one.name_ == name; });
  if (found == registrations_.end()) return false;
  registrations_.erase(found);
  return true;
}

bool RegistrationsRAII::remove(IdType id) {
  const std::lock_guard lock(mutex_);
  const auto found = std::find_if(registrations_.begin(), registrations_.end(),
                                  [&](const Registration& one) { return one.id_ == id; });
  if (found == registrations_.end()) return false;
  registrations_.erase(found);
  return true;
}

void RegistrationsRAII::removeAll() {
  const std::lock_guard lock(mutex_);
  registrations_.clear();
}

bool RegistrationsRAII::set_enabled(const std::string& name, bool is_enabled) {
  const std::lock_guard lock(mutex_);
  bool is_there = false;
  for (const Registration& one : registrations_) {
    const auto registry = one.name_ == name ? one.obj_.lock() : nullptr;
    if (registry == nullptr) continue;
    is_there = is_enabled ? registry->enable(one.id_) : registry->disable(one.id_);
  }
  return is_there;
}

bool RegistrationsRAII::set_enabled(IdType id, bool is_enabled) {
  const std::lock_guard lock(mutex_);
  for (const Registration& one : registrations_) {
    const auto registry = one.id_ == id ? one.obj_.lock() : nullptr;
    if (registry != nullptr) return is_enabled ? registry->enable(id) : registry->disable(id);
  }
  return false;
}

bool RegistrationsRAII::set_all_enabled(bool is_enabled) {
  const std::lock_guard lock(mutex_);
  bool all = true;
  for (const Registration& one : registrations_) {
    const auto registry = one.obj_.lock();
    all = registry != nullptr &&
          (is_enabled ? registry->enable(one.id_) : registry->disable(one.id_)) && all;
  }
  return all;
}

StatisticsRegistry::StatisticsRegistry(
    const rclcpp::node_interfaces::NodeParametersInterface::SharedPtr& parameters_interface,
    const rclcpp::node_interfaces::NodeTopicsInterface::SharedPtr& topics_interface,
    const rclcpp::node_interfaces::NodeLoggingInterface::SharedPtr& /*logging_interface*/,
    const rclcpp::node_interfaces::NodeClockInterface::SharedPtr& clock_interface,
    const std::string& topic) {
  attach(parameters_interface, topics_interface, clock_interface, topic);
}

StatisticsRegistry::~StatisticsRegistry() {
  {
    const std::lock_guard lock(mutex_);
    ends_ = true;
  }
  wakes_.notify_all();
  if (thread_.joinable()) thread_.join();
}

void StatisticsRegistry::attach(
    const rclcpp::node_interfaces::NodeParametersInterface::SharedPtr& parameters,
    const rclcpp::node_interfaces::NodeTopicsInterface::SharedPtr& topics,
    const rclcpp::node_interfaces::NodeClockInterface::SharedPtr& clock, const std::string& topic) {
  {
    const std::lock_guard lock(mutex_);
    clock_ = clock->get_clock();
  }
  const std::lock_guard lock(publish_mutex_);
  full_ = rclcpp::create_publisher<Statistics>(parameters, topics, topic + "/full", rclcpp::QoS(1));
  names_ = rclcpp::create_publisher<pal_statistics_msgs::msg::StatisticsNames>(
      parameters, topics, topic + "/names", rclcpp::QoS(1).transient_local());
  values_ = rclcpp::create_publisher<pal_statistics_msgs::msg::StatisticsValues>(
      parameters, topics, topic + "/values", rclcpp::QoS(1));
  last_names_ = pal_statistics_msgs::msg::StatisticsNames();
}

IdType StatisticsRegistry::registerVariable(const std::string& name, const double* variable,
                                            RegistrationsRAII* bookkeeping, bool enabled) {
  return registerFunction(
      name, [variable] { return *variable; }, bookkeeping, enabled);
}

IdType StatisticsRegistry::registerFunction(const std::string& name,
                                            const std::function<double()>& funct,
                                            RegistrationsRAII* bookkeeping, bool enabled) {
  IdType id = 0;
  {
    const std::lock_guard lock(mutex_);
    id = next_id_++;
    variables_.emplace(id, Variable{name, funct, enabled});
  }
  if (bookkeeping != nullptr) bookkeeping->add(Registration(name, id, weak_from_this()));
  return id;
}

void StatisticsRegistry::unregisterVariable(const std::string& name,
                                            RegistrationsRAII* bookkeeping) {
  if (bookkeeping != nullptr && bookkeeping->remove(name)) return;
  const std::lock_guard lock(mutex_);
  const auto found = std::find_if(variables_.begin(), variables_.end(),
                                  [&](const auto& one) { return one.second.name == name; });
  if (found != variables_.end()) variables_.erase(found);
}

void StatisticsRegistry::unregisterVariable(IdType id, RegistrationsRAII* bookkeeping) {
  if (bookkeeping != nullptr && bookkeeping->remove(id)) return;
  const std::lock_guard lock(mutex_);
  variables_.erase(id);
}

bool StatisticsRegistry::set_enabled(IdType id, bool is_enabled) {
  const std::lock_guard lock(mutex_);
  const auto found = variables_.find(id);
  if (found == variables_.end()) return false;
  found->second.is_enabled = is_enabled;
  return true;
}

Statistics StatisticsRegistry::values() const {
  Statistics message;
  for (const auto& [id, variable] : variables_) {
    if (!variable.is_enabled) continue;
    Statistic one;
    one.name = variable.name;
    one.value = variable.read();
    message.statistics.push_back(std::move(one));
  }
  return stamped(std::move(message));
}

Statistics StatisticsRegistry::stamped(Statistics message) const {
  if (clock_ != nullptr) message.header.stamp = clock_->now();
  return message;
}

Statistics StatisticsRegistry::createMsg() {
  const std::lock_guard lock(mutex_);
  return values();
}

void StatisticsRegistry::publish() {
  send(createMsg());
}

bool StatisticsRegistry::publishAsync() {
  {
    const std::unique_lock lock(mutex_, std::try_to_lock);
    if (!lock.owns_lock()) return false;
    waiting_ = values();
    has_waiting_ = true;
  }
  wakes_.notify_one();
  return true;
}

void StatisticsRegistry::startPublishThread() {
  const std::lock_guard lock(publish_mutex_);
  if (!thread_.joinable()) thread_ = std::thread([this] { run(); });
}

void StatisticsRegistry::run() {
  while (true) {
    Statistics message;
    {
      std::unique_lock lock(mutex_);
      wakes_.wait(lock, [this] { return has_waiting_ || ends_; });
      if (ends_) return;
      has_waiting_ = false;
      message = std::move(waiting_);
    }
    send(message);
  }
}

void StatisticsRegistry::publishCustomStatistics(const Statistics& message) {
  const std::lock_guard lock(publish_mutex_);
  if (full_ != nullptr) full_->publish(message);
}

void StatisticsRegistry::send(const Statistics& message) {
  const std::lock_guard lock(publish_mutex_);
  if (full_ == nullptr) return;
  full_->publish(message);
  pal_statistics_msgs::msg::StatisticsNames names;
  pal_statistics_msgs::msg::StatisticsValues values;
  for (const Statistic& one : message.statistics) {
    names.names.push_back(one.name);
    values.values.push_back(one.value);
  }
  names.header = values.header = message.header;
  if (names.names != last_names_.names || last_names_.names_version == 0) {
    names.names_version = last_names_.names_version + 1;
    last_names_ = names;
    names_->publish(names);
  }
  values.names_version = last_names_.names_version;
  values_->publish(values);
}

std::shared_ptr<StatisticsRegistry> detail::registry_of(const std::string& key, bool& is_new) {
  Registries& all = registries();
  const std::lock_guard lock(all.mutex);
  auto& registry = all.by_key[key];
  is_new = registry == nullptr;
  if (is_new) registry = std::make_shared<StatisticsRegistry>();
  return registry;
}

std::shared_ptr<StatisticsRegistry> getRegistry(const std::string& key) {
  bool is_new = false;
  return detail::registry_of(key, is_new);
}

void clearAllRegistries() {
  std::map<std::string, std::shared_ptr<StatisticsRegistry>> ended;
  Registries& all = registries();
  const std::lock_guard lock(all.mutex);
  ended.swap(all.by_key);
}

}  // namespace pal_statistics
