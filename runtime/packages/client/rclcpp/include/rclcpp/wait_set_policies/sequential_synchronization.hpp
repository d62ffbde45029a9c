// The wait set is used by one thread at a time.
#pragma once

namespace rclcpp {
namespace wait_set_policies {

class SequentialSynchronization {};

}  // namespace wait_set_policies
}  // namespace rclcpp
