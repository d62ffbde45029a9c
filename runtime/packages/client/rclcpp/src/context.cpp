// Contexts, stop requests, and the free functions around them.
#include "rclcpp/context.hpp"

#include <algorithm>
#include <atomic>
#include <thread>

#include "rclcpp/contexts/default_context.hpp"
#include "rclcpp/detail/background.hpp"
#include "rclcpp/exceptions.hpp"
#include "rclcpp/logging.hpp"
#include "rclcpp/utilities.hpp"
#include "ros2wasm/arguments.hpp"
#include "ros2wasm/endpoint.hpp"

namespace rclcpp {
namespace {

struct Registry {
  std::mutex mutex;
  std::vector<std::weak_ptr<Context>> contexts;
};

Registry& registry() {
  static Registry instance;
  return instance;
}

std::atomic<bool> g_handles_stop{false};
std::atomic<bool> g_stop_seen{false};
/// The thread that installed the handlers, usually that of main().
std::atomic<std::thread::id> g_stopping_thread{};
std::atomic<SignalHandlerOptions> g_signal_options{SignalHandlerOptions::None};

std::vector<std::string> to_strings(int argc, char const* const* argv) {
  std::vector<std::string> arguments;
  for (int i = 0; i < argc && argv != nullptr; ++i) {
    arguments.emplace_back(argv[i]);
  }
  return arguments;
}

ros2wasm::Arguments parse(const std::vector<std::string>& arguments) {
  try {
    return ros2wasm::parse_arguments(arguments);
  } catch (const std::invalid_argument& error) {
    rcutils_set_error_state(error.what(), __FILE__, __LINE__);
    exceptions::throw_from_rcl_error(RCL_RET_INVALID_ROS_ARGS, "failed to initialize rcl");
  }
}

void apply_log_levels(const ros2wasm::Arguments& arguments) {
  for (const auto& [logger, level] : arguments.log_levels) {
    if (rcutils_logging_set_logger_level(logger.c_str(), level) != RCUTILS_RET_OK) {
      rcutils_reset_error();
    }
  }
}

std::vector<std::function<void()>> copy_callbacks(
    const std::vector<std::shared_ptr<std::function<void()>>>& callbacks) {
  std::vector<std::function<void()>> copies;
  for (const auto& callback : callbacks) {
    copies.push_back(*callback);
  }
  return copies;
}

/// A shutdown may wait for other threads, such as one that works on a goal of an action, so another
/// thread leaves it to the one that installed the handlers. Where that does not come, because it
/// waits for other threads itself, this one goes on after a while.
void leave_shutdown_to_stopping_thread() {
  constexpr int64_t kLongestNs = 500'000'000;
  constexpr int64_t kPauseNs = 1'000'000;
  if (std::this_thread::get_id() == g_stopping_thread.load()) {
    return;
  }
  ros2wasm::wake();
  const int64_t until_ns = ros2wasm::steady_now_ns() + kLongestNs;
  while (!g_stop_seen && ros2wasm::steady_now_ns() < until_ns) {
    ros2wasm::wait(ros2wasm::wake_token(), kPauseNs);
  }
}

bool remove_callback(std::vector<std::shared_ptr<std::function<void()>>>& callbacks,
                     const std::shared_ptr<std::function<void()>>& callback) {
  const auto found = std::find(callbacks.begin(), callbacks.end(), callback);
  if (callback == nullptr || found == callbacks.end()) {
    return false;
  }
  callbacks.erase(found);
  return true;
}

Context::SharedPtr default_if_null(Context::SharedPtr context) {
  return context ? context : contexts::get_global_default_context();
}

}  // namespace

Context::Context() = default;

Context::~Context() {
  try {
    if (valid_) {
      Context::shutdown("context destructor was called while still not shutdown");
    }
  } catch (const std::exception& error) {
    RCLCPP_ERROR(get_logger("rclcpp"), "caught exception while shutting down: %s", error.what());
  }
}

void Context::init(int argc, char const* const* argv, const rclcpp::InitOptions& init_options) {
  const std::lock_guard<std::recursive_mutex> lock(mutex_);
  if (valid_) {
    throw ContextAlreadyInitialized();
  }
  auto arguments = std::make_shared<ros2wasm::Arguments>(parse(to_strings(argc, argv)));
  if (!arguments->unknown_ros_arguments.empty()) {
    throw exceptions::UnknownROSArgsError(std::move(arguments->unknown_ros_arguments));
  }
  if (init_options.auto_initialize_logging()) {
    RCUTILS_LOGGING_AUTOINIT;
    apply_log_levels(*arguments);
    detail::install_log_handler(arguments->log_stdout, arguments->log_rosout);
  }
  arguments_ = std::move(arguments);
  init_options_ = init_options;
  shutdown_reason_.clear();
  valid_ = true;
  const std::lock_guard<std::mutex> registry_lock(registry().mutex);
  registry().contexts.push_back(weak_from_this());
}

bool Context::is_valid() const {
  detail::notice_stop_request();
  return valid_;
}

std::string Context::shutdown_reason() const {
  const std::lock_guard<std::recursive_mutex> lock(mutex_);
  return shutdown_reason_;
}

bool Context::shutdown(const std::string& reason) {
  const std::lock_guard<std::recursive_mutex> lock(mutex_);
  if (!valid_) {
    return false;
  }
  for (const auto& callback : get_pre_shutdown_callbacks()) {
    callback();
  }
  valid_ = false;
  shutdown_reason_ = reason;
  for (const auto& callback : get_on_shutdown_callbacks()) {
    callback();
  }
  interrupt_all_sleep_for();
  const std::lock_guard<std::mutex> registry_lock(registry().mutex);
  auto& contexts = registry().contexts;
  contexts.erase(std::remove_if(contexts.begin(), contexts.end(),
                                [this](const std::weak_ptr<Context>& weak) {
                                  const auto context = weak.lock();
                                  return context == nullptr || context.get() == this;
                                }),
                 contexts.end());
  return true;
}

Context::OnShutdownCallback Context::on_shutdown(OnShutdownCallback callback) {
  add_on_shutdown_callback(callback);
  return callback;
}

OnShutdownCallbackHandle Context::add_on_shutdown_callback(OnShutdownCallback callback) {
  const std::lock_guard<std::recursive_mutex> lock(mutex_);
  on_shutdown_callbacks_.push_back(std::make_shared<std::function<void()>>(std::move(callback)));
  OnShutdownCallbackHandle handle;
  handle.callback = on_shutdown_callbacks_.back();
  return handle;
}

bool Context::remove_on_shutdown_callback(const OnShutdownCallbackHandle& callback_handle) {
  const std::lock_guard<std::recursive_mutex> lock(mutex_);
  return remove_callback(on_shutdown_callbacks_, callback_handle.callback.lock());
}

PreShutdownCallbackHandle Context::add_pre_shutdown_callback(PreShutdownCallback callback) {
  const std::lock_guard<std::recursive_mutex> lock(mutex_);
  pre_shutdown_callbacks_.push_back(std::make_shared<std::function<void()>>(std::move(callback)));
  PreShutdownCallbackHandle handle;
  handle.callback = pre_shutdown_callbacks_.back();
  return handle;
}

bool Context::remove_pre_shutdown_callback(const PreShutdownCallbackHandle& callback_handle) {
  const std::lock_guard<std::recursive_mutex> lock(mutex_);
  return remove_callback(pre_shutdown_callbacks_, callback_handle.callback.lock());
}

std::vector<Context::OnShutdownCallback> Context::get_on_shutdown_callbacks() const {
  const std::lock_guard<std::recursive_mutex> lock(mutex_);
  return copy_callbacks(on_shutdown_callbacks_);
}

std::vector<Context::PreShutdownCallback> Context::get_pre_shutdown_callbacks() const {
  const std::lock_guard<std::recursive_mutex> lock(mutex_);
  return copy_callbacks(pre_shutdown_callbacks_);
}

bool Context::sleep_for(const std::chrono::nanoseconds& nanoseconds) {
  const uint32_t interrupts = sleep_interrupts_;
  const int64_t until = ros2wasm::steady_now_ns() + nanoseconds.count();
  while (true) {
    const int32_t token = ros2wasm::wake_token();
    if (!is_valid() || interrupts != sleep_interrupts_) {
      return false;
    }
    detail::run_background();
    const int64_t left = until - ros2wasm::steady_now_ns();
    if (left <= 0) {
      return true;
    }
    ros2wasm::wait(token, left);
  }
}

void Context::interrupt_all_sleep_for() {
  ++sleep_interrupts_;
  ros2wasm::wake();
}

std::vector<Context::SharedPtr> get_contexts() {
  const std::lock_guard<std::mutex> lock(registry().mutex);
  std::vector<Context::SharedPtr> contexts;
  for (const auto& weak : registry().contexts) {
    if (auto context = weak.lock()) {
      contexts.push_back(std::move(context));
    }
  }
  return contexts;
}

namespace detail {

void notice_stop_request() {
  if (!g_handles_stop.load(std::memory_order_relaxed) || !ros2wasm::stop_requested() ||
      g_stop_seen) {
    return;
  }
  leave_shutdown_to_stopping_thread();
  if (g_stop_seen.exchange(true)) {
    return;
  }
  constexpr int kInterrupt = 2;
  RCLCPP_INFO(get_logger("rclcpp"), "signal_handler(signum=%d)", kInterrupt);
  for (const auto& context : get_contexts()) {
    if (context->get_init_options().shutdown_on_signal) {
      context->shutdown("signal handler");
    }
  }
}

}  // namespace detail

namespace {

/// Nobody counts one more owner here, which costs two atomic changes.
const contexts::DefaultContext::SharedPtr& default_context() {
  static const contexts::DefaultContext::SharedPtr context =
      std::make_shared<contexts::DefaultContext>();
  return context;
}

}  // namespace

contexts::DefaultContext::SharedPtr contexts::get_global_default_context() {
  return default_context();
}

void init(int argc, char const* const* argv, const InitOptions& init_options,
          SignalHandlerOptions signal_handler_options) {
  contexts::get_global_default_context()->init(argc, argv, init_options);
  install_signal_handlers(signal_handler_options);
}

bool install_signal_handlers(SignalHandlerOptions signal_handler_options) {
  if (signal_handler_options == SignalHandlerOptions::None) {
    return false;
  }
  g_signal_options = signal_handler_options;
  g_stopping_thread = std::this_thread::get_id();
  return !g_handles_stop.exchange(true);
}

bool signal_handlers_installed() {
  return g_handles_stop;
}

SignalHandlerOptions get_current_signal_handler_options() {
  return g_signal_options;
}

bool uninstall_signal_handlers() {
  g_signal_options = SignalHandlerOptions::None;
  return g_handles_stop.exchange(false);
}

std::vector<std::string> remove_ros_arguments(int argc, char const* const* argv) {
  return parse(to_strings(argc, argv)).other_arguments;
}

std::vector<std::string> init_and_remove_ros_arguments(int argc, char const* const* argv,
                                                       const InitOptions& init_options) {
  init(argc, argv, init_options);
  return remove_ros_arguments(argc, argv);
}

bool ok(Context::SharedPtr context) {
  return context ? context->is_valid() : default_context()->is_valid();
}

bool shutdown(Context::SharedPtr context, const std::string& reason) {
  const bool is_default = !context || context == contexts::get_global_default_context();
  const bool did_shut_down = default_if_null(std::move(context))->shutdown(reason);
  if (is_default) {
    uninstall_signal_handlers();
  }
  return did_shut_down;
}

void on_shutdown(std::function<void()> callback, Context::SharedPtr context) {
  default_if_null(std::move(context))->on_shutdown(std::move(callback));
}

bool sleep_for(const std::chrono::nanoseconds& nanoseconds, Context::SharedPtr context) {
  return default_if_null(std::move(context))->sleep_for(nanoseconds);
}

const char* get_c_string(const char* string_in) {
  return string_in;
}
const char* get_c_string(const std::string& string_in) {
  return string_in.c_str();
}

std::vector<const char*> get_c_vector_string(const std::vector<std::string>& strings_in) {
  std::vector<const char*> pointers;
  for (const std::string& text : strings_in) {
    pointers.push_back(text.c_str());
  }
  return pointers;
}

}  // namespace rclcpp
