// A filter over a topic's messages, in SQL-like words. The bus has none: is_cft_enabled() is false.
#pragma once

#include <string>
#include <vector>

namespace rclcpp {

struct ContentFilterOptions {
  std::string filter_expression;
  std::vector<std::string> expression_parameters;
};

}  // namespace rclcpp
