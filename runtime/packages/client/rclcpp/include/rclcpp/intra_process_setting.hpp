// Whether messages go by pointer inside the process.
#pragma once

namespace rclcpp {

enum class IntraProcessSetting { Enable, Disable, NodeDefault };

}  // namespace rclcpp
