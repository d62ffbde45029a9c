// See buffer_server.hpp.
#include "tf2_ros/buffer_server.hpp"

#include <algorithm>

#include "tf2/exceptions.hpp"
#include "tf2_ros/buffer_interface.hpp"

namespace tf2_ros {

bool BufferServer::can_transform(const LookupTransformAction::Goal& goal) const {
  const tf2::TimePoint source_time = fromMsg(goal.source_time);
  return goal.advanced
             ? buffer_.canTransform(goal.target_frame, fromMsg(goal.target_time), goal.source_frame,
                                    source_time, goal.fixed_frame, nullptr)
             : buffer_.canTransform(goal.target_frame, goal.source_frame, source_time, nullptr);
}

tf2_msgs::action::LookupTransform::Result::SharedPtr BufferServer::look_up(
    const LookupTransformAction::Goal& goal) const {
  using Error = tf2_msgs::msg::TF2Error;
  auto result = std::make_shared<LookupTransformAction::Result>();
  const auto fail = [&result](uint8_t error, const tf2::TransformException& why) {
    result->error.error = error;
    result->error.error_string = why.what();
  };
  const tf2::TimePoint source_time = fromMsg(goal.source_time);
  try {
    result->transform =
        goal.advanced ? buffer_.lookupTransform(goal.target_frame, fromMsg(goal.target_time),
                                                goal.source_frame, source_time, goal.fixed_frame)
                      : buffer_.lookupTransform(goal.target_frame, goal.source_frame, source_time);
  } catch (const tf2::ConnectivityException& why) {
    fail(Error::CONNECTIVITY_ERROR, why);
  } catch (const tf2::LookupException& why) {
    fail(Error::LOOKUP_ERROR, why);
  } catch (const tf2::ExtrapolationException& why) {
    fail(Error::EXTRAPOLATION_ERROR, why);
  } catch (const tf2::InvalidArgumentException& why) {
    fail(Error::INVALID_ARGUMENT_ERROR, why);
  } catch (const tf2::TimeoutException& why) {
    fail(Error::TIMEOUT_ERROR, why);
  } catch (const tf2::TransformException& why) {
    fail(Error::TRANSFORM_ERROR, why);
  }
  return result;
}

void BufferServer::on_accepted(const GoalHandle& handle) {
  const auto goal = handle->get_goal();
  const tf2::TimePoint end_time = tf2::get_now() + fromMsg(goal->timeout);
  if (can_transform(*goal) || end_time <= tf2::get_now()) {
    RCLCPP_DEBUG(logger_, "Transform available immediately for new goal");
    handle->succeed(look_up(*goal));
    return;
  }
  const std::lock_guard<std::mutex> lock(mutex_);
  active_goals_.push_back({handle, end_time});
}

rclcpp_action::CancelResponse BufferServer::on_cancel(const GoalHandle& handle) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto found = std::find_if(active_goals_.begin(), active_goals_.end(),
                                  [&](const GoalInfo& info) { return info.handle == handle; });
  // One that is not there has ended. Whoever accepts a cancel ends the goal at the next look: it
  // must first be canceling.
  if (found == active_goals_.end()) {
    return rclcpp_action::CancelResponse::REJECT;
  }
  return rclcpp_action::CancelResponse::ACCEPT;
}

void BufferServer::check_transforms() {
  const std::lock_guard<std::mutex> lock(mutex_);
  active_goals_.remove_if([this](const GoalInfo& info) {
    const auto goal = info.handle->get_goal();
    if (info.handle->is_canceling()) {
      info.handle->canceled(std::make_shared<LookupTransformAction::Result>());
    } else if (can_transform(*goal)) {
      const auto result = look_up(*goal);
      if (result->error.error == tf2_msgs::msg::TF2Error::NO_ERROR) {
        info.handle->succeed(result);
      } else {
        info.handle->abort(result);
      }
    } else if (info.end_time < tf2::get_now()) {
      info.handle->abort(std::make_shared<LookupTransformAction::Result>());
    }
    return !info.handle->is_active();
  });
}

}  // namespace tf2_ros
