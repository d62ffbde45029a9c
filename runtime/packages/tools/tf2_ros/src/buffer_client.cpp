// See buffer_client.hpp.
#include "tf2_ros/buffer_client.hpp"

#include <chrono>
#include <future>

#include "rclcpp/utilities.hpp"
#include "tf2/exceptions.hpp"

namespace tf2_ros {
namespace {

using Goal = tf2_msgs::action::LookupTransform::Goal;

Goal simple_goal(const std::string& target_frame, const std::string& source_frame,
                 const tf2::TimePoint& time, tf2::Duration timeout) {
  Goal goal;
  goal.target_frame = target_frame;
  goal.source_frame = source_frame;
  goal.source_time = toMsg(time);
  goal.timeout = toMsg(timeout);
  return goal;
}

Goal advanced_goal(const std::string& target_frame, const tf2::TimePoint& target_time,
                   const std::string& source_frame, const tf2::TimePoint& source_time,
                   const std::string& fixed_frame, tf2::Duration timeout) {
  Goal goal = simple_goal(target_frame, source_frame, source_time, timeout);
  goal.target_time = toMsg(target_time);
  goal.fixed_frame = fixed_frame;
  goal.advanced = true;
  return goal;
}

[[noreturn]] void throw_error(const tf2_msgs::msg::TF2Error& error) {
  using Error = tf2_msgs::msg::TF2Error;
  switch (error.error) {
    case Error::LOOKUP_ERROR:
      throw tf2::LookupException(error.error_string);
    case Error::CONNECTIVITY_ERROR:
      throw tf2::ConnectivityException(error.error_string);
    case Error::EXTRAPOLATION_ERROR:
      throw tf2::ExtrapolationException(error.error_string);
    case Error::INVALID_ARGUMENT_ERROR:
      throw tf2::InvalidArgumentException(error.error_string);
    case Error::TIMEOUT_ERROR:
      throw tf2::TimeoutException(error.error_string);
    default:
      throw tf2::TransformException(error.error_string);
  }
}

template <class FutureT>
bool comes_in_time(const FutureT& future, std::chrono::milliseconds period, tf2::TimePoint end) {
  while (rclcpp::ok() && tf2::get_now() <= end) {
    if (future.wait_for(period) == std::future_status::ready) return true;
  }
  return false;
}

template <class LookupT>
bool can(const LookupT& look_up, std::string* errstr) {
  const auto tell = [errstr](const std::exception& why) {
    if (errstr != nullptr) *errstr = why.what();
    return false;
  };
  try {
    look_up();
    return true;
  } catch (const tf2::TransformException& why) {
    return tell(why);
  } catch (const LookupTransformGoalException& why) {
    return tell(why);
  }
}

}  // namespace

geometry_msgs::msg::TransformStamped BufferClient::ask(const Goal& goal) const {
  const tf2::Duration timeout = fromMsg(goal.timeout);
  if (!client_->wait_for_action_server(timeout)) {
    throw tf2::ConnectivityException("Failed find available action server");
  }
  const std::chrono::milliseconds period(static_cast<int64_t>(1000 / check_frequency_));
  const auto handle = client_->async_send_goal(goal);
  if (!comes_in_time(handle, period, tf2::get_now() + timeout + timeout_padding_)) {
    throw tf2::TimeoutException(
        "Did not receive the goal response for the goal sent to the action server. Something is "
        "likely wrong with the server.");
  }
  if (handle.get() == nullptr) {
    throw GoalRejectedException("Goal rejected by action server");
  }
  const auto answer = client_->async_get_result(handle.get());
  if (!comes_in_time(answer, period, tf2::get_now() + timeout + timeout_padding_)) {
    throw tf2::TimeoutException(
        "Did not receive the result for the goal sent to the action server. Something is likely "
        "wrong with the server.");
  }
  switch (answer.get().code) {
    case rclcpp_action::ResultCode::SUCCEEDED:
      break;
    case rclcpp_action::ResultCode::ABORTED:
      throw GoalAbortedException("LookupTransform action was aborted");
    case rclcpp_action::ResultCode::CANCELED:
      throw GoalCanceledException("LookupTransform action was canceled");
    default:
      throw UnexpectedResultCodeException("Unexpected result code returned from server");
  }
  const auto& result = *answer.get().result;
  if (result.error.error != tf2_msgs::msg::TF2Error::NO_ERROR) {
    throw_error(result.error);
  }
  return result.transform;
}

geometry_msgs::msg::TransformStamped BufferClient::lookupTransform(
    const std::string& target_frame, const std::string& source_frame, const tf2::TimePoint& time,
    const tf2::Duration timeout) const {
  return ask(simple_goal(target_frame, source_frame, time, timeout));
}

geometry_msgs::msg::TransformStamped BufferClient::lookupTransform(
    const std::string& target_frame, const tf2::TimePoint& target_time,
    const std::string& source_frame, const tf2::TimePoint& source_time,
    const std::string& fixed_frame, const tf2::Duration timeout) const {
  return ask(
      advanced_goal(target_frame, target_time, source_frame, source_time, fixed_frame, timeout));
}

bool BufferClient::canTransform(const std::string& target_frame, const std::string& source_frame,
                                const tf2::TimePoint& time, const tf2::Duration timeout,
                                std::string* errstr) const {
  return can([&] { lookupTransform(target_frame, source_frame, time, timeout); }, errstr);
}

bool BufferClient::canTransform(const std::string& target_frame, const tf2::TimePoint& target_time,
                                const std::string& source_frame, const tf2::TimePoint& source_time,
                                const std::string& fixed_frame, const tf2::Duration timeout,
                                std::string* errstr) const {
  return can(
      [&] {
        lookupTransform(target_frame, target_time, source_frame, source_time, fixed_frame, timeout);
      },
      errstr);
}

}  // namespace tf2_ros
