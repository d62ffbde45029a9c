// The list of listeners.
#include "rclcpp/detail/listeners.hpp"

#include <algorithm>
#include <atomic>
#include <mutex>
#include <typeinfo>
#include <vector>

#include "rclcpp/logging.hpp"
#include "ros2wasm/endpoint.hpp"

namespace rclcpp {
namespace detail {
namespace {

struct Listener {
  std::recursive_mutex mutex;
  std::function<void()> look;
};

struct Listeners {
  std::mutex mutex;
  std::vector<std::shared_ptr<Listener>> all;
  // Programs without listeners ask this alone.
  std::atomic<bool> any{false};
};

Listeners& listeners() {
  // Never destroyed: static objects may have listeners.
  static auto* instance = new Listeners;
  return *instance;
}

void remove_listener(const std::shared_ptr<Listener>& listener) {
  {
    const std::lock_guard<std::mutex> lock(listeners().mutex);
    auto& all = listeners().all;
    all.erase(std::remove(all.begin(), all.end(), listener), all.end());
    listeners().any = !all.empty();
  }
  const std::lock_guard<std::recursive_mutex> lock(listener->mutex);
  listener->look = nullptr;
}

}  // namespace

std::shared_ptr<void> add_listener(std::function<void()> look) {
  auto listener = std::make_shared<Listener>();
  listener->look = std::move(look);
  {
    const std::lock_guard<std::mutex> lock(listeners().mutex);
    listeners().all.push_back(listener);
    listeners().any = true;
  }
  // Wake the waits: data that arrived before this registration must also be reported.
  ros2wasm::wake();
  return {listener.get(), [listener](void*) { remove_listener(listener); }};
}

void log_thrown(const void* owner, const char* class_name, const char* subject) {
  const auto logger = rclcpp::get_logger("rclcpp");
  try {
    throw;
  } catch (const std::exception& exception) {
    RCLCPP_ERROR(logger,
                 "%s@%p caught %s exception in user-provided callback for the '%s' callback: %s",
                 class_name, owner, typeid(exception).name(), subject, exception.what());
  } catch (...) {
    RCLCPP_ERROR(logger,
                 "%s@%p caught unhandled exception in user-provided callback for the '%s' callback",
                 class_name, owner, subject);
  }
}

void look_for_listeners() {
  if (!listeners().any) {
    return;
  }
  std::vector<std::shared_ptr<Listener>> all;
  {
    const std::lock_guard<std::mutex> lock(listeners().mutex);
    all = listeners().all;
  }
  for (const auto& listener : all) {
    const std::lock_guard<std::recursive_mutex> lock(listener->mutex);
    // A copy: it may remove itself.
    if (const auto look = listener->look) {
      look();
    }
  }
}

}  // namespace detail
}  // namespace rclcpp
