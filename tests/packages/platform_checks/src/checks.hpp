// Counts checks; a program of this package logs one line when all of them held.
#pragma once

#include <cstdlib>
#include <functional>
#include <string>

#include "rclcpp/rclcpp.hpp"

class Checks {
 public:
  explicit Checks(const std::string& subject) : logger_(rclcpp::get_logger(subject)) {}

  void that(bool holds, const char* text, int line) {
    ++count_;
    if (!holds) {
      ++failed_;
      RCLCPP_ERROR(logger_, "line %d: %s does not hold", line, text);
    }
  }
  template <typename ErrorT>
  void throws(const std::function<void()>& action, const char* text, int line) {
    try {
      action();
    } catch (const ErrorT&) {
      that(true, text, line);
      return;
    } catch (const std::exception& error) {
      RCLCPP_ERROR(logger_, "line %d: threw %s", line, error.what());
    }
    that(false, text, line);
  }
  int finish() {
    if (failed_ == 0) {
      RCLCPP_INFO(logger_, "all %d checks hold", count_);
    }
    rclcpp::shutdown();
    return failed_ == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
  }

 private:
  rclcpp::Logger logger_;
  int count_ = 0;
  int failed_ = 0;
};

#define CHECK(CONDITION) checks.that((CONDITION), #CONDITION, __LINE__)
#define CHECK_THROWS(ERROR, ...) \
  checks.throws<ERROR>([&] { __VA_ARGS__; }, #ERROR " by " #__VA_ARGS__, __LINE__)
