// A filter over a topic's messages, in the words of DDS: `data > %0 AND header.frame_id = 'map'`.
#pragma once

#include <string>
#include <vector>

namespace rclcpp {

struct ContentFilterOptions {
  std::string filter_expression;
  std::vector<std::string> expression_parameters;
};

}  // namespace rclcpp
