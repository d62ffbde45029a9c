// Allocators of one type made into those of another.
#pragma once

#include <memory>

#include "rclcpp/allocator/allocator_deleter.hpp"

namespace rclcpp {
namespace allocator {

template <typename T, typename Alloc>
using AllocRebind = typename std::allocator_traits<Alloc>::template rebind_traits<T>;

}  // namespace allocator
}  // namespace rclcpp
