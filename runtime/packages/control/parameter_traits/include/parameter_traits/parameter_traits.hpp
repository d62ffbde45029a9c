// The checks of rsl under the names that they had before: user code that was written for older
// versions of generate_parameter_library includes this.
#pragma once

#include <fmt/core.h>

#include <string>
#include <utility>

#include "rclcpp/rclcpp.hpp"
#include "rsl/parameter_validators.hpp"
#include "tl/expected.hpp"

namespace parameter_traits {

using Result = tl::expected<void, std::string>;

inline const Result OK{};

/// A reason for refusing a value, formatted as by fmt::format.
template <typename... Args>
[[nodiscard]] Result ERROR(const std::string& format, Args&&... args) {
  return tl::make_unexpected(fmt::format(fmt::runtime(format), std::forward<Args>(args)...));
}

using rsl::bounds;
using rsl::contains;
using rsl::element_bounds;
using rsl::fixed_size;
using rsl::gt;
using rsl::gt_eq;
using rsl::is_unique;
using rsl::lower_bounds;
using rsl::lower_element_bounds;
using rsl::lt;
using rsl::lt_eq;
using rsl::not_empty;
using rsl::one_of;
using rsl::size_gt;
using rsl::size_lt;
using rsl::subset_of;
using rsl::unique;
using rsl::upper_bounds;
using rsl::upper_element_bounds;

}  // namespace parameter_traits
