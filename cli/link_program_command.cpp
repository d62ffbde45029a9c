// `ros2wasm link-program -- em++ ... -o talker.wasm`: what CMake runs instead of the linker. Not
// for people.
#include <memory>

#include "bundler/build/compiler.hpp"
#include "bundler/build/diagnostic_json.hpp"
#include "bundler/build/link_driver.hpp"
#include "bundler/build/link_kit.hpp"
#include "bundler/io/files.hpp"
#include "bundler/io/installation.hpp"
#include "bundler/io/sha256.hpp"
#include "cli/arguments.hpp"
#include "cli/console.hpp"

namespace ros2wasm {
namespace {

struct Options {
  std::string package;
  std::vector<std::string> command;
};

/// Leaves the findings for the pack, which is a grandparent of this process.
void hand_up(const Context& context, const std::string& output, const Diagnostics& findings) {
  const auto folder = context.environment.find("ROS2WASM_LINK_DIAGNOSTICS");
  if (findings.empty() || folder == context.environment.end() || folder->second.empty()) return;
  const std::string program = std::filesystem::path(output).stem().string();
  // Programs in two folders may have one name.
  const auto name = program + "-" + sha256_hex(output).substr(0, 16) + ".json";
  // When this fails the errors are still in what the linker printed.
  (void)write_file(
      std::filesystem::path(folder->second) / name,
      link_findings_to_json({.output = output, .program = program, .diagnostics = findings}));
}

int link(Context& context, const Options& options) {
  if (options.command.empty()) {
    return context.console.fail(
        Diagnostic{.code = "R2W0902",
                   .kind = FailureKind::kCommandLine,
                   .message = "there is no link command",
                   .fix = {"ros2wasm link-program -- em++ main.o -o main.wasm"}});
  }
  const auto support =
      find_own_data(context.executable, "templates/toolchain/src/thread_support.cpp",
                    "what programs with threads need");
  if (!support) return context.console.fail(support.errors());
  const auto linked =
      link_program({.package = options.package,
                    .command = options.command,
                    .environment = tool_environment(context.environment, options.command.front()),
                    .thread_support = support->string(),
                    .kits = context.variable(kLinkKitsVariable),
                    .tool_calls = context.variable(kToolCallsVariable),
                    .quick = !context.variable(kQuickLinkVariable).empty(),
                    .channel_prefix = context.variable(kChannelPrefixVariable)},
                   context.cancellation);
  hand_up(context, parse_link_line(options.command).output,
          linked ? linked->warnings : linked.errors());
  if (linked) return 0;
  return context.console.fail(linked.errors());
}

}  // namespace

CommandBody link_program_command(Arguments& arguments) {
  const auto options = std::make_shared<Options>();
  arguments.value("--package", options->package, "NAME", "the package that the program belongs to");
  arguments.rest("COMMAND", options->command, "the compiler and its arguments, after `--`");
  return [options](Context& context) { return link(context, *options); };
}

}  // namespace ros2wasm
