// `ros2wasm compile-source -- em++ ... -c talker.cpp`: what CMake runs instead of the compiler. Not
// for people.
#include <memory>

#include "bundler/build/cached_header.hpp"
#include "bundler/build/compiler.hpp"
#include "bundler/build/link_driver.hpp"
#include "cli/arguments.hpp"
#include "cli/console.hpp"

namespace ros2wasm {
namespace {

int compile(Context& context, const std::vector<std::string>& command) {
  if (command.empty()) {
    return context.console.fail(Diagnostic{.code = "R2W0902",
                                           .kind = FailureKind::kCommandLine,
                                           .message = "there is no compile command",
                                           .fix = {"ros2wasm compile-source -- em++ -c main.cpp"}});
  }
  const auto compiled =
      compile_source({.command = command,
                      .kept = context.variable(kKeptHeadersVariable),
                      .tool_calls = context.variable(kToolCallsVariable),
                      .environment = tool_environment(context.environment, command.front())},
                     context.cancellation);
  if (!compiled) return context.console.fail(compiled.errors());
  context.console.result_text(compiled->output);
  return compiled->exit_code;
}

}  // namespace

CommandBody compile_source_command(Arguments& arguments) {
  const auto command = std::make_shared<std::vector<std::string>>();
  arguments.rest("COMMAND", *command, "the compiler and its arguments, after `--`");
  return [command](Context& context) { return compile(context, *command); };
}

}  // namespace ros2wasm
