// How often each kind of log macro logs.

// Compatibility, works: the log macros ONCE, EXPRESSION, FUNCTION, SKIPFIRST, THROTTLE,
// SKIPFIRST_THROTTLE and their STREAM forms; a std::string as the format, as in ROS 2 Foxy;
// `bits/stdc++.h` and other inner headers of GCC's library that editors write into programs

#include <bits/shared_ptr.h>
#include <bits/stdc++.h>

#include "checks.hpp"
#include "rcutils/logging.h"

namespace {

std::vector<std::string> lines;
rcutils_logging_output_handler_t console = nullptr;

void note(const rcutils_log_location_t* location, int severity, const char* name,
          rcutils_time_point_value_t timestamp, const char* format, va_list* args) {
  if (std::string(name) != "noted") {
    console(location, severity, name, timestamp, format, args);
    return;
  }
  char text[64];
  vsnprintf(text, sizeof(text), format, *args);
  lines.emplace_back(text);
}

bool yes() {
  return true;
}

}  // namespace

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  Checks checks("log_macros");
  console = rcutils_logging_get_output_handler();
  rcutils_logging_set_output_handler(note);
  const auto logger = rclcpp::get_logger("noted");
  rclcpp::Clock clock(RCL_STEADY_TIME);
  const auto count = [](const std::string& text) {
    size_t found = 0;
    for (const std::string& line : lines) {
      found += line == text ? 1 : 0;
    }
    return found;
  };
  const std::string text = "text of %d";
  RCLCPP_WARN(logger, text, 3);
  RCLCPP_INFO(logger, std::to_string(7));
  for (int i = 0; i < 3; ++i) {
    RCLCPP_INFO_ONCE(logger, "once");
    RCLCPP_WARN_STREAM_ONCE(logger, "stream "
                                        << "once");
    RCLCPP_INFO_EXPRESSION(logger, i > 0, "expression");
    RCLCPP_ERROR_STREAM_EXPRESSION(logger, i > 1,
                                   "stream "
                                       << "expression");
    RCLCPP_INFO_FUNCTION(logger, &yes, "function");
    RCLCPP_INFO_STREAM_FUNCTION(logger, &yes,
                                "stream "
                                    << "function");
    RCLCPP_INFO_SKIPFIRST(logger, "skipfirst");
    RCLCPP_FATAL_STREAM_SKIPFIRST(logger, "stream "
                                              << "skipfirst");
    RCLCPP_INFO_THROTTLE(logger, clock, 60000, "throttle");
    RCLCPP_INFO_STREAM_THROTTLE(logger, clock, 60000,
                                "stream "
                                    << "throttle");
    RCLCPP_INFO_SKIPFIRST_THROTTLE(logger, clock, 60000, "skipfirst throttle");
    RCLCPP_INFO_STREAM_SKIPFIRST_THROTTLE(logger, clock, 60000,
                                          "stream "
                                              << "skipfirst throttle");
    RCLCPP_DEBUG(logger, "debug");
    RCLCPP_INFO_STREAM_THROTTLE(logger, clock, 0, "each " << i);
  }
  CHECK(std::accumulate(lines.begin(), lines.end(), std::size_t{0},
                        [](std::size_t sum, const auto& line) { return sum + line.size(); }) > 0);
  CHECK(count("text of 3") == 1);
  CHECK(count("7") == 1);
  CHECK(count("once") == 1);
  CHECK(count("stream once") == 1);
  CHECK(count("expression") == 2);
  CHECK(count("stream expression") == 1);
  CHECK(count("function") == 3);
  CHECK(count("stream function") == 3);
  CHECK(count("skipfirst") == 2);
  CHECK(count("stream skipfirst") == 2);
  CHECK(count("throttle") == 1);
  CHECK(count("stream throttle") == 1);
  CHECK(count("skipfirst throttle") <= 1);
  CHECK(count("debug") == 0);
  CHECK(count("each 0") == 1);
  rcutils_logging_set_output_handler(console);
  return checks.finish();
}
