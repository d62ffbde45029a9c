// One cycle of the loop: read, update, write.
#include <algorithm>
#include <cmath>
#include <typeinfo>

#include "controller_manager/controller_manager.hpp"
#include "hardware_interface/helpers.hpp"
#include "switch_plan.hpp"

namespace controller_manager {

using lifecycle_msgs::msg::State;
using Switch = controller_manager_msgs::srv::SwitchController::Request;
using Lock = std::lock_guard<std::recursive_mutex>;

namespace {

/// Holds while the list of controllers is walked through, also when one of them throws.
class Updating {
 public:
  explicit Updating(bool& flag) : flag_(flag) { flag_ = true; }
  ~Updating() { flag_ = false; }
  Updating(const Updating&) = delete;
  Updating& operator=(const Updating&) = delete;

 private:
  bool& flag_;
};

std::string joined(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) {
    text += name + " ";
  }
  return text;
}

}  // namespace

void ControllerManager::read(const rclcpp::Time& time, const rclcpp::Duration& period) {
  const auto status = resource_manager_->read(time, period);
  if (status.result != hardware_interface::return_type::OK) {
    stop_users_of(status.failed_hardware_names, "read", true);
  }
}

void ControllerManager::write(const rclcpp::Time& time, const rclcpp::Duration& period) {
  const auto status = resource_manager_->write(time, period);
  if (status.result != hardware_interface::return_type::OK) {
    stop_users_of(status.failed_hardware_names, "write",
                  status.result == hardware_interface::return_type::ERROR);
  }
}

void ControllerManager::stop_users_of(const std::vector<std::string>& hardware, const char* cycle,
                                      bool is_error) {
  const Lock lock(controllers_lock_);
  std::vector<std::string> users;
  for (const std::string& name : hardware) {
    for (const std::string& user : resource_manager_->get_cached_controllers_to_hardware(name)) {
      const ControllerSpec* const spec = find_controller(user);
      if (spec != nullptr && spec->c->get_lifecycle_id() == State::PRIMARY_STATE_ACTIVE) {
        ros2_control::add_item(users, user);
      }
    }
  }
  if (is_error) {
    RCLCPP_ERROR(get_logger(),
                 "Deactivating following hardware components as their %s cycle resulted in an "
                 "error: [ %s]",
                 cycle, joined(hardware).c_str());
    if (!users.empty()) {
      RCLCPP_ERROR(get_logger(),
                   "Deactivating following controllers as their hardware components %s cycle "
                   "resulted in an error: [ %s]",
                   cycle, joined(users).c_str());
    }
  } else if (!users.empty()) {
    RCLCPP_ERROR(get_logger(),
                 "Deactivating controllers [%s] as their command interfaces are tied to "
                 "DEACTIVATEing hardware components",
                 joined(users).c_str());
  }
  deactivate_controllers(users);
  publish_activity();
}

bool ControllerManager::is_its_turn(const ControllerSpec& spec, const rclcpp::Time& time,
                                    rclcpp::Duration& period) const {
  const unsigned int rate = spec.c->get_update_rate();
  // After simulated time was set back, an update counts as the first: the way back does not count.
  const bool is_first = spec.last_update_cycle_time->get_clock_type() == RCL_CLOCK_UNINITIALIZED ||
                        time < *spec.last_update_cycle_time;
  if (rate == 0 || rate >= update_rate_) {
    period = is_first ? period : time - *spec.last_update_cycle_time;
    return true;
  }
  period =
      is_first ? rclcpp::Duration::from_seconds(1.0 / rate) : time - *spec.last_update_cycle_time;
  const double error_now = std::abs(period.seconds() * rate - 1.0);
  const double error_if_skipped = std::abs((period.seconds() + 1.0 / update_rate_) * rate - 1.0);
  return is_first || error_now <= error_if_skipped;
}

ControllerManager::ReturnType ControllerManager::update_one(ControllerSpec& spec,
                                                            const rclcpp::Time& time,
                                                            const rclcpp::Duration& period) {
  // Simulated time may move on while this program does not look at /clock: a simulator makes many
  // steps in a row, and each has its own time.
  const rclcpp::Time stamp = use_sim_time_ && time.get_clock_type() == RCL_ROS_TIME ? time : now();
  try {
    return spec.c->trigger_update(stamp, period).result;
  } catch (const std::exception& error) {
    RCLCPP_ERROR(get_logger(), "Caught exception of type : %s while updating controller '%s': %s",
                 typeid(error).name(), spec.info.name.c_str(), error.what());
    if (!handle_exceptions_) {
      throw;
    }
  } catch (...) {
    RCLCPP_ERROR(get_logger(), "Caught unknown exception while updating controller '%s'",
                 spec.info.name.c_str());
    if (!handle_exceptions_) {
      throw;
    }
  }
  return ReturnType::ERROR;
}

ControllerManager::ReturnType ControllerManager::update(const rclcpp::Time& time,
                                                        const rclcpp::Duration& period) {
  const Lock lock(controllers_lock_);
  loop_thread_ = std::this_thread::get_id();
  ReturnType result = ReturnType::OK;
  std::vector<std::string> failed;
  {
    const Updating updating(updates_);
    result = update_all(time, period, failed);
  }
  if (shutdown_is_due_) {
    shutdown_is_due_ = false;
    shutdown_controllers();
    return result;
  }
  if (!failed.empty()) {
    fall_back(failed);
  }
  if (enforce_command_limits_) {
    resource_manager_->enforce_command_limits(period);
  }
  manage_switch();
  return result;
}

ControllerManager::ReturnType ControllerManager::update_all(const rclcpp::Time& time,
                                                            const rclcpp::Duration& period,
                                                            std::vector<std::string>& failed) {
  ReturnType result = ReturnType::OK;
  for (ControllerSpec& spec : controllers_) {
    rclcpp::Duration since = period;
    if (spec.c->get_lifecycle_id() != State::PRIMARY_STATE_ACTIVE ||
        !is_its_turn(spec, time, since)) {
      continue;
    }
    const ReturnType one = update_one(spec, time, since);
    *spec.last_update_cycle_time = time;
    if (one != ReturnType::OK) {
      if (spec.controllers_chain_group.size() > 1) {
        RCLCPP_INFO(get_logger(),
                    "Controller '%s' is part of a chain of %zu controllers that will be "
                    "deactivated.",
                    spec.info.name.c_str(), spec.controllers_chain_group.size());
      }
      ros2_control::add_items(failed, spec.controllers_chain_group);
      ros2_control::add_item(failed, spec.info.name);
      result = one;
    }
  }
  return result;
}

void ControllerManager::fall_back(const std::vector<std::string>& failed) {
  std::vector<std::string> fallbacks;
  for (const std::string& name : failed) {
    const ControllerSpec* const spec = find_controller(name);
    if (spec != nullptr) {
      ros2_control::add_items(fallbacks, spec->info.fallback_controllers_names);
    }
  }
  const std::vector<std::string> needed = commands_of(fallbacks);
  std::vector<std::string> in_the_way;
  for (const ControllerSpec& spec : controllers_) {
    if (ros2_control::has_any_item(spec.info.claimed_interfaces, needed) &&
        !ros2_control::has_item(failed, spec.info.name)) {
      in_the_way.push_back(spec.info.name);
    }
  }
  RCLCPP_ERROR(get_logger(),
               "Deactivating controllers : [ %s] as their update resulted in an error!",
               joined(failed).c_str());
  if (!in_the_way.empty()) {
    RCLCPP_ERROR(get_logger(),
                 "Deactivating controllers : [ %s] using the command interfaces needed for the "
                 "fallback controllers to activate.",
                 joined(in_the_way).c_str());
  }
  if (!fallbacks.empty()) {
    RCLCPP_ERROR(get_logger(), "Activating fallback controllers : [ %s]",
                 joined(fallbacks).c_str());
  }
  std::vector<std::string> to_stop = failed;
  ros2_control::add_items(to_stop, in_the_way);
  std::vector<std::string> stopped;
  for (const std::string& name : to_stop) {
    if (const ControllerSpec* const spec = find_controller(name)) {
      ros2_control::add_items(stopped, spec->info.claimed_interfaces);
    }
  }
  if (!resource_manager_->prepare_command_mode_switch(needed, stopped) ||
      !resource_manager_->perform_command_mode_switch(needed, stopped)) {
    RCLCPP_ERROR(get_logger(),
                 "Error while attempting mode switch when deactivating controllers in "
                 "update cycle!");
  }
  deactivate_controllers(to_stop);
  activate_controllers(fallbacks, Switch::STRICT);
  publish_activity();
}

}  // namespace controller_manager
