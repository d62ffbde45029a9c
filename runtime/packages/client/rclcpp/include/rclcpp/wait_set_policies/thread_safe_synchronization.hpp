// Other threads may add and remove entities while one waits.
#pragma once

namespace rclcpp {
namespace wait_set_policies {

class ThreadSafeSynchronization {};

}  // namespace wait_set_policies
}  // namespace rclcpp
