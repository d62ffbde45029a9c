// The life of one "ROS": from init to shutdown. Nodes, executors and sleeps belong to one.
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <string>
#include <typeindex>
#include <typeinfo>
#include <unordered_map>
#include <utility>
#include <vector>

#include "rcl/context.h"
#include "rclcpp/init_options.hpp"
#include "rclcpp/macros.hpp"
#include "rclcpp/visibility_control.hpp"

namespace ros2wasm {
struct Arguments;
}

namespace rclcpp {

class ContextAlreadyInitialized : public std::runtime_error {
 public:
  ContextAlreadyInitialized() : std::runtime_error("context is already initialized") {}
};

class ShutdownCallbackHandle {
  friend class Context;

 public:
  using ShutdownCallbackType = std::function<void()>;

 private:
  std::weak_ptr<ShutdownCallbackType> callback;
};

using OnShutdownCallbackHandle = ShutdownCallbackHandle;
using PreShutdownCallbackHandle = ShutdownCallbackHandle;

class Context : public std::enable_shared_from_this<Context> {
 public:
  RCLCPP_SMART_PTR_DEFINITIONS(Context)

  Context();
  virtual ~Context();

  /// Throws ContextAlreadyInitialized, UnknownROSArgsError or RCLInvalidROSArgsError.
  virtual void init(int argc, char const* const* argv,
                    const rclcpp::InitOptions& init_options = rclcpp::InitOptions());
  /// False before init, after shutdown, and once a stop was requested.
  bool is_valid() const;
  const rclcpp::InitOptions& get_init_options() const { return init_options_; }
  rclcpp::InitOptions get_init_options() { return init_options_; }
  size_t get_domain_id() const { return init_options_.get_domain_id(); }
  std::string shutdown_reason() const;
  virtual bool shutdown(const std::string& reason);

  using OnShutdownCallback = OnShutdownCallbackHandle::ShutdownCallbackType;
  virtual OnShutdownCallback on_shutdown(OnShutdownCallback callback);
  virtual OnShutdownCallbackHandle add_on_shutdown_callback(OnShutdownCallback callback);
  virtual bool remove_on_shutdown_callback(const OnShutdownCallbackHandle& callback_handle);
  using PreShutdownCallback = PreShutdownCallbackHandle::ShutdownCallbackType;
  virtual PreShutdownCallbackHandle add_pre_shutdown_callback(PreShutdownCallback callback);
  virtual bool remove_pre_shutdown_callback(const PreShutdownCallbackHandle& callback_handle);
  std::vector<OnShutdownCallback> get_on_shutdown_callbacks() const;
  std::vector<PreShutdownCallback> get_pre_shutdown_callbacks() const;

  /// False when the sleep was cut short by shutdown or interrupt_all_sleep_for.
  bool sleep_for(const std::chrono::nanoseconds& nanoseconds);
  void interrupt_all_sleep_for();

  /// An object of the caller's type, one per context, made on first use.
  template <typename SubContext, typename... Args>
  std::shared_ptr<SubContext> get_sub_context(Args&&... args) {
    const std::lock_guard<std::recursive_mutex> lock(sub_contexts_mutex_);
    std::shared_ptr<void>& slot = sub_contexts_[std::type_index(typeid(SubContext))];
    if (!slot) {
      slot = std::make_shared<SubContext>(std::forward<Args>(args)...);
    }
    return std::static_pointer_cast<SubContext>(slot);
  }

  /// Its name in the C library. It is nobody's to initialise or end.
  std::shared_ptr<rcl_context_t> get_rcl_context() { return rcl_context_; }
  /// The arguments given to init; never null after it.
  std::shared_ptr<const ros2wasm::Arguments> get_global_arguments() const { return arguments_; }

 private:
  RCLCPP_DISABLE_COPY(Context)
  using Callbacks = std::vector<std::shared_ptr<std::function<void()>>>;

  mutable std::recursive_mutex mutex_;
  bool valid_ = false;
  uint32_t sleep_interrupts_ = 0;
  rclcpp::InitOptions init_options_;
  std::string shutdown_reason_;
  std::shared_ptr<const ros2wasm::Arguments> arguments_;
  const std::shared_ptr<rcl_context_t> rcl_context_ = std::make_shared<rcl_context_t>();
  std::unordered_map<std::type_index, std::shared_ptr<void>> sub_contexts_;
  std::recursive_mutex sub_contexts_mutex_;
  Callbacks on_shutdown_callbacks_;
  Callbacks pre_shutdown_callbacks_;
};

/// All contexts that are initialised.
std::vector<Context::SharedPtr> get_contexts();

namespace detail {
/// When a stop was requested and not yet seen: logs it and shuts down the contexts that ask for it.
void notice_stop_request();
}  // namespace detail

}  // namespace rclcpp
