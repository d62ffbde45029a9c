// How a wait on a wait set ended.
#pragma once

namespace rclcpp {

enum WaitResultKind {
  Ready,    // something is ready
  Timeout,  // the time is over
  Empty,    // there is nothing to wait for
  Invalid,  // the wait set was changed while the result was held
};

}  // namespace rclcpp
