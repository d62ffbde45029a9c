// Which parts of a subscription a wait set looks at.
#pragma once

namespace rclcpp {

struct SubscriptionWaitSetMask {
  bool include_subscription = true;
  bool include_events = true;
  bool include_intra_process_waitable = true;
};

}  // namespace rclcpp
