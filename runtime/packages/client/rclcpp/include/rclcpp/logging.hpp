// The logging macros: RCLCPP_<SEVERITY>[_STREAM][_ONCE|...](logger, ...), on those of rcutils.
#pragma once

#include <sstream>
#include <type_traits>

#include "rclcpp/logger.hpp"
#include "rclcpp/utilities.hpp"
#include "rcutils/logging_macros.h"

#define RCLCPP_LOG_MIN_SEVERITY_DEBUG 0
#define RCLCPP_LOG_MIN_SEVERITY_INFO 1
#define RCLCPP_LOG_MIN_SEVERITY_WARN 2
#define RCLCPP_LOG_MIN_SEVERITY_ERROR 3
#define RCLCPP_LOG_MIN_SEVERITY_FATAL 4
#define RCLCPP_LOG_MIN_SEVERITY_NONE 5

#define RCLCPP_FIRST_ARG(N, ...) N
#define RCLCPP_ALL_BUT_FIRST_ARGS(N, ...) __VA_ARGS__

// Define RCLCPP_LOG_MIN_SEVERITY to compile out what is less severe.
#ifndef RCLCPP_LOG_MIN_SEVERITY
#define RCLCPP_LOG_MIN_SEVERITY RCLCPP_LOG_MIN_SEVERITY_DEBUG
#endif

#define RCLCPP_LOG_REQUIRE_LOGGER_(logger)                                                         \
  static_assert(::std::is_same<                                                                    \
                    typename std::remove_cv_t<typename std::remove_reference_t<decltype(logger)>>, \
                    typename ::rclcpp::Logger>::value,                                             \
                "First argument to logging macros must be an rclcpp::Logger")

#define RCLCPP_LOG_TIME_OF_(clock)                                                 \
  auto rclcpp_time_point_ = [&c = clock](rcutils_time_point_value_t* time_point) { \
    try {                                                                          \
      *time_point = c.now().nanoseconds();                                         \
    } catch (...) {                                                                \
      return RCUTILS_RET_ERROR;                                                    \
    }                                                                              \
    return RCUTILS_RET_OK;                                                         \
  }

#if RCLCPP_LOG_MIN_SEVERITY > RCLCPP_LOG_MIN_SEVERITY_DEBUG
#define RCLCPP_DEBUG(...)
#define RCLCPP_DEBUG_STREAM(...)
#define RCLCPP_DEBUG_ONCE(...)
#define RCLCPP_DEBUG_STREAM_ONCE(...)
#define RCLCPP_DEBUG_EXPRESSION(...)
#define RCLCPP_DEBUG_STREAM_EXPRESSION(...)
#define RCLCPP_DEBUG_FUNCTION(...)
#define RCLCPP_DEBUG_STREAM_FUNCTION(...)
#define RCLCPP_DEBUG_SKIPFIRST(...)
#define RCLCPP_DEBUG_STREAM_SKIPFIRST(...)
#define RCLCPP_DEBUG_THROTTLE(...)
#define RCLCPP_DEBUG_STREAM_THROTTLE(...)
#define RCLCPP_DEBUG_SKIPFIRST_THROTTLE(...)
#define RCLCPP_DEBUG_STREAM_SKIPFIRST_THROTTLE(...)
#else
#define RCLCPP_DEBUG(logger, ...)                              \
  do {                                                         \
    RCLCPP_LOG_REQUIRE_LOGGER_(logger);                        \
    RCUTILS_LOG_DEBUG_NAMED((logger).get_name(), __VA_ARGS__); \
  } while (0)
#define RCLCPP_DEBUG_STREAM(logger, stream_arg)                                          \
  do {                                                                                   \
    RCLCPP_LOG_REQUIRE_LOGGER_(logger);                                                  \
    std::stringstream rclcpp_stream_ss_;                                                 \
    rclcpp_stream_ss_ << stream_arg;                                                     \
    RCUTILS_LOG_DEBUG_NAMED((logger).get_name(), "%s", rclcpp_stream_ss_.str().c_str()); \
  } while (0)
#define RCLCPP_DEBUG_ONCE(logger, ...)                              \
  do {                                                              \
    RCLCPP_LOG_REQUIRE_LOGGER_(logger);                             \
    RCUTILS_LOG_DEBUG_ONCE_NAMED((logger).get_name(), __VA_ARGS__); \
  } while (0)
#define RCLCPP_DEBUG_STREAM_ONCE(logger, stream_arg)                                          \
  do {                                                                                        \
    RCLCPP_LOG_REQUIRE_LOGGER_(logger);                                                       \
    std::stringstream rclcpp_stream_ss_;                                                      \
    rclcpp_stream_ss_ << stream_arg;                                                          \
    RCUTILS_LOG_DEBUG_ONCE_NAMED((logger).get_name(), "%s", rclcpp_stream_ss_.str().c_str()); \
  } while (0)
#define RCLCPP_DEBUG_EXPRESSION(logger, expression, ...)                              \
  do {                                                                                \
    RCLCPP_LOG_REQUIRE_LOGGER_(logger);                                               \
    RCUTILS_LOG_DEBUG_EXPRESSION_NAMED(expression, (logger).get_name(), __VA_ARGS__); \
  } while (0)
#define RCLCPP_DEBUG_STREAM_EXPRESSION(logger, expression, stream_arg)        \
  do {                                                                        \
    RCLCPP_LOG_REQUIRE_LOGGER_(logger);                                       \
    std::stringstream rclcpp_stream_ss_;                                      \
    rclcpp_stream_ss_ << stream_arg;                                          \
    RCUTILS_LOG_DEBUG_EXPRESSION_NAMED(expression, (logger).get_name(), "%s", \
                                       rclcpp_stream_ss_.str().c_str());      \
  } while (0)
#define RCLCPP_DEBUG_FUNCTION(logger, function, ...)                              \
  do {                                                                            \
    RCLCPP_LOG_REQUIRE_LOGGER_(logger);                                           \
    RCUTILS_LOG_DEBUG_FUNCTION_NAMED(function, (logger).get_name(), __VA_ARGS__); \
  } while (0)
#define RCLCPP_DEBUG_STREAM_FUNCTION(logger, function, stream_arg)        \
  do {                                                                    \
    RCLCPP_LOG_REQUIRE_LOGGER_(logger);                                   \
    std::stringstream rclcpp_stream_ss_;                                  \
    rclcpp_stream_ss_ << stream_arg;                                      \
    RCUTILS_LOG_DEBUG_FUNCTION_NAMED(function, (logger).get_name(), "%s", \
                                     rclcpp_stream_ss_.str().c_str());    \
  } while (0)
#define RCLCPP_DEBUG_SKIPFIRST(logger, ...)                              \
  do {                                                                   \
    RCLCPP_LOG_REQUIRE_LOGGER_(logger);                                  \
    RCUTILS_LOG_DEBUG_SKIPFIRST_NAMED((logger).get_name(), __VA_ARGS__); \
  } while (0)
#define RCLCPP_DEBUG_STREAM_SKIPFIRST(logger, stream_arg)                                          \
  do {                                                                                             \
    RCLCPP_LOG_REQUIRE_LOGGER_(logger);                                                            \
    std::stringstream rclcpp_stream_ss_;                                                           \
    rclcpp_stream_ss_ << stream_arg;                                                               \
    RCUTILS_LOG_DEBUG_SKIPFIRST_NAMED((logger).get_name(), "%s", rclcpp_stream_ss_.str().c_str()); \
  } while (0)
#define RCLCPP_DEBUG_THROTTLE(logger, clock, duration, ...)                             \
  do {                                                                                  \
    RCLCPP_LOG_REQUIRE_LOGGER_(logger);                                                 \
    RCLCPP_LOG_TIME_OF_(clock);                                                         \
    RCUTILS_LOG_DEBUG_THROTTLE_NAMED(rclcpp_time_point_, duration, (logger).get_name(), \
                                     __VA_ARGS__);                                      \
  } while (0)
#define RCLCPP_DEBUG_STREAM_THROTTLE(logger, clock, duration, stream_arg)                     \
  do {                                                                                        \
    RCLCPP_LOG_REQUIRE_LOGGER_(logger);                                                       \
    RCLCPP_LOG_TIME_OF_(clock);                                                               \
    std::stringstream rclcpp_stream_ss_;                                                      \
    rclcpp_stream_ss_ << stream_arg;                                                          \
    RCUTILS_LOG_DEBUG_THROTTLE_NAMED(rclcpp_time_point_, duration, (logger).get_name(), "%s", \
                                     rclcpp_stream_ss_.str().c_str());                        \
  } while (0)
#define RCLCPP_DEBUG_SKIPFIRST_THROTTLE(logger, clock, duration, ...)                             \
  do {                                                                                            \
    RCLCPP_LOG_REQUIRE_LOGGER_(logger);                                                           \
    RCLCPP_LOG_TIME_OF_(clock);                                                                   \
    RCUTILS_LOG_DEBUG_SKIPFIRST_THROTTLE_NAMED(rclcpp_time_point_, duration, (logger).get_name(), \
                                               __VA_ARGS__);                                      \
  } while (0)
#define RCLCPP_DEBUG_STREAM_SKIPFIRST_THROTTLE(logger, clock, duration, stream_arg)               \
  do {                                                                                            \
    RCLCPP_LOG_REQUIRE_LOGGER_(logger);                                                           \
    RCLCPP_LOG_TIME_OF_(clock);                                                                   \
    std::stringstream rclcpp_stream_ss_;                                                          \
    rclcpp_stream_ss_ << stream_arg;                                                              \
    RCUTILS_LOG_DEBUG_SKIPFIRST_THROTTLE_NAMED(rclcpp_time_point_, duration, (logger).get_name(), \
                                               "%s", rclcpp_stream_ss_.str().c_str());            \
  } while (0)
#endif

#if RCLCPP_LOG_MIN_SEVERITY > RCLCPP_LOG_MIN_SEVERITY_INFO
#define RCLCPP_INFO(...)
#define RCLCPP_INFO_STREAM(...)
#define RCLCPP_INFO_ONCE(...)
#define RCLCPP_INFO_STREAM_ONCE(...)
#define RCLCPP_INFO_EXPRESSION(...)
#define RCLCPP_INFO_STREAM_EXPRESSION(...)
#define RCLCPP_INFO_FUNCTION(...)
#define RCLCPP_INFO_STREAM_FUNCTION(...)
#define RCLCPP_INFO_SKIPFIRST(...)
#define RCLCPP_INFO_STREAM_SKIPFIRST(...)
#define RCLCPP_INFO_THROTTLE(...)
#define RCLCPP_INFO_STREAM_THROTTLE(...)
#define RCLCPP_INFO_SKIPFIRST_THROTTLE(...)
#define RCLCPP_INFO_STREAM_SKIPFIRST_THROTTLE(...)
#else
#define RCLCPP_INFO(logger, ...)                              \
  do {                                                        \
    RCLCPP_LOG_REQUIRE_LOGGER_(logger);                       \
    RCUTILS_LOG_INFO_NAMED((logger).get_name(), __VA_ARGS__); \
  } while (0)
#define RCLCPP_INFO_STREAM(logger, stream_arg)                                          \
  do {                                                                                  \
    RCLCPP_LOG_REQUIRE_LOGGER_(logger);                                                 \
    std::stringstream rclcpp_stream_ss_;                                                \
    rclcpp_stream_ss_ << stream_arg;                                                    \
    RCUTILS_LOG_INFO_NAMED((logger).get_name(), "%s", rclcpp_stream_ss_.str().c_str()); \
  } while (0)
#define RCLCPP_INFO_ONCE(logger, ...)                              \
  do {                                                             \
    RCLCPP_LOG_REQUIRE_LOGGER_(logger);                            \
    RCUTILS_LOG_INFO_ONCE_NAMED((logger).get_name(), __VA_ARGS__); \
  } while (0)
#define RCLCPP_INFO_STREAM_ONCE(logger, stream_arg)                                          \
  do {                                                                                       \
    RCLCPP_LOG_REQUIRE_LOGGER_(logger);                                                      \
    std::stringstream rclcpp_stream_ss_;                                                     \
    rclcpp_stream_ss_ << stream_arg;                                                         \
    RCUTILS_LOG_INFO_ONCE_NAMED((logger).get_name(), "%s", rclcpp_stream_ss_.str().c_str()); \
  } while (0)
#define RCLCPP_INFO_EXPRESSION(logger, expression, ...)                              \
  do {                                                                               \
    RCLCPP_LOG_REQUIRE_LOGGER_(logger);                                              \
    RCUTILS_LOG_INFO_EXPRESSION_NAMED(expression, (logger).get_name(), __VA_ARGS__); \
  } while (0)
#define RCLCPP_INFO_STREAM_EXPRESSION(logger, expression, stream_arg)        \
  do {                                                                       \
    RCLCPP_LOG_REQUIRE_LOGGER_(logger);                                      \
    std::stringstream rclcpp_stream_ss_;                                     \
    rclcpp_stream_ss_ << stream_arg;                                         \
    RCUTILS_LOG_INFO_EXPRESSION_NAMED(expression, (logger).get_name(), "%s", \
                                      rclcpp_stream_ss_.str().c_str());      \
  } while (0)
#define RCLCPP_INFO_FUNCTION(logger, function, ...)                              \
  do {                                                                           \
    RCLCPP_LOG_REQUIRE_LOGGER_(logger);                                          \
    RCUTILS_LOG_INFO_FUNCTION_NAMED(function, (logger).get_name(), __VA_ARGS__); \
  } while (0)
#define RCLCPP_INFO_STREAM_FUNCTION(logger, function, stream_arg)        \
  do {                                                                   \
    RCLCPP_LOG_REQUIRE_LOGGER_(logger);                                  \
    std::stringstream rclcpp_stream_ss_;                                 \
    rclcpp_stream_ss_ << stream_arg;                                     \
    RCUTILS_LOG_INFO_FUNCTION_NAMED(function, (logger).get_name(), "%s", \
                                    rclcpp_stream_ss_.str().c_str());    \
  } while (0)
#define RCLCPP_INFO_SKIPFIRST(logger, ...)                              \
  do {                                                                  \
    RCLCPP_LOG_REQUIRE_LOGGER_(logger);                                 \
    RCUTILS_LOG_INFO_SKIPFIRST_NAMED((logger).get_name(), __VA_ARGS__); \
  } while (0)
#define RCLCPP_INFO_STREAM_SKIPFIRST(logger, stream_arg)                                          \
  do {                                                                                            \
    RCLCPP_LOG_REQUIRE_LOGGER_(logger);                                                           \
    std::stringstream rclcpp_stream_ss_;                                                          \
    rclcpp_stream_ss_ << stream_arg;                                                              \
    RCUTILS_LOG_INFO_SKIPFIRST_NAMED((logger).get_name(), "%s", rclcpp_stream_ss_.str().c_str()); \
  } while (0)
#define RCLCPP_INFO_THROTTLE(logger, clock, duration, ...)                             \
  do {                                                                                 \
    RCLCPP_LOG_REQUIRE_LOGGER_(logger);                                                \
    RCLCPP_LOG_TIME_OF_(clock);                                                        \
    RCUTILS_LOG_INFO_THROTTLE_NAMED(rclcpp_time_point_, duration, (logger).get_name(), \
                                    __VA_ARGS__);                                      \
  } while (0)
#define RCLCPP_INFO_STREAM_THROTTLE(logger, clock, duration, stream_arg)                     \
  do {                                                                                       \
    RCLCPP_LOG_REQUIRE_LOGGER_(logger);                                                      \
    RCLCPP_LOG_TIME_OF_(clock);                                                              \
    std::stringstream rclcpp_stream_ss_;                                                     \
    rclcpp_stream_ss_ << stream_arg;                                                         \
    RCUTILS_LOG_INFO_THROTTLE_NAMED(rclcpp_time_point_, duration, (logger).get_name(), "%s", \
                                    rclcpp_stream_ss_.str().c_str());                        \
  } while (0)
#define RCLCPP_INFO_SKIPFIRST_THROTTLE(logger, clock, duration, ...)                             \
  do {                                                                                           \
    RCLCPP_LOG_REQUIRE_LOGGER_(logger);                                                          \
    RCLCPP_LOG_TIME_OF_(clock);                                                                  \
    RCUTILS_LOG_INFO_SKIPFIRST_THROTTLE_NAMED(rclcpp_time_point_, duration, (logger).get_name(), \
                                              __VA_ARGS__);                                      \
  } while (0)
#define RCLCPP_INFO_STREAM_SKIPFIRST_THROTTLE(logger, clock, duration, stream_arg)               \
  do {                                                                                           \
    RCLCPP_LOG_REQUIRE_LOGGER_(logger);                                                          \
    RCLCPP_LOG_TIME_OF_(clock);                                                                  \
    std::stringstream rclcpp_stream_ss_;                                                         \
    rclcpp_stream_ss_ << stream_arg;                                                             \
    RCUTILS_LOG_INFO_SKIPFIRST_THROTTLE_NAMED(rclcpp_time_point_, duration, (logger).get_name(), \
                                              "%s", rclcpp_stream_ss_.str().c_str());            \
  } while (0)
#endif

#if RCLCPP_LOG_MIN_SEVERITY > RCLCPP_LOG_MIN_SEVERITY_WARN
#define RCLCPP_WARN(...)
#define RCLCPP_WARN_STREAM(...)
#define RCLCPP_WARN_ONCE(...)
#define RCLCPP_WARN_STREAM_ONCE(...)
#define RCLCPP_WARN_EXPRESSION(...)
#define RCLCPP_WARN_STREAM_EXPRESSION(...)
#define RCLCPP_WARN_FUNCTION(...)
#define RCLCPP_WARN_STREAM_FUNCTION(...)
#define RCLCPP_WARN_SKIPFIRST(...)
#define RCLCPP_WARN_STREAM_SKIPFIRST(...)
#define RCLCPP_WARN_THROTTLE(...)
#define RCLCPP_WARN_STREAM_THROTTLE(...)
#define RCLCPP_WARN_SKIPFIRST_THROTTLE(...)
#define RCLCPP_WARN_STREAM_SKIPFIRST_THROTTLE(...)
#else
#define RCLCPP_WARN(logger, ...)                              \
  do {                                                        \
    RCLCPP_LOG_REQUIRE_LOGGER_(logger);                       \
    RCUTILS_LOG_WARN_NAMED((logger).get_name(), __VA_ARGS__); \
  } while (0)
#define RCLCPP_WARN_STREAM(logger, stream_arg)                                          \
  do {                                                                                  \
    RCLCPP_LOG_REQUIRE_LOGGER_(logger);                                                 \
    std::stringstream rclcpp_stream_ss_;                                                \
    rclcpp_stream_ss_ << stream_arg;                                                    \
    RCUTILS_LOG_WARN_NAMED((logger).get_name(), "%s", rclcpp_stream_ss_.str().c_str()); \
  } while (0)
#define RCLCPP_WARN_ONCE(logger, ...)                              \
  do {                                                             \
    RCLCPP_LOG_REQUIRE_LOGGER_(logger);                            \
    RCUTILS_LOG_WARN_ONCE_NAMED((logger).get_name(), __VA_ARGS__); \
  } while (0)
#define RCLCPP_WARN_STREAM_ONCE(logger, stream_arg)                                          \
  do {                                                                                       \
    RCLCPP_LOG_REQUIRE_LOGGER_(logger);                                                      \
    std::stringstream rclcpp_stream_ss_;                                                     \
    rclcpp_stream_ss_ << stream_arg;                                                         \
    RCUTILS_LOG_WARN_ONCE_NAMED((logger).get_name(), "%s", rclcpp_stream_ss_.str().c_str()); \
  } while (0)
#define RCLCPP_WARN_EXPRESSION(logger, expression, ...)                              \
  do {                                                                               \
    RCLCPP_LOG_REQUIRE_LOGGER_(logger);                                              \
    RCUTILS_LOG_WARN_EXPRESSION_NAMED(expression, (logger).get_name(), __VA_ARGS__); \
  } while (0)
#define RCLCPP_WARN_STREAM_EXPRESSION(logger, expression, stream_arg)        \
  do {                                                                       \
    RCLCPP_LOG_REQUIRE_LOGGER_(logger);                                      \
    std::stringstream rclcpp_stream_ss_;                                     \
    rclcpp_stream_ss_ << stream_arg;                                         \
    RCUTILS_LOG_WARN_EXPRESSION_NAMED(expression, (logger).get_name(), "%s", \
                                      rclcpp_stream_ss_.str().c_str());      \
  } while (0)
#define RCLCPP_WARN_FUNCTION(logger, function, ...)                              \
  do {                                                                           \
    RCLCPP_LOG_REQUIRE_LOGGER_(logger);                                          \
    RCUTILS_LOG_WARN_FUNCTION_NAMED(function, (logger).get_name(), __VA_ARGS__); \
  } while (0)
#define RCLCPP_WARN_STREAM_FUNCTION(logger, function, stream_arg)        \
  do {                                                                   \
    RCLCPP_LOG_REQUIRE_LOGGER_(logger);                                  \
    std::stringstream rclcpp_stream_ss_;                                 \
    rclcpp_stream_ss_ << stream_arg;                                     \
    RCUTILS_LOG_WARN_FUNCTION_NAMED(function, (logger).get_name(), "%s", \
                                    rclcpp_stream_ss_.str().c_str());    \
  } while (0)
#define RCLCPP_WARN_SKIPFIRST(logger, ...)                              \
  do {                                                                  \
    RCLCPP_LOG_REQUIRE_LOGGER_(logger);                                 \
    RCUTILS_LOG_WARN_SKIPFIRST_NAMED((logger).get_name(), __VA_ARGS__); \
  } while (0)
#define RCLCPP_WARN_STREAM_SKIPFIRST(logger, stream_arg)                                          \
  do {                                                                                            \
    RCLCPP_LOG_REQUIRE_LOGGER_(logger);                                                           \
    std::stringstream rclcpp_stream_ss_;                                                          \
    rclcpp_stream_ss_ << stream_arg;                                                              \
    RCUTILS_LOG_WARN_SKIPFIRST_NAMED((logger).get_name(), "%s", rclcpp_stream_ss_.str().c_str()); \
  } while (0)
#define RCLCPP_WARN_THROTTLE(logger, clock, duration, ...)                             \
  do {                                                                                 \
    RCLCPP_LOG_REQUIRE_LOGGER_(logger);                                                \
    RCLCPP_LOG_TIME_OF_(clock);                                                        \
    RCUTILS_LOG_WARN_THROTTLE_NAMED(rclcpp_time_point_, duration, (logger).get_name(), \
                                    __VA_ARGS__);                                      \
  } while (0)
#define RCLCPP_WARN_STREAM_THROTTLE(logger, clock, duration, stream_arg)                     \
  do {                                                                                       \
    RCLCPP_LOG_REQUIRE_LOGGER_(logger);                                                      \
    RCLCPP_LOG_TIME_OF_(clock);                                                              \
    std::stringstream rclcpp_stream_ss_;                                                     \
    rclcpp_stream_ss_ << stream_arg;                                                         \
    RCUTILS_LOG_WARN_THROTTLE_NAMED(rclcpp_time_point_, duration, (logger).get_name(), "%s", \
                                    rclcpp_stream_ss_.str().c_str());                        \
  } while (0)
#define RCLCPP_WARN_SKIPFIRST_THROTTLE(logger, clock, duration, ...)                             \
  do {                                                                                           \
    RCLCPP_LOG_REQUIRE_LOGGER_(logger);                                                          \
    RCLCPP_LOG_TIME_OF_(clock);                                                                  \
    RCUTILS_LOG_WARN_SKIPFIRST_THROTTLE_NAMED(rclcpp_time_point_, duration, (logger).get_name(), \
                                              __VA_ARGS__);                                      \
  } while (0)
#define RCLCPP_WARN_STREAM_SKIPFIRST_THROTTLE(logger, clock, duration, stream_arg)               \
  do {                                                                                           \
    RCLCPP_LOG_REQUIRE_LOGGER_(logger);                                                          \
    RCLCPP_LOG_TIME_OF_(clock);                                                                  \
    std::stringstream rclcpp_stream_ss_;                                                         \
    rclcpp_stream_ss_ << stream_arg;                                                             \
    RCUTILS_LOG_WARN_SKIPFIRST_THROTTLE_NAMED(rclcpp_time_point_, duration, (logger).get_name(), \
                                              "%s", rclcpp_stream_ss_.str().c_str());            \
  } while (0)
#endif

#if RCLCPP_LOG_MIN_SEVERITY > RCLCPP_LOG_MIN_SEVERITY_ERROR
#define RCLCPP_ERROR(...)
#define RCLCPP_ERROR_STREAM(...)
#define RCLCPP_ERROR_ONCE(...)
#define RCLCPP_ERROR_STREAM_ONCE(...)
#define RCLCPP_ERROR_EXPRESSION(...)
#define RCLCPP_ERROR_STREAM_EXPRESSION(...)
#define RCLCPP_ERROR_FUNCTION(...)
#define RCLCPP_ERROR_STREAM_FUNCTION(...)
#define RCLCPP_ERROR_SKIPFIRST(...)
#define RCLCPP_ERROR_STREAM_SKIPFIRST(...)
#define RCLCPP_ERROR_THROTTLE(...)
#define RCLCPP_ERROR_STREAM_THROTTLE(...)
#define RCLCPP_ERROR_SKIPFIRST_THROTTLE(...)
#define RCLCPP_ERROR_STREAM_SKIPFIRST_THROTTLE(...)
#else
#define RCLCPP_ERROR(logger, ...)                              \
  do {                                                         \
    RCLCPP_LOG_REQUIRE_LOGGER_(logger);                        \
    RCUTILS_LOG_ERROR_NAMED((logger).get_name(), __VA_ARGS__); \
  } while (0)
#define RCLCPP_ERROR_STREAM(logger, stream_arg)                                          \
  do {                                                                                   \
    RCLCPP_LOG_REQUIRE_LOGGER_(logger);                                                  \
    std::stringstream rclcpp_stream_ss_;                                                 \
    rclcpp_stream_ss_ << stream_arg;                                                     \
    RCUTILS_LOG_ERROR_NAMED((logger).get_name(), "%s", rclcpp_stream_ss_.str().c_str()); \
  } while (0)
#define RCLCPP_ERROR_ONCE(logger, ...)                              \
  do {                                                              \
    RCLCPP_LOG_REQUIRE_LOGGER_(logger);                             \
    RCUTILS_LOG_ERROR_ONCE_NAMED((logger).get_name(), __VA_ARGS__); \
  } while (0)
#define RCLCPP_ERROR_STREAM_ONCE(logger, stream_arg)                                          \
  do {                                                                                        \
    RCLCPP_LOG_REQUIRE_LOGGER_(logger);                                                       \
    std::stringstream rclcpp_stream_ss_;                                                      \
    rclcpp_stream_ss_ << stream_arg;                                                          \
    RCUTILS_LOG_ERROR_ONCE_NAMED((logger).get_name(), "%s", rclcpp_stream_ss_.str().c_str()); \
  } while (0)
#define RCLCPP_ERROR_EXPRESSION(logger, expression, ...)                              \
  do {                                                                                \
    RCLCPP_LOG_REQUIRE_LOGGER_(logger);                                               \
    RCUTILS_LOG_ERROR_EXPRESSION_NAMED(expression, (logger).get_name(), __VA_ARGS__); \
  } while (0)
#define RCLCPP_ERROR_STREAM_EXPRESSION(logger, expression, stream_arg)        \
  do {                                                                        \
    RCLCPP_LOG_REQUIRE_LOGGER_(logger);                                       \
    std::stringstream rclcpp_stream_ss_;                                      \
    rclcpp_stream_ss_ << stream_arg;                                          \
    RCUTILS_LOG_ERROR_EXPRESSION_NAMED(expression, (logger).get_name(), "%s", \
                                       rclcpp_stream_ss_.str().c_str());      \
  } while (0)
#define RCLCPP_ERROR_FUNCTION(logger, function, ...)                              \
  do {                                                                            \
    RCLCPP_LOG_REQUIRE_LOGGER_(logger);                                           \
    RCUTILS_LOG_ERROR_FUNCTION_NAMED(function, (logger).get_name(), __VA_ARGS__); \
  } while (0)
#define RCLCPP_ERROR_STREAM_FUNCTION(logger, function, stream_arg)        \
  do {                                                                    \
    RCLCPP_LOG_REQUIRE_LOGGER_(logger);                                   \
    std::stringstream rclcpp_stream_ss_;                                  \
    rclcpp_stream_ss_ << stream_arg;                                      \
    RCUTILS_LOG_ERROR_FUNCTION_NAMED(function, (logger).get_name(), "%s", \
                                     rclcpp_stream_ss_.str().c_str());    \
  } while (0)
#define RCLCPP_ERROR_SKIPFIRST(logger, ...)                              \
  do {                                                                   \
    RCLCPP_LOG_REQUIRE_LOGGER_(logger);                                  \
    RCUTILS_LOG_ERROR_SKIPFIRST_NAMED((logger).get_name(), __VA_ARGS__); \
  } while (0)
#define RCLCPP_ERROR_STREAM_SKIPFIRST(logger, stream_arg)                                          \
  do {                                                                                             \
    RCLCPP_LOG_REQUIRE_LOGGER_(logger);                                                            \
    std::stringstream rclcpp_stream_ss_;                                                           \
    rclcpp_stream_ss_ << stream_arg;                                                               \
    RCUTILS_LOG_ERROR_SKIPFIRST_NAMED((logger).get_name(), "%s", rclcpp_stream_ss_.str().c_str()); \
  } while (0)
#define RCLCPP_ERROR_THROTTLE(logger, clock, duration, ...)                             \
  do {                                                                                  \
    RCLCPP_LOG_REQUIRE_LOGGER_(logger);                                                 \
    RCLCPP_LOG_TIME_OF_(clock);                                                         \
    RCUTILS_LOG_ERROR_THROTTLE_NAMED(rclcpp_time_point_, duration, (logger).get_name(), \
                                     __VA_ARGS__);                                      \
  } while (0)
#define RCLCPP_ERROR_STREAM_THROTTLE(logger, clock, duration, stream_arg)                     \
  do {                                                                                        \
    RCLCPP_LOG_REQUIRE_LOGGER_(logger);                                                       \
    RCLCPP_LOG_TIME_OF_(clock);                                                               \
    std::stringstream rclcpp_stream_ss_;                                                      \
    rclcpp_stream_ss_ << stream_arg;                                                          \
    RCUTILS_LOG_ERROR_THROTTLE_NAMED(rclcpp_time_point_, duration, (logger).get_name(), "%s", \
                                     rclcpp_stream_ss_.str().c_str());                        \
  } while (0)
#define RCLCPP_ERROR_SKIPFIRST_THROTTLE(logger, clock, duration, ...)                             \
  do {                                                                                            \
    RCLCPP_LOG_REQUIRE_LOGGER_(logger);                                                           \
    RCLCPP_LOG_TIME_OF_(clock);                                                                   \
    RCUTILS_LOG_ERROR_SKIPFIRST_THROTTLE_NAMED(rclcpp_time_point_, duration, (logger).get_name(), \
                                               __VA_ARGS__);                                      \
  } while (0)
#define RCLCPP_ERROR_STREAM_SKIPFIRST_THROTTLE(logger, clock, duration, stream_arg)               \
  do {                                                                                            \
    RCLCPP_LOG_REQUIRE_LOGGER_(logger);                                                           \
    RCLCPP_LOG_TIME_OF_(clock);                                                                   \
    std::stringstream rclcpp_stream_ss_;                                                          \
    rclcpp_stream_ss_ << stream_arg;                                                              \
    RCUTILS_LOG_ERROR_SKIPFIRST_THROTTLE_NAMED(rclcpp_time_point_, duration, (logger).get_name(), \
                                               "%s", rclcpp_stream_ss_.str().c_str());            \
  } while (0)
#endif

#if RCLCPP_LOG_MIN_SEVERITY > RCLCPP_LOG_MIN_SEVERITY_FATAL
#define RCLCPP_FATAL(...)
#define RCLCPP_FATAL_STREAM(...)
#define RCLCPP_FATAL_ONCE(...)
#define RCLCPP_FATAL_STREAM_ONCE(...)
#define RCLCPP_FATAL_EXPRESSION(...)
#define RCLCPP_FATAL_STREAM_EXPRESSION(...)
#define RCLCPP_FATAL_FUNCTION(...)
#define RCLCPP_FATAL_STREAM_FUNCTION(...)
#define RCLCPP_FATAL_SKIPFIRST(...)
#define RCLCPP_FATAL_STREAM_SKIPFIRST(...)
#define RCLCPP_FATAL_THROTTLE(...)
#define RCLCPP_FATAL_STREAM_THROTTLE(...)
#define RCLCPP_FATAL_SKIPFIRST_THROTTLE(...)
#define RCLCPP_FATAL_STREAM_SKIPFIRST_THROTTLE(...)
#else
#define RCLCPP_FATAL(logger, ...)                              \
  do {                                                         \
    RCLCPP_LOG_REQUIRE_LOGGER_(logger);                        \
    RCUTILS_LOG_FATAL_NAMED((logger).get_name(), __VA_ARGS__); \
  } while (0)
#define RCLCPP_FATAL_STREAM(logger, stream_arg)                                          \
  do {                                                                                   \
    RCLCPP_LOG_REQUIRE_LOGGER_(logger);                                                  \
    std::stringstream rclcpp_stream_ss_;                                                 \
    rclcpp_stream_ss_ << stream_arg;                                                     \
    RCUTILS_LOG_FATAL_NAMED((logger).get_name(), "%s", rclcpp_stream_ss_.str().c_str()); \
  } while (0)
#define RCLCPP_FATAL_ONCE(logger, ...)                              \
  do {                                                              \
    RCLCPP_LOG_REQUIRE_LOGGER_(logger);                             \
    RCUTILS_LOG_FATAL_ONCE_NAMED((logger).get_name(), __VA_ARGS__); \
  } while (0)
#define RCLCPP_FATAL_STREAM_ONCE(logger, stream_arg)                                          \
  do {                                                                                        \
    RCLCPP_LOG_REQUIRE_LOGGER_(logger);                                                       \
    std::stringstream rclcpp_stream_ss_;                                                      \
    rclcpp_stream_ss_ << stream_arg;                                                          \
    RCUTILS_LOG_FATAL_ONCE_NAMED((logger).get_name(), "%s", rclcpp_stream_ss_.str().c_str()); \
  } while (0)
#define RCLCPP_FATAL_EXPRESSION(logger, expression, ...)                              \
  do {                                                                                \
    RCLCPP_LOG_REQUIRE_LOGGER_(logger);                                               \
    RCUTILS_LOG_FATAL_EXPRESSION_NAMED(expression, (logger).get_name(), __VA_ARGS__); \
  } while (0)
#define RCLCPP_FATAL_STREAM_EXPRESSION(logger, expression, stream_arg)        \
  do {                                                                        \
    RCLCPP_LOG_REQUIRE_LOGGER_(logger);                                       \
    std::stringstream rclcpp_stream_ss_;                                      \
    rclcpp_stream_ss_ << stream_arg;                                          \
    RCUTILS_LOG_FATAL_EXPRESSION_NAMED(expression, (logger).get_name(), "%s", \
                                       rclcpp_stream_ss_.str().c_str());      \
  } while (0)
#define RCLCPP_FATAL_FUNCTION(logger, function, ...)                              \
  do {                                                                            \
    RCLCPP_LOG_REQUIRE_LOGGER_(logger);                                           \
    RCUTILS_LOG_FATAL_FUNCTION_NAMED(function, (logger).get_name(), __VA_ARGS__); \
  } while (0)
#define RCLCPP_FATAL_STREAM_FUNCTION(logger, function, stream_arg)        \
  do {                                                                    \
    RCLCPP_LOG_REQUIRE_LOGGER_(logger);                                   \
    std::stringstream rclcpp_stream_ss_;                                  \
    rclcpp_stream_ss_ << stream_arg;                                      \
    RCUTILS_LOG_FATAL_FUNCTION_NAMED(function, (logger).get_name(), "%s", \
                                     rclcpp_stream_ss_.str().c_str());    \
  } while (0)
#define RCLCPP_FATAL_SKIPFIRST(logger, ...)                              \
  do {                                                                   \
    RCLCPP_LOG_REQUIRE_LOGGER_(logger);                                  \
    RCUTILS_LOG_FATAL_SKIPFIRST_NAMED((logger).get_name(), __VA_ARGS__); \
  } while (0)
#define RCLCPP_FATAL_STREAM_SKIPFIRST(logger, stream_arg)                                          \
  do {                                                                                             \
    RCLCPP_LOG_REQUIRE_LOGGER_(logger);                                                            \
    std::stringstream rclcpp_stream_ss_;                                                           \
    rclcpp_stream_ss_ << stream_arg;                                                               \
    RCUTILS_LOG_FATAL_SKIPFIRST_NAMED((logger).get_name(), "%s", rclcpp_stream_ss_.str().c_str()); \
  } while (0)
#define RCLCPP_FATAL_THROTTLE(logger, clock, duration, ...)                             \
  do {                                                                                  \
    RCLCPP_LOG_REQUIRE_LOGGER_(logger);                                                 \
    RCLCPP_LOG_TIME_OF_(clock);                                                         \
    RCUTILS_LOG_FATAL_THROTTLE_NAMED(rclcpp_time_point_, duration, (logger).get_name(), \
                                     __VA_ARGS__);                                      \
  } while (0)
#define RCLCPP_FATAL_STREAM_THROTTLE(logger, clock, duration, stream_arg)                     \
  do {                                                                                        \
    RCLCPP_LOG_REQUIRE_LOGGER_(logger);                                                       \
    RCLCPP_LOG_TIME_OF_(clock);                                                               \
    std::stringstream rclcpp_stream_ss_;                                                      \
    rclcpp_stream_ss_ << stream_arg;                                                          \
    RCUTILS_LOG_FATAL_THROTTLE_NAMED(rclcpp_time_point_, duration, (logger).get_name(), "%s", \
                                     rclcpp_stream_ss_.str().c_str());                        \
  } while (0)
#define RCLCPP_FATAL_SKIPFIRST_THROTTLE(logger, clock, duration, ...)                             \
  do {                                                                                            \
    RCLCPP_LOG_REQUIRE_LOGGER_(logger);                                                           \
    RCLCPP_LOG_TIME_OF_(clock);                                                                   \
    RCUTILS_LOG_FATAL_SKIPFIRST_THROTTLE_NAMED(rclcpp_time_point_, duration, (logger).get_name(), \
                                               __VA_ARGS__);                                      \
  } while (0)
#define RCLCPP_FATAL_STREAM_SKIPFIRST_THROTTLE(logger, clock, duration, stream_arg)               \
  do {                                                                                            \
    RCLCPP_LOG_REQUIRE_LOGGER_(logger);                                                           \
    RCLCPP_LOG_TIME_OF_(clock);                                                                   \
    std::stringstream rclcpp_stream_ss_;                                                          \
    rclcpp_stream_ss_ << stream_arg;                                                              \
    RCUTILS_LOG_FATAL_SKIPFIRST_THROTTLE_NAMED(rclcpp_time_point_, duration, (logger).get_name(), \
                                               "%s", rclcpp_stream_ss_.str().c_str());            \
  } while (0)
#endif
