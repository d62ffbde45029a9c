// The result of a launch file: processes with their final settings, launch arguments, messages and
// their times, and parts that a site cannot start. Plain values, each with its place in the source.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "bundler/launch/launch_graph.hpp"
#include "bundler/launch/launch_step.hpp"
#include "workspace_schema/schema/manifest.hpp"

namespace ros2wasm {

struct LaunchArgument {
  std::string name;
  std::optional<std::string> default_value;  ///< none: it must be given
  std::string description;
  std::vector<std::string> choices;  ///< empty: any value
  std::string value;                 ///< given or by default
  bool given = false;
  SourceSpan span;
};

/// A component that is loaded into a container when that has started.
struct LaunchComponent {
  NodeEntry node;  ///< without an executable; as LaunchProcess has it
  std::string plugin;
  std::vector<std::pair<std::string, std::string>> extra_arguments;
};

struct LaunchTrigger {
  std::size_t process = 0;  ///< index in LaunchDescription::processes; not of kShutdown
  LaunchEvent event = LaunchEvent::kExit;
  LaunchStateChange change = {};  ///< of kTransition
  LaunchOutput output = {};       ///< of kOutput
  bool once = false;              ///< is followed the first time only
  /// The number of a handler that looks at several processes and is followed `once`; else -1.
  std::int64_t handler = -1;
};

struct LaunchProcess {
  NodeEntry node;  ///< parameter files are keys of LaunchDescription::parameter_files
  std::map<std::string, std::string> environment;
  std::optional<LaunchTrigger> start_on;  ///< else when the launch starts
  double start_after_s = 0;               ///< of timers that it stands in
  double respawn_delay_s = 0;
  std::optional<std::int64_t> respawn_max_retries;  ///< else as often as it ends
  bool shutdown_on_exit = false;                    ///< when it ends, all ends
  std::vector<LaunchComponent> components;
};

struct LaunchLine {
  std::string level;  ///< "info", "warning", "error" or "debug"
  std::string text;
  std::optional<LaunchTrigger> on = {};
  double after_s = 0;
  SourceSpan span;
};

/// A part of the file that does not run in a site.
struct LaunchLeftOut {
  std::string what;     ///< "rviz2 (package rviz2)", or a command line
  std::string instead;  ///< what stands in for it, or why it cannot run; a sentence's end
  SourceSpan span;
};

struct LaunchShutdown {
  std::optional<LaunchTrigger> on;
  double after_s = 0;
  std::string reason;
  SourceSpan span;
};

/// Changes of a managed node's state, each when the one before has come to its end.
struct LaunchTransitions {
  std::optional<std::size_t> process;  ///< index in LaunchDescription::processes, else by its name:
  std::string node;
  std::vector<std::int64_t> transitions;  ///< as lifecycle_msgs/msg/Transition numbers them
  std::optional<LaunchTrigger> on;
  double after_s = 0;
  SourceSpan span;
};

/// A process is told to end.
struct LaunchEnd {
  std::size_t process = 0;  ///< index in LaunchDescription::processes
  std::optional<LaunchTrigger> on;
  double after_s = 0;
  SourceSpan span;
};

struct LaunchDescription {
  std::vector<LaunchArgument> arguments;  ///< in the order of declaration
  std::vector<LaunchProcess> processes;   ///< in the order of the file
  std::vector<LaunchLine> lines;
  std::vector<LaunchLeftOut> left_out;
  std::vector<LaunchShutdown> shutdowns;
  std::vector<LaunchTransitions> transitions;  ///< each of a known process at the end
  std::vector<LaunchEnd> ends;
  ParameterFiles parameter_files;
  std::vector<std::string> files;  ///< launch and parameter files that were read, sorted
  Diagnostics warnings;
};

}  // namespace ros2wasm
