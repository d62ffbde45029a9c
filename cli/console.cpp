// See console.hpp.
#include "cli/console.hpp"

#include <algorithm>
#include <ostream>

#include "workspace_schema/base/json_writer.hpp"
#include "workspace_schema/base/secret_text.hpp"

namespace ros2wasm {
namespace {

ProgressForm progress_form(const ConsoleOptions& options) {
  if (options.quiet) return ProgressForm::kNone;
  if (options.json) return ProgressForm::kJson;
  return options.live_progress ? ProgressForm::kBar : ProgressForm::kLines;
}

/// The last door: whatever a step put into its words, no credential of an address is shown.
Diagnostic without_credentials(Diagnostic diagnostic) {
  diagnostic.message = with_masked_secrets(diagnostic.message);
  diagnostic.detail = with_masked_secrets(diagnostic.detail);
  for (std::string& line : diagnostic.why) line = with_masked_secrets(line);
  for (std::string& line : diagnostic.fix) line = with_masked_secrets(line);
  if (diagnostic.span) diagnostic.span->line_text = with_masked_secrets(diagnostic.span->line_text);
  return diagnostic;
}

}  // namespace

Console::Console(ConsoleOptions options, std::ostream& out, std::ostream& err, ClockMs clock)
    : options_(options),
      out_(out),
      err_(err),
      progress_(progress_form(options), options.terminal_width, std::move(clock)) {}

Console::~Console() {
  write_error_stream({});
}

/// Wipes the bar first, so that nothing is written behind it.
void Console::write_error_stream(std::string_view text) {
  err_ << progress_.wipe() << text << std::flush;
}

void Console::result(std::string_view line) {
  const std::scoped_lock lock(mutex_);
  write_error_stream({});
  out_ << line << '\n' << std::flush;
}

void Console::result_text(std::string_view text) {
  const std::scoped_lock lock(mutex_);
  write_error_stream({});
  out_ << text << std::flush;
}

void Console::remark(std::string_view line) {
  if (options_.quiet) return;
  const std::scoped_lock lock(mutex_);
  if (options_.json) {
    JsonWriter json;
    json.begin_object().field("event", "remark").field("text", line).end_object();
    write_error_stream(json.text() + "\n");
  } else {
    write_error_stream(std::string(line) + "\n");
  }
}

void Console::report(const Diagnostic& diagnostic) {
  if (options_.quiet && diagnostic.code == kCompilerWarning) return;
  const Diagnostic shown = without_credentials(diagnostic);
  const std::scoped_lock lock(mutex_);
  if (options_.json) {
    write_error_stream(diagnostic_json(shown) + "\n");
  } else {
    write_error_stream(diagnostic_text(shown, options_.style) + "\n");
  }
}

int Console::fail(const Diagnostics& errors) {
  for (const Diagnostic& error : errors) report(error);
  const auto count = std::count_if(errors.begin(), errors.end(), [](const Diagnostic& d) {
    return d.severity == Severity::kError;
  });
  if (!options_.json && count > 0) {
    std::string last = count == 1 ? "1 error" : std::to_string(count) + " errors";
    const auto first = std::find_if(errors.begin(), errors.end(), [](const Diagnostic& d) {
      return d.severity == Severity::kError;
    });
    last += "; `ros2wasm explain " + first->code + "` says more";
    remark(last);
  }
  return exit_code_of(errors);
}

void Console::progress(const ProgressEvent& event) {
  const std::scoped_lock lock(mutex_);
  err_ << progress_.show(event) << std::flush;
}

void Console::end(int exit_code) {
  if (!options_.json) return;
  const std::scoped_lock lock(mutex_);
  JsonWriter json;
  json.begin_object().field("event", "end").field_integer("exit_code", exit_code).end_object();
  write_error_stream(json.text() + "\n");
}

int exit_code_of(const Diagnostics& errors) {
  const auto has = [&](FailureKind kind) {
    return std::any_of(errors.begin(), errors.end(),
                       [kind](const Diagnostic& d) { return d.kind == kind; });
  };
  if (has(FailureKind::kInterrupted)) return static_cast<int>(FailureKind::kInterrupted);
  if (has(FailureKind::kBug)) return static_cast<int>(FailureKind::kBug);
  for (const Diagnostic& diagnostic : errors) {
    if (diagnostic.severity == Severity::kError) return static_cast<int>(diagnostic.kind);
  }
  return static_cast<int>(FailureKind::kUserInput);
}

}  // namespace ros2wasm
