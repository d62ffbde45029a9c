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
    case LaunchEvent::kShutdown:
      return "shutdown";
  }
  return "";
}

void write_state_change(JsonWriter& json, const LaunchStateChange& change) {
  if (!change.transition.empty()) json.field("transition", change.transition);
  if (!change.start_state.empty()) json.field("start_state", change.start_state);
  if (!change.goal_state.empty()) json.field("goal_state", change.goal_state);
}

}  // namespace ros2wasm
