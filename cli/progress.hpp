// How progress is shown: a bar on a terminal, one line per finished step elsewhere, JSON lines with
// --json. Pure: events and the time in, text out.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>

#include "workspace_schema/base/progress_event.hpp"

namespace ros2wasm {

/// Milliseconds since some moment, never going back.
using ClockMs = std::function<std::int64_t()>;

enum class ProgressForm { kNone, kBar, kLines, kJson };

class Progress {
 public:
  Progress(ProgressForm form, std::size_t width, ClockMs clock)
      : form_(form), width_(width), clock_(std::move(clock)) {}

  /// Text to write to stderr for this event; empty when it comes too soon after the last one.
  [[nodiscard]] std::string show(const ProgressEvent& event);

  /// Text that wipes the bar, to write before anything else is printed.
  [[nodiscard]] std::string wipe();

 private:
  struct Begin {
    std::int64_t at_ms = 0;
    std::uint64_t done = 0;
  };

  [[nodiscard]] std::string bar(const ProgressEvent& event, const std::string& speed) const;
  /// The speed of a step that counts bytes, since its first event.
  [[nodiscard]] std::string speed(const ProgressEvent& event);

  ProgressForm form_;
  std::size_t width_;
  ClockMs clock_;
  bool drawn_ = false;
  std::map<std::string, Begin> begun_;                 ///< by step
  std::map<std::string, std::int64_t> last_shown_ms_;  ///< by step
};

}  // namespace ros2wasm
