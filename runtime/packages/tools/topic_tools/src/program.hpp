// Shared by the programs: words of the command line become parameters of a node, which is spun.
#pragma once

#include <memory>
#include <optional>
#include <rclcpp/rclcpp.hpp>
#include <stdexcept>
#include <string>
#include <vector>

namespace topic_tools {

/// The words of the command line that are not for ROS; the first one is the program.
using Words = std::vector<std::string>;

/// Throws std::invalid_argument with a text for a person.
inline double number(const std::string& word, const char* what) {
  size_t read = 0;
  double result = 0;
  try {
    result = std::stod(word, &read);
  } catch (const std::exception&) {
    read = 0;
  }
  if (read == 0 || read != word.size()) {
    throw std::invalid_argument(std::string(what) + " must be a number: '" + word + "'");
  }
  return result;
}

/// As above; the number has no fraction.
inline int whole_number(const std::string& word, const char* what) {
  const double result = number(word, what);
  if (result != static_cast<int>(result)) {
    throw std::invalid_argument(std::string(what) + " must be a whole number: '" + word + "'");
  }
  return static_cast<int>(result);
}

/// Runs the node; `read` puts the words into its options and returns false when a word is missing.
/// `if_missing` is the exit code then.
template <typename NodeT, typename ReadT>
int run(int argc, char** argv, int if_missing, ReadT read) {
  const Words words = rclcpp::init_and_remove_ros_arguments(argc, argv);
  rclcpp::NodeOptions options;
  try {
    if (!read(words, options)) return if_missing;
  } catch (const std::invalid_argument& error) {
    RCLCPP_ERROR(rclcpp::get_logger("topic_tools"), "%s", error.what());
    return 1;
  }
  rclcpp::spin(std::make_shared<NodeT>(options));
  rclcpp::shutdown();
  return 0;
}

}  // namespace topic_tools
