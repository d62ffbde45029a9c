// The program from above: read the command line, prepare the world, run one command, say how it
// ended.
#include <poll.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <iostream>

#include "bundler/io/process.hpp"
#include "cli/arguments.hpp"
#include "cli/command_table.hpp"
#include "cli/console.hpp"
#include "cli/interrupt.hpp"

extern char** environ;

namespace ros2wasm {
namespace {

std::map<std::string, std::string> environment_variables() {
  std::map<std::string, std::string> variables;
  for (char** entry = environ; *entry != nullptr; ++entry) {
    const std::string_view text(*entry);
    const std::size_t equals = text.find('=');
    if (equals != std::string_view::npos)
      variables.emplace(text.substr(0, equals), text.substr(equals + 1));
  }
  return variables;
}

/// A container may have no /proc: there it is what a shell has found by that name.
std::filesystem::path own_executable(const char* argv0) {
  std::error_code error;
  auto path = std::filesystem::read_symlink("/proc/self/exe", error);
  if (!error) return path;
  path = find_program(argv0).value_or(argv0);
  const auto whole = std::filesystem::canonical(path, error);
  return error ? std::filesystem::absolute(path, error) : whole;
}

std::size_t terminal_columns() {
  winsize size{};
  if (ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col >= 40) return size.ws_col;
  return 100;
}

std::int64_t steady_ms() {
  const auto now = std::chrono::steady_clock::now().time_since_epoch();
  return std::chrono::duration_cast<std::chrono::milliseconds>(now).count();
}

ConsoleOptions console_options(const GlobalOptions& global,
                               const std::map<std::string, std::string>& environment) {
  const bool terminal = isatty(STDERR_FILENO) == 1;
  const auto variable = [&](const char* name) {
    const auto found = environment.find(name);
    return found == environment.end() ? std::string() : found->second;
  };
  const bool able = terminal && variable("NO_COLOR").empty() && variable("TERM") != "dumb";
  ConsoleOptions options{.quiet = global.quiet, .json = global.json};
  options.style.color =
      global.color == ColorMode::kAlways || (global.color == ColorMode::kAuto && able);
  options.terminal_width = terminal ? terminal_columns() : 100;
  options.style.width = options.terminal_width;
  options.live_progress = terminal && variable("TERM") != "dumb";
  return options;
}

/// Whether stdout is a pipe that nobody reads any more, as behind `| head`: that is not a failure.
bool reader_ended() {
  pollfd out{.fd = STDOUT_FILENO, .events = POLLOUT, .revents = 0};
  return poll(&out, 1, 0) == 1 && (out.revents & POLLERR) != 0;
}

Diagnostic bug(const std::string& what) {
  return Diagnostic{
      .code = "R2W0990",
      .kind = FailureKind::kBug,
      .message = "ros2wasm has a bug: " + what,
      .why = {"no input should lead here; please report it with the command that you ran"}};
}

int run(int argc, char** argv) {
  const auto environment = environment_variables();
  const std::vector<std::string> words(argv + (argc > 0 ? 1 : 0), argv + argc);
  ParsedCommandLine parsed = parse_command_line(words, command_table());
  Console console(console_options(parsed.global, environment), std::cout, std::cerr, steady_ms);

  int code = 0;
  if (!parsed.invocation) {
    code = console.fail(parsed.invocation.errors());
  } else if (!parsed.invocation->body) {
    console.result_text(parsed.invocation->text);
  } else {
    Context context{.console = console,
                    .cancellation = install_interrupt_handlers(),
                    .progress = [&console](const ProgressEvent& event) { console.progress(event); },
                    .executable = own_executable(argc > 0 ? argv[0] : "ros2wasm"),
                    .environment = environment,
                    .json = parsed.global.json};
    try {
      code = parsed.invocation->body(context);
    } catch (const std::exception& raised) {
      code = console.fail(bug(raised.what()));
    } catch (...) {
      code = console.fail(bug("unknown exception"));
    }
  }
  if (!std::cout.flush() && code == 0 && !reader_ended()) {
    code =
        console.fail(Diagnostic{.code = "R2W0904",
                                .kind = FailureKind::kEnvironment,
                                .message = "the result could not be written to standard output"});
  }
  console.end(code);
  return code;
}

}  // namespace
}  // namespace ros2wasm

int main(int argc, char** argv) {
  return ros2wasm::run(argc, argv);
}
