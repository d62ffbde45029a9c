// Which controllers a switch stops, starts and chains, and why it is refused. Values in, a plan
// out: this file needs no ROS.
#pragma once

#include <set>
#include <string>
#include <vector>

namespace controller_manager {

enum class LifeState { kUnconfigured, kInactive, kActive, kOther };

/// A loaded controller as the plan sees it.
struct ControllerView {
  std::string name;
  LifeState state = LifeState::kUnconfigured;
  bool is_chainable = false;
  bool is_in_chained_mode = false;
  /// Full names of the interfaces that it needs, for its configuration as it is now.
  std::vector<std::string> commands;
  std::vector<std::string> states;
  /// Asks for all that are available: it does without those that go.
  bool takes_all_commands = false;
  bool takes_all_states = false;
  /// Its exported interfaces: commands (references) and states.
  std::vector<std::string> references;
  std::vector<std::string> exported_states;
  std::vector<std::string> fallbacks;
};

struct InterfacesNow {
  std::set<std::string> available_commands;
  std::set<std::string> claimed_commands;
  std::set<std::string> available_states;
};

struct SwitchRequest {
  std::vector<std::string> activate;
  std::vector<std::string> deactivate;
  bool is_strict = false;
};

struct SwitchPlan {
  bool ok = false;
  /// The answer when nothing is to be done, or the switch is refused.
  std::string message;
  std::vector<std::string> warnings;
  std::vector<std::string> activate;
  std::vector<std::string> deactivate;
  std::vector<std::string> to_chained_mode;
  std::vector<std::string> from_chained_mode;
  std::vector<std::string> start_interfaces;
  std::vector<std::string> stop_interfaces;

  [[nodiscard]] bool is_empty() const { return activate.empty() && deactivate.empty(); }
};

/// The plan of a switch. A strict request is refused as a whole; otherwise what cannot be done is
/// left out of it.
SwitchPlan plan_switch(const SwitchRequest& request, const std::vector<ControllerView>& controllers,
                       const InterfacesNow& interfaces);

/// The order of updates: who commands another comes before it; others keep their order.
std::vector<std::string> update_order(const std::vector<ControllerView>& controllers);

/// The controller and all that are connected with it by chains, in the order of `controllers`.
std::vector<std::string> chain_of(const std::string& name,
                                  const std::vector<ControllerView>& controllers);

}  // namespace controller_manager
