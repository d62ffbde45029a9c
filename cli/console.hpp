// The one place that prints. stdout is the result and nothing else; diagnostics, progress and
// remarks go to stderr, as text for people or, with --json, as one JSON object per line
// (schemas/events.schema.json).
#pragma once

#include <iosfwd>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>

#include "cli/diagnostic_text.hpp"
#include "cli/progress.hpp"
#include "workspace_schema/base/outcome.hpp"
#include "workspace_schema/base/progress_event.hpp"

namespace ros2wasm {

struct ConsoleOptions {
  bool quiet = false;  ///< no remarks, no progress, no warnings of compilers; errors and
                       ///< the packer's own warnings stay
  bool json = false;
  TextStyle style;             ///< of diagnostics
  bool live_progress = false;  ///< stderr is a terminal: draw a bar
  std::size_t terminal_width = 100;
};

/// May be used from several threads.
class Console {
 public:
  Console(ConsoleOptions options, std::ostream& out, std::ostream& err, ClockMs clock);
  ~Console();
  Console(const Console&) = delete;
  Console& operator=(const Console&) = delete;

  /// A line of the result, to stdout.
  void result(std::string_view line);
  /// Result text as it is, to stdout.
  void result_text(std::string_view text);
  /// A remark, to stderr: what was chosen, what was done.
  void remark(std::string_view line);
  void report(const Diagnostic& diagnostic);
  /// Reports all and returns the exit code they ask for.
  [[nodiscard]] int fail(const Diagnostics& errors);
  [[nodiscard]] int fail(const Diagnostic& error) { return fail(Diagnostics{error}); }
  void progress(const ProgressEvent& event);
  /// Last line of a --json run.
  void end(int exit_code);

  [[nodiscard]] bool json() const { return options_.json; }
  [[nodiscard]] bool quiet() const { return options_.quiet; }

 private:
  void write_error_stream(std::string_view text);

  ConsoleOptions options_;
  std::ostream& out_;
  std::ostream& err_;
  std::mutex mutex_;
  Progress progress_;
};

/// Interrupted wins, then a bug, then the first error's kind; 1 when there is none.
[[nodiscard]] int exit_code_of(const Diagnostics& errors);

}  // namespace ros2wasm
