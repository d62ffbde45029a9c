// The body of a program that runs one component.
#pragma once

#include "rclcpp/executor.hpp"

namespace rclcpp_components {

/// Makes the node of class `component` and spins it on `executor`. Returns the exit code.
int run_component(int argc, char** argv, const char* program, const char* component,
                  rclcpp::Executor& (*make_executor)());

}  // namespace rclcpp_components
