// What the launcher of a site does beside starting nodes, and when: the data that evaluation, plan
// and site.json share. Plain values.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "workspace_schema/diagnostic.hpp"
#include "workspace_schema/json_writer.hpp"

namespace ros2wasm {

/// What another process does, after which something is done; or all processes, at the launch's end.
enum class LaunchEvent { kStart, kExit, kTransition, kShutdown };

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
  bool once = false;
};

enum class LaunchStepKind { kLog, kShutdown, kTransition };

struct LaunchStep {
  LaunchStepKind kind = LaunchStepKind::kLog;
  std::string text;   ///< the line, or the reason
  std::string level;  ///< of kLog
  std::string node;   ///< of kTransition: its id
  std::string name;   ///< and its full name
  std::vector<std::int64_t> transitions;
  LaunchMoment on;
  double after_s = 0;
  SourceSpan span;
};

[[nodiscard]] std::string_view launch_event_name(LaunchEvent event);
void write_state_change(JsonWriter& json, const LaunchStateChange& change);

}  // namespace ros2wasm
