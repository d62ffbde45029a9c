// See launch_step.hpp.
#include "bundler/launch/launch_step.hpp"

namespace ros2wasm {

std::string_view launch_event_name(LaunchEvent event) {
  switch (event) {
    case LaunchEvent::kStart:
      return "start";
    case LaunchEvent::kExit:
      return "exit";
    case LaunchEvent::kTransition:
      return "transition";
    case LaunchEvent::kOutput:
      return "output";
    case LaunchEvent::kShutdown:
      return "shutdown";
  }
  return "";
}

void write_output(JsonWriter& json, const LaunchOutput& output) {
  if (!output.stream.empty()) json.field("stream", output.stream);
  if (output.tests.empty()) return;
  json.key("tests").begin_array();
  for (const LaunchLineTest& one : output.tests) {
    json.begin_object().field("how", one.how).field("text", one.text);
    if (one.any_case) json.field_boolean("any_case", true);
    if (!one.holds) json.field_boolean("holds", false);
    json.end_object();
  }
  json.end_array();
}

void write_state_change(JsonWriter& json, const LaunchStateChange& change) {
  if (!change.transition.empty()) json.field("transition", change.transition);
  if (!change.start_state.empty()) json.field("start_state", change.start_state);
  if (!change.goal_state.empty()) json.field("goal_state", change.goal_state);
}

}  // namespace ros2wasm
