// How a wait for a future ended.
#pragma once

#include <iosfwd>
#include <string>

namespace rclcpp {

enum class FutureReturnCode { SUCCESS, INTERRUPTED, TIMEOUT };

std::ostream& operator<<(std::ostream& os, const FutureReturnCode& future_return_code);
/// "SUCCESS (0)" and the like.
std::string to_string(const FutureReturnCode& future_return_code);

}  // namespace rclcpp
