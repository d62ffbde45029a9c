// One piece of work that an executor chose.
#pragma once

#include <atomic>
#include <memory>

#include "rclcpp/callback_group.hpp"
#include "rclcpp/detail/executable.hpp"

namespace rclcpp {

/// While it lives, a mutually exclusive group runs nothing else.
struct AnyExecutable {
  AnyExecutable() = default;
  AnyExecutable(const AnyExecutable&) = delete;
  AnyExecutable& operator=(const AnyExecutable&) = delete;
  ~AnyExecutable();

  std::shared_ptr<detail::Executable> entity;
  std::shared_ptr<void> data;
  rclcpp::CallbackGroup::SharedPtr callback_group;
  /// How many threads look for work of the same executor; they are told when the group is free.
  const std::atomic<int>* seekers = nullptr;
};

}  // namespace rclcpp
