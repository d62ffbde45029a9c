// The steps of the launcher of a site other than starting nodes, and their times: the data that
// evaluation, plan and site.json share. Plain values.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "workspace_schema/base/diagnostic.hpp"
#include "workspace_schema/base/json_writer.hpp"

namespace ros2wasm {

/// An event of another process that triggers a step; kShutdown is the end of the whole launch.
enum class LaunchEvent { kStart, kExit, kTransition, kOutput, kShutdown };

/// One thing that a line of a process is or is not.
struct LaunchLineTest {
  std::string how;  ///< "contains", "begins", "ends" or "is"
  std::string text;
  bool any_case = false;
  bool holds = true;  ///< else it must not be so
};

/// The lines of a process that are meant: of one stream, and as all these say.
struct LaunchOutput {
  std::string stream;  ///< "stdout" or "stderr"
  std::vector<LaunchLineTest> tests;
};

/// The placeholder for the printed line in a message. printed_text.py and launch_steps.ts know it
/// too.
constexpr std::string_view kPrintedLine = "\u2039what it prints\u203a";

/// The placeholder for the reason in a message at the end of the launch. events/__init__.py and
/// launch_steps.ts know it too.
constexpr std::string_view kShutdownReason = "\u2039why all ends\u203a";

/// A change of a managed node's state, by the labels of its transition_event; empty: any.
struct LaunchStateChange {
  std::string transition;
  std::string start_state;
  std::string goal_state;
};

/// A moment of a site's launch. Nodes are named by their ids.
struct LaunchMoment {
  std::string node;  ///< empty: when the launch starts, or ends
  LaunchEvent event = LaunchEvent::kStart;
  std::string name;  ///< full, of the managed node; of kTransition
  LaunchStateChange change;
  LaunchOutput output;  ///< of kOutput
  bool once = false;
  std::int64_t handler =
      -1;  ///< with `once`: the first moment of this number is the only one; or -1
};

enum class LaunchStepKind { kLog, kShutdown, kTransition, kEnd };

struct LaunchStep {
  LaunchStepKind kind = LaunchStepKind::kLog;
  std::string text;   ///< the line, or the reason
  std::string level;  ///< of kLog
  std::string node;   ///< of kTransition and kEnd: its id
  std::string name;   ///< of kTransition: its full name
  std::vector<std::int64_t> transitions;
  LaunchMoment on;
  double after_s = 0;
  SourceSpan span;
};

[[nodiscard]] std::string_view launch_event_name(LaunchEvent event);
/// `stream` and `tests`, unless there are none.
void write_output(JsonWriter& json, const LaunchOutput& output);
void write_state_change(JsonWriter& json, const LaunchStateChange& change);

}  // namespace ros2wasm
