// Lookups that wait, in one of two ways: blocking, or with a callback and a timer.
#include "tf2_ros/buffer.hpp"

#include <algorithm>
#include <cstdio>
#include <exception>

#include "rclcpp/detail/background.hpp"
#include "ros2wasm/endpoint.hpp"

namespace tf2_ros {
namespace {

// Transforms that another thread puts in by hand wake nobody.
constexpr std::chrono::milliseconds kLookAgain(10);
// The result of addTransformableRequest for a transform that will never be available.
constexpr tf2::TransformableRequestHandle kNever = ~tf2::TransformableRequestHandle(0);

using Transform = geometry_msgs::msg::TransformStamped;

}  // namespace

void Buffer::watch_clock() {
  if (clock_ == nullptr) {
    throw std::invalid_argument("clock must be a valid instance");
  }
  rcl_jump_threshold_t threshold;
  threshold.on_clock_change = true;
  threshold.min_forward.nanoseconds = 0;
  threshold.min_backward.nanoseconds = -1;
  jump_handler_ = clock_->create_jump_callback(
      nullptr, [this](const rcl_time_jump_t& jump) { on_time_jump(jump); }, threshold);
}

void Buffer::on_time_jump(const rcl_time_jump_t& jump) {
  if (jump.clock_change == RCL_ROS_TIME_ACTIVATED ||
      jump.clock_change == RCL_ROS_TIME_DEACTIVATED) {
    RCLCPP_WARN(getLogger(), "Detected time source change. Clearing TF buffer.");
    clear();
  } else if (jump.delta.nanoseconds < 0) {
    RCLCPP_WARN(getLogger(), "Detected jump back in time. Clearing TF buffer.");
    clear();
  }
}

Transform Buffer::lookupTransform(const std::string& target_frame, const std::string& source_frame,
                                  const tf2::TimePoint& time) const {
  rclcpp::detail::run_background();
  return BufferCore::lookupTransform(target_frame, source_frame, time);
}

Transform Buffer::lookupTransform(const std::string& target_frame, const std::string& source_frame,
                                  const tf2::TimePoint& time, const tf2::Duration timeout) const {
  std::string unused;
  canTransform(target_frame, source_frame, time, timeout, &unused);
  return BufferCore::lookupTransform(target_frame, source_frame, time);
}

Transform Buffer::lookupTransform(const std::string& target_frame,
                                  const tf2::TimePoint& target_time,
                                  const std::string& source_frame,
                                  const tf2::TimePoint& source_time,
                                  const std::string& fixed_frame) const {
  rclcpp::detail::run_background();
  return BufferCore::lookupTransform(target_frame, target_time, source_frame, source_time,
                                     fixed_frame);
}

Transform Buffer::lookupTransform(const std::string& target_frame,
                                  const tf2::TimePoint& target_time,
                                  const std::string& source_frame,
                                  const tf2::TimePoint& source_time, const std::string& fixed_frame,
                                  const tf2::Duration timeout) const {
  std::string unused;
  canTransform(target_frame, target_time, source_frame, source_time, fixed_frame, timeout, &unused);
  return BufferCore::lookupTransform(target_frame, target_time, source_frame, source_time,
                                     fixed_frame);
}

bool Buffer::canTransform(const std::string& target_frame, const std::string& source_frame,
                          const tf2::TimePoint& time, std::string* error_msg) const {
  rclcpp::detail::run_background();
  return BufferCore::canTransform(target_frame, source_frame, time, error_msg);
}

bool Buffer::canTransform(const std::string& target_frame, const std::string& source_frame,
                          const tf2::TimePoint& target_time, const tf2::Duration timeout,
                          std::string* errstr) const {
  return ask_for(
      [&] { return BufferCore::canTransform(target_frame, source_frame, target_time, errstr); },
      timeout, errstr);
}

bool Buffer::canTransform(const std::string& target_frame, const tf2::TimePoint& target_time,
                          const std::string& source_frame, const tf2::TimePoint& source_time,
                          const std::string& fixed_frame, std::string* error_msg) const {
  rclcpp::detail::run_background();
  return BufferCore::canTransform(target_frame, target_time, source_frame, source_time, fixed_frame,
                                  error_msg);
}

bool Buffer::canTransform(const std::string& target_frame, const tf2::TimePoint& target_time,
                          const std::string& source_frame, const tf2::TimePoint& source_time,
                          const std::string& fixed_frame, const tf2::Duration timeout,
                          std::string* errstr) const {
  return ask_for(
      [&] {
        return BufferCore::canTransform(target_frame, target_time, source_frame, source_time,
                                        fixed_frame, errstr);
      },
      timeout, errstr);
}

bool Buffer::ask_for(const std::function<bool()>& can_transform, tf2::Duration timeout,
                     std::string* errstr) const {
  if (timeout != tf2::Duration::zero() && !has_listener(errstr)) {
    return false;
  }
  const rclcpp::Time start = clock_->now();
  const rclcpp::Time end = start + toRclcpp(timeout);
  bool can = false;
  while (true) {
    const int32_t token = ros2wasm::wake_token();
    rclcpp::detail::run_background();
    can = can_transform();
    const rclcpp::Time now = clock_->now();
    const bool went_back = now + rclcpp::Duration(3, 0) < start;
    if (can || now >= end || went_back || !rclcpp::ok()) {
      break;
    }
    ros2wasm::wait(token, std::min(fromRclcpp(end - now), tf2::Duration(kLookAgain)).count());
  }
  if (errstr != nullptr) {
    char text[100];
    std::snprintf(text, sizeof text, ". canTransform returned after %g timeout was %g.",
                  tf2::durationToSec(fromRclcpp(clock_->now() - start)),
                  tf2::durationToSec(timeout));
    *errstr += text;
  }
  return can;
}

bool Buffer::has_listener(std::string* errstr) const {
  if (isUsingDedicatedThread()) {
    return true;
  }
  if (errstr != nullptr) {
    *errstr = threading_error;
  }
  RCLCPP_ERROR(getLogger(), "%s", threading_error);
  return false;
}

bool Buffer::end_wait(tf2::TransformableRequestHandle request) {
  const std::lock_guard<std::mutex> lock(waits_mutex_);
  const auto found = timer_of_wait_.find(request);
  if (found == timer_of_wait_.end()) {
    return false;
  }
  timer_interface_->remove(found->second);
  timer_of_wait_.erase(found);
  return true;
}

TransformStampedFuture Buffer::waitForTransform(const std::string& target_frame,
                                                const std::string& source_frame,
                                                const tf2::TimePoint& time,
                                                const tf2::Duration& timeout,
                                                TransformReadyCallback callback) {
  if (timer_interface_ == nullptr) {
    throw CreateTimerInterfaceException("timer interface not set before call to waitForTransform");
  }
  auto promise = std::make_shared<std::promise<Transform>>();
  TransformStampedFuture future(promise->get_future().share());
  const auto finish = [this, promise, future, callback, target_frame, source_frame,
                       time](tf2::TransformableResult result) {
    try {
      if (result != tf2::TransformAvailable) {
        throw tf2::LookupException("Failed to transform from " + source_frame + " to " +
                                   target_frame);
      }
      promise->set_value(BufferCore::lookupTransform(target_frame, source_frame, time));
    } catch (const tf2::TransformException&) {
      promise->set_exception(std::current_exception());
    }
    callback(future);
  };
  std::unique_lock<std::mutex> lock(waits_mutex_);
  const auto request = addTransformableRequest(
      [this, finish](tf2::TransformableRequestHandle handle, const std::string&, const std::string&,
                     tf2::TimePoint, tf2::TransformableResult result) {
        if (end_wait(handle)) {
          finish(result);
        }
      },
      target_frame, source_frame, time);
  future.setHandle(request);
  if (request == 0 || request == kNever) {
    lock.unlock();
    finish(request == 0 ? tf2::TransformAvailable : tf2::TransformFailure);
    return future;
  }
  timer_of_wait_[request] = timer_interface_->createTimer(
      clock_, timeout, [this, request, promise, future, callback](const TimerHandle&) {
        if (end_wait(request)) {
          cancelTransformableRequest(request);
          promise->set_exception(
              std::make_exception_ptr(tf2::TimeoutException("Timed out waiting for transform")));
          callback(future);
        }
      });
  return future;
}

void Buffer::cancel(const TransformStampedFuture& ts_future) {
  cancelTransformableRequest(ts_future.getHandle());
  end_wait(ts_future.getHandle());
}

rclcpp::Logger Buffer::getLogger() const {
  return node_logging_interface_ ? node_logging_interface_->get_logger()
                                 : rclcpp::get_logger("tf2_buffer");
}

}  // namespace tf2_ros
