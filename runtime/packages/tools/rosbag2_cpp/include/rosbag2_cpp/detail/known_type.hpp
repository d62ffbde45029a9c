// The message types whose definitions this program can write into bags.
#pragma once

#include <string>

#include "rclcpp/detail/message_type.hpp"
#include "ros2wasm_typesupport/type_info.hpp"

namespace rosbag2_cpp {
namespace detail {

/// Ignores null, which a type has that is known by its name only.
void know_type(const ros2wasm_typesupport::TypeInfo* info);
/// Searches those, and the types that the program's nodes publish and subscribe to. Null: unknown.
const ros2wasm_typesupport::TypeInfo* find_known_type(const std::string& name);

/// Known from the program's start, as a topic may be created before its first message.
template <typename MessageT>
struct KnownType {
  static inline const bool is_known =
      (know_type(rclcpp::detail::callbacks_of(rclcpp::detail::type_support_of<MessageT>()).info),
       true);
};

}  // namespace detail
}  // namespace rosbag2_cpp
