// Something of the user's own that an executor waits for and runs.
#pragma once

#include <atomic>
#include <cstddef>
#include <functional>
#include <memory>

#include "rclcpp/detail/executable.hpp"
#include "rclcpp/macros.hpp"
#include "rclcpp/visibility_control.hpp"

namespace rclcpp {

/// Differs from rclcpp on ROS machines: there is no rcl wait set, so a waitable says itself
/// whether it is ready, and calls ros2wasm::wake (or triggers a guard condition) when it becomes
/// so.
class Waitable : public detail::Executable {
 public:
  RCLCPP_SMART_PTR_DEFINITIONS_NOT_COPYABLE(Waitable)

  virtual bool is_ready() = 0;
  virtual std::shared_ptr<void> take_data() = 0;
  virtual std::shared_ptr<void> take_data_by_entity_id(size_t id) {
    (void)id;
    return take_data();
  }
  virtual void execute(const std::shared_ptr<void>& data) = 0;
  virtual void set_on_ready_callback(std::function<void(size_t, int)> callback) {
    on_ready_callback_ = std::move(callback);
  }
  virtual void clear_on_ready_callback() { on_ready_callback_ = nullptr; }
  bool exchange_in_use_by_wait_set_state(bool in_use_state) {
    return in_use_by_wait_set_.exchange(in_use_state);
  }

  bool polls() const override { return true; }
  bool is_ready_now() override { return is_ready(); }
  bool claim(std::shared_ptr<void>& data) override {
    if (!is_ready()) {
      return false;
    }
    data = take_data();
    return true;
  }
  bool run(std::shared_ptr<void>& data) override {
    execute(data);
    return true;
  }

 private:
  std::function<void(size_t, int)> on_ready_callback_;
  std::atomic<bool> in_use_by_wait_set_{false};
};

}  // namespace rclcpp
