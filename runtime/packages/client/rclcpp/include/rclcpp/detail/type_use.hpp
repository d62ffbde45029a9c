// Which interface types a node uses just now, so that it can tell of them.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "ros2wasm_typesupport/type_info.hpp"

namespace rclcpp {
namespace detail {

/// Node `node_id` uses the type for as long as the handle lives. Nothing for a type of which
/// nothing is known (null).
std::shared_ptr<void> use_type(int32_t node_id, const char* type_hash,
                               const ros2wasm_typesupport::TypeInfo* info);
/// Null when the node does not use the type with that hash.
const ros2wasm_typesupport::TypeInfo* find_used_type(int32_t node_id, const std::string& type_hash);
/// By its name; null when no node of the program uses it.
const ros2wasm_typesupport::TypeInfo* find_used_type(const std::string& type_name);

}  // namespace detail
}  // namespace rclcpp
