// The callbacks of `set_on_new_..._callback`, which are called as soon as something arrives,
// outside executors. Nothing runs in a program by itself, so every wait in the process (an
// executor, a wait set, a sleep) checks for all of them, before and after the wait.
#pragma once

#include <functional>
#include <memory>
#include <utility>

namespace rclcpp {
namespace detail {

/// `look` is called from any thread that waits, until the returned handle is gone; that waits for a
/// call that is under way in another thread.
std::shared_ptr<void> add_listener(std::function<void()> look);
/// Lets each listener look. To be called after the wake token was read and without locks.
void look_for_listeners();

/// Logs what a callback threw: "CLASS@ADDRESS caught ... in user-provided callback for the
/// 'SUBJECT' callback". To be called while the exception is handled.
void log_thrown(const void* owner, const char* class_name, const char* subject);

/// The callback, behind what keeps its exceptions from whoever happened to wait.
template <typename... ArgsT>
std::function<void(ArgsT...)> guarded(const void* owner, const char* class_name,
                                      const char* subject, std::function<void(ArgsT...)> callback) {
  return [owner, class_name, subject, callback = std::move(callback)](ArgsT... args) {
    try {
      callback(args...);
    } catch (...) {
      log_thrown(owner, class_name, subject);
    }
  };
}

}  // namespace detail
}  // namespace rclcpp
