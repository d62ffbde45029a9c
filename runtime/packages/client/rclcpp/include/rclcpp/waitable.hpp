// Something of the user's own that an executor waits for and runs.
#pragma once

#include <atomic>
#include <cstddef>
#include <functional>
#include <memory>

#include "rcl/wait.h"
#include "rclcpp/detail/executable.hpp"
#include "rclcpp/macros.hpp"
#include "rclcpp/visibility_control.hpp"

namespace rclcpp {

/// Differs from rclcpp on a robot: only the guard conditions that a waitable adds to the wait set
/// are waited for. Nothing else of the C library has something to wait for here.
class Waitable : public detail::Executable {
 public:
  RCLCPP_SMART_PTR_DEFINITIONS_NOT_COPYABLE(Waitable)

  virtual size_t get_number_of_ready_subscriptions() { return 0; }
  virtual size_t get_number_of_ready_timers() { return 0; }
  virtual size_t get_number_of_ready_clients() { return 0; }
  virtual size_t get_number_of_ready_events() { return 0; }
  virtual size_t get_number_of_ready_services() { return 0; }
  virtual size_t get_number_of_ready_guard_conditions() { return 0; }

  /// In each pair the newer form calls the older one, which throws where neither is overridden.
  virtual void add_to_wait_set(rcl_wait_set_t& wait_set);
  virtual void add_to_wait_set(rcl_wait_set_t* wait_set);
  virtual bool is_ready(const rcl_wait_set_t& wait_set);
  virtual bool is_ready(rcl_wait_set_t* wait_set);
  virtual void execute(const std::shared_ptr<void>& data) = 0;
  virtual std::shared_ptr<void> take_data() = 0;
  /// Throws std::runtime_error unless it is overridden, as do the two callbacks.
  virtual std::shared_ptr<void> take_data_by_entity_id(size_t id);
  bool exchange_in_use_by_wait_set_state(bool in_use_state) {
    return in_use_by_wait_set_.exchange(in_use_state);
  }
  virtual void set_on_ready_callback(std::function<void(size_t, int)> callback);
  virtual void clear_on_ready_callback();

  bool polls() const override { return true; }
  /// Asks it with a wait set of its own.
  bool is_ready_now() override;
  bool claim(std::shared_ptr<void>& data) override;
  bool run(std::shared_ptr<void>& data) override;

 private:
  std::atomic<bool> in_use_by_wait_set_{false};
  // Was ready when it was asked: its triggers are taken then.
  std::atomic<bool> was_ready_{false};
};

namespace detail {

/// A wait set of the C library. Its triggered guard conditions are ready, and nothing else is.
class RclWaitSet {
 public:
  RclWaitSet();
  ~RclWaitSet();
  RclWaitSet(const RclWaitSet&) = delete;
  RclWaitSet& operator=(const RclWaitSet&) = delete;

  /// Makes room for what the waitable asks for.
  void reserve(Waitable& waitable);
  /// Empties it, with the room that was reserved.
  void clear();
  /// Leaves the guard conditions that were triggered, and takes the triggers. False: none was.
  bool take_triggers();

  rcl_wait_set_t handle;
  /// The room that it gets with clear().
  size_t subscriptions = 0;
  size_t guard_conditions = 0;
  size_t timers = 0;
  size_t clients = 0;
  size_t services = 0;
  size_t events = 0;
};

}  // namespace detail
}  // namespace rclcpp
