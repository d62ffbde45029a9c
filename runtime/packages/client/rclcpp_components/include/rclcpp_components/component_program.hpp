// The bodies of programs that run components. Includes nothing: such a program has one line, and
// reading all of rclcpp for it would take most of the time in which a package of components is
// built.
#pragma once

namespace rclcpp {
class Executor;
}

namespace rclcpp_components {

/// Makes the node of class `component` and spins it on the executor, a single-threaded one where
/// nobody makes another. Returns the exit code.
int run_component(int argc, char** argv, const char* program, const char* component,
                  rclcpp::Executor& (*make_executor)() = nullptr);

/// Runs a container: it loads and unloads the components that the program was linked with, on
/// request. Those of `--component=CLASS` are loaded at the start, each with the words of its
/// `--component-arg=WORD` as arguments and the boolean extra arguments `--component-flag=NAME`.
int run_container(int argc, char** argv);

/// The same with threads. `name` is the program's: `component_container_mt` has one executor with
/// as many threads as its parameter `thread_num` says; `component_container_isolated` one for each
/// component, in a thread of its own (with `--use_multi_threaded_executor` a multi-threaded one).
int run_container_mt(int argc, char** argv, const char* name);

}  // namespace rclcpp_components
