// Timers of a node, for a buffer.
#include "tf2_ros/create_timer_ros.hpp"

#include <algorithm>
#include <string>

namespace tf2_ros {
namespace {

// As good as never; times further away would not fit in their type.
constexpr tf2::Duration kLongest = std::chrono::hours(24 * 3650);

}  // namespace

CreateTimerROS::CreateTimerROS(rclcpp::node_interfaces::NodeBaseInterface::SharedPtr node_base,
                               rclcpp::node_interfaces::NodeTimersInterface::SharedPtr node_timers,
                               rclcpp::CallbackGroup::SharedPtr callback_group)
    : node_base_(std::move(node_base)),
      node_timers_(std::move(node_timers)),
      callback_group_(std::move(callback_group)) {}

TimerHandle CreateTimerROS::createTimer(rclcpp::Clock::SharedPtr clock, const tf2::Duration& period,
                                        TimerCallbackType callback) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const TimerHandle handle = next_handle_++;
  timers_[handle] = rclcpp::create_timer(
      node_base_, node_timers_, clock, rclcpp::Duration(std::min(period, kLongest)),
      [this, handle, callback = std::move(callback)] {
        {
          // It rings once.
          const std::lock_guard<std::mutex> inner(mutex_);
          const auto found = timers_.find(handle);
          if (found != timers_.end()) {
            found->second->cancel();
          }
        }
        callback(handle);
      },
      callback_group_);
  return handle;
}

rclcpp::TimerBase::SharedPtr CreateTimerROS::find(const TimerHandle& timer_handle,
                                                  const char* caller) {
  const auto found = timers_.find(timer_handle);
  if (found == timers_.end()) {
    throw InvalidTimerHandleException(std::string("Invalid timer handle in ") + caller + "()");
  }
  return found->second;
}

void CreateTimerROS::cancel(const TimerHandle& timer_handle) {
  const std::lock_guard<std::mutex> lock(mutex_);
  find(timer_handle, "cancel")->cancel();
}

void CreateTimerROS::reset(const TimerHandle& timer_handle) {
  const std::lock_guard<std::mutex> lock(mutex_);
  find(timer_handle, "reset")->reset();
}

void CreateTimerROS::remove(const TimerHandle& timer_handle) {
  // Its end comes after the lock, as it may be what is running now.
  rclcpp::TimerBase::SharedPtr timer;
  const std::lock_guard<std::mutex> lock(mutex_);
  timer = find(timer_handle, "remove");
  timer->cancel();
  timers_.erase(timer_handle);
}

}  // namespace tf2_ros
