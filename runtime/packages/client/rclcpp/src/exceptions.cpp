// Texts and conversions of the exceptions.
#include "rclcpp/exceptions/exceptions.hpp"

namespace rclcpp {
namespace exceptions {
namespace {

std::string join(const std::vector<std::string>& words, const std::string& between) {
  std::string text;
  for (const std::string& word : words) {
    text += (text.empty() ? "" : between) + word;
  }
  return text;
}

}  // namespace

std::string NameValidationError::format_error(const char* name_type, const char* name,
                                              const char* error_msg, size_t invalid_index) {
  return std::string("Invalid ") + name_type + ": " + error_msg + ":\n  '" + name + "'\n   " +
         std::string(invalid_index, ' ') + "^\n";
}

UnknownROSArgsError::UnknownROSArgsError(std::vector<std::string>&& unknown_ros_args_in)
    : std::runtime_error("found unknown ROS arguments: '" + join(unknown_ros_args_in, "', '") +
                         "'"),
      unknown_ros_args(std::move(unknown_ros_args_in)) {}

void throw_from_rcl_error(rcl_ret_t ret, const std::string& prefix,
                          const rcl_error_state_t* error_state,
                          reset_error_function_t reset_error) {
  if (ret == RCL_RET_OK) {
    throw std::invalid_argument("ret is RCL_RET_OK");
  }
  if (error_state == nullptr) {
    error_state = rcl_get_error_state();
  }
  if (error_state == nullptr) {
    throw std::runtime_error("rcl error state is not set");
  }
  const RCLErrorBase base(ret, error_state);
  const std::string before = prefix.empty() ? prefix : prefix + ": ";
  if (reset_error != nullptr) {
    reset_error();
  }
  switch (ret) {
    case RCL_RET_BAD_ALLOC:
      throw RCLBadAlloc(base);
    case RCL_RET_INVALID_ARGUMENT:
      throw RCLInvalidArgument(base, before);
    case RCL_RET_INVALID_ROS_ARGS:
      throw RCLInvalidROSArgsError(base, before);
    default:
      throw RCLError(base, before);
  }
}

RCLErrorBase::RCLErrorBase(rcl_ret_t ret_in, const rcl_error_state_t* error_state)
    : ret(ret_in),
      message(error_state->message),
      file(error_state->file),
      line(static_cast<size_t>(error_state->line_number)),
      formatted_message(message + ", at " + file + ":" + std::to_string(line)) {}

RCLError::RCLError(rcl_ret_t ret, const rcl_error_state_t* error_state, const std::string& prefix)
    : RCLError(RCLErrorBase(ret, error_state), prefix) {}
RCLError::RCLError(const RCLErrorBase& base_exc, const std::string& prefix)
    : RCLErrorBase(base_exc), std::runtime_error(prefix + base_exc.formatted_message) {}

RCLBadAlloc::RCLBadAlloc(rcl_ret_t ret, const rcl_error_state_t* error_state)
    : RCLBadAlloc(RCLErrorBase(ret, error_state)) {}
RCLBadAlloc::RCLBadAlloc(const RCLErrorBase& base_exc) : RCLErrorBase(base_exc) {}

RCLInvalidArgument::RCLInvalidArgument(rcl_ret_t ret, const rcl_error_state_t* error_state,
                                       const std::string& prefix)
    : RCLInvalidArgument(RCLErrorBase(ret, error_state), prefix) {}
RCLInvalidArgument::RCLInvalidArgument(const RCLErrorBase& base_exc, const std::string& prefix)
    : RCLErrorBase(base_exc), std::invalid_argument(prefix + base_exc.formatted_message) {}

RCLInvalidROSArgsError::RCLInvalidROSArgsError(rcl_ret_t ret, const rcl_error_state_t* error_state,
                                               const std::string& prefix)
    : RCLInvalidROSArgsError(RCLErrorBase(ret, error_state), prefix) {}
RCLInvalidROSArgsError::RCLInvalidROSArgsError(const RCLErrorBase& base_exc,
                                               const std::string& prefix)
    : RCLErrorBase(base_exc), std::runtime_error(prefix + base_exc.formatted_message) {}

}  // namespace exceptions
}  // namespace rclcpp
