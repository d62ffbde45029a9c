// How messages wait inside the process.
#pragma once

namespace rclcpp {

enum class IntraProcessBufferType { SharedPtr, UniquePtr, CallbackDefault };

}  // namespace rclcpp
