// Clocks, their sleeps and their jumps.
#include "rclcpp/clock.hpp"

#include <atomic>
#include <stdexcept>
#include <vector>

#include "rclcpp/detail/background.hpp"
#include "rclcpp/exceptions.hpp"
#include "ros2wasm/endpoint.hpp"

namespace rclcpp {

JumpHandler::JumpHandler(pre_callback_t pre, post_callback_t post,
                         const rcl_jump_threshold_t& threshold)
    : pre_callback(std::move(pre)), post_callback(std::move(post)), notice_threshold(threshold) {}

class Clock::Impl {
 public:
  explicit Impl(rcl_clock_type_t type_in) : type(type_in) {}

  int64_t now() const {
    if (type == RCL_STEADY_TIME) {
      return ros2wasm::steady_now_ns();
    }
    return type == RCL_ROS_TIME && ros_active ? ros_now.load() : ros2wasm::system_now_ns();
  }

  const rcl_clock_type_t type;
  std::mutex clock_mutex;
  std::atomic<bool> ros_active{false};
  std::atomic<int64_t> ros_now{0};
  std::atomic<uint32_t> cancels{0};
  std::mutex handlers_mutex;
  std::vector<std::weak_ptr<JumpHandler>> handlers;
};

Clock::Clock(rcl_clock_type_t clock_type) : impl_(std::make_shared<Impl>(clock_type)) {
  if (clock_type != RCL_ROS_TIME && clock_type != RCL_SYSTEM_TIME &&
      clock_type != RCL_STEADY_TIME) {
    rcutils_set_error_state("invalid clock type", __FILE__, __LINE__);
    exceptions::throw_from_rcl_error(RCL_RET_INVALID_ARGUMENT, "failed to initialize rcl clock");
  }
}

Clock::~Clock() = default;

Time Clock::now() const {
  return Time(impl_->now(), impl_->type);
}

bool Clock::wait_until(int64_t until_ns, const Context::SharedPtr& context) {
  const bool was_active = impl_->ros_active;
  const uint32_t cancels = impl_->cancels;
  while (true) {
    const int32_t token = ros2wasm::wake_token();
    detail::run_background();
    const int64_t left = until_ns - impl_->now();
    if (!context->is_valid() || impl_->cancels != cancels || impl_->ros_active != was_active) {
      return false;
    }
    if (left <= 0) {
      return true;
    }
    ros2wasm::wait(token, was_active ? -1 : left);
  }
}

bool Clock::sleep_until(Time until, Context::SharedPtr context) {
  if (!context || !context->is_valid()) {
    throw std::runtime_error("context cannot be slept with because it's invalid");
  }
  if (until.get_clock_type() != impl_->type) {
    throw std::runtime_error("until's clock type does not match this clock's type");
  }
  return wait_until(until.nanoseconds(), context);
}

bool Clock::sleep_for(Duration rel_time, Context::SharedPtr context) {
  return sleep_until(now() + rel_time, std::move(context));
}

bool Clock::started() {
  return impl_->now() > 0;
}

bool Clock::wait_until_started(Context::SharedPtr context) {
  if (!context || !context->is_valid()) {
    throw std::runtime_error("context cannot be slept with because it's invalid");
  }
  return started() || wait_until(1, context);
}

bool Clock::wait_until_started(const rclcpp::Duration& timeout, Context::SharedPtr context,
                               const rclcpp::Duration&) {
  if (!context || !context->is_valid()) {
    throw std::runtime_error("context cannot be slept with because it's invalid");
  }
  const int64_t until = ros2wasm::steady_now_ns() + timeout.nanoseconds();
  while (!started()) {
    const int32_t token = ros2wasm::wake_token();
    detail::run_background();
    const int64_t left = until - ros2wasm::steady_now_ns();
    if (started()) {
      return true;
    }
    if (left <= 0 || !context->is_valid()) {
      return false;
    }
    ros2wasm::wait(token, left);
  }
  return true;
}

bool Clock::ros_time_is_active() {
  return impl_->type == RCL_ROS_TIME && impl_->ros_active;
}

void Clock::cancel_sleep_or_wait() {
  ++impl_->cancels;
  ros2wasm::wake();
}

rcl_clock_type_t Clock::get_clock_type() const noexcept {
  return impl_->type;
}

std::mutex& Clock::get_clock_mutex() noexcept {
  return impl_->clock_mutex;
}

JumpHandler::SharedPtr Clock::create_jump_callback(JumpHandler::pre_callback_t pre_callback,
                                                   JumpHandler::post_callback_t post_callback,
                                                   const rcl_jump_threshold_t& threshold) {
  auto handler =
      std::make_shared<JumpHandler>(std::move(pre_callback), std::move(post_callback), threshold);
  const std::lock_guard<std::mutex> lock(impl_->handlers_mutex);
  impl_->handlers.push_back(handler);
  return handler;
}

template <typename ChangeT>
void Clock::jump(rcl_clock_change_t change, ChangeT&& apply) {
  std::vector<JumpHandler::SharedPtr> handlers;
  {
    const std::lock_guard<std::mutex> lock(impl_->handlers_mutex);
    auto& all = impl_->handlers;
    for (size_t i = 0; i < all.size();) {
      if (auto handler = all[i].lock()) {
        handlers.push_back(std::move(handler));
        ++i;
      } else {
        all.erase(all.begin() + static_cast<ptrdiff_t>(i));
      }
    }
  }
  const auto [before, after] = apply();
  const rcl_time_jump_t step{change, {after - before}};
  for (const auto& handler : handlers) {
    const rcl_jump_threshold_t& limit = handler->notice_threshold;
    const bool changed = change == RCL_ROS_TIME_ACTIVATED || change == RCL_ROS_TIME_DEACTIVATED;
    const bool noticed = (changed && limit.on_clock_change) ||
                         (limit.min_forward.nanoseconds > 0 &&
                          step.delta.nanoseconds >= limit.min_forward.nanoseconds) ||
                         (limit.min_backward.nanoseconds < 0 &&
                          step.delta.nanoseconds <= limit.min_backward.nanoseconds);
    if (!noticed) {
      continue;
    }
    if (handler->pre_callback) {
      handler->pre_callback();
    }
    if (handler->post_callback) {
      handler->post_callback(step);
    }
  }
  ros2wasm::wake();
}

void Clock::set_ros_time_active(bool active) {
  if (impl_->type != RCL_ROS_TIME || impl_->ros_active == active) {
    return;
  }
  jump(active ? RCL_ROS_TIME_ACTIVATED : RCL_ROS_TIME_DEACTIVATED, [&] {
    const int64_t before = impl_->now();
    impl_->ros_active = active;
    return std::pair<int64_t, int64_t>(before, impl_->now());
  });
}

void Clock::set_ros_time(int64_t nanoseconds) {
  if (!impl_->ros_active) {
    impl_->ros_now = nanoseconds;
    return;
  }
  jump(RCL_ROS_TIME_NO_CHANGE, [&] {
    const int64_t before = impl_->ros_now.exchange(nanoseconds);
    return std::pair<int64_t, int64_t>(before, nanoseconds);
  });
}

}  // namespace rclcpp
