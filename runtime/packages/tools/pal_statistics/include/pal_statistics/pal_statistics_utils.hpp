// Registrations of variables, which end with their owner.
#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "pal_statistics_msgs/msg/statistics.hpp"
#include "pal_statistics_msgs/msg/statistics_names.hpp"
#include "pal_statistics_msgs/msg/statistics_values.hpp"
#include "rclcpp/rclcpp.hpp"

namespace pal_statistics {

using IdType = unsigned int;

class StatisticsRegistry;

/// Unregisters its variable when it ends.
class Registration {
 public:
  Registration(std::string name, IdType id, std::weak_ptr<StatisticsRegistry> registry)
      : name_(std::move(name)), id_(id), obj_(std::move(registry)) {}
  Registration(Registration&&) = default;
  Registration& operator=(Registration&&) = default;
  ~Registration();

  std::string name_;
  IdType id_;
  std::weak_ptr<StatisticsRegistry> obj_;
};

/// The registrations of an object, for its member that ends with it.
class RegistrationsRAII {
 public:
  RegistrationsRAII() = default;
  RegistrationsRAII(const RegistrationsRAII&) = delete;
  RegistrationsRAII& operator=(const RegistrationsRAII&) = delete;

  void add(Registration&& registration);
  /// False when there is none such, here and below.
  bool remove(const std::string& name);
  bool remove(IdType id);
  void removeAll();

  bool enable(const std::string& name) { return set_enabled(name, true); }
  bool enable(IdType id) { return set_enabled(id, true); }
  bool enableAll() { return set_all_enabled(true); }
  bool disable(const std::string& name) { return set_enabled(name, false); }
  bool disable(IdType id) { return set_enabled(id, false); }
  bool disableAll() { return set_all_enabled(false); }

 private:
  bool set_enabled(const std::string& name, bool is_enabled);
  bool set_enabled(IdType id, bool is_enabled);
  bool set_all_enabled(bool is_enabled);

  std::mutex mutex_;
  std::vector<Registration> registrations_;
};

}  // namespace pal_statistics
