// The rules of a switch.
#include "switch_plan.hpp"

#include <algorithm>
#include <functional>

namespace controller_manager {
namespace {

using Names = std::vector<std::string>;

bool has(const Names& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}
void add_once(Names& names, const std::string& name) {
  if (!has(names, name)) {
    names.push_back(name);
  }
}
void remove(Names& names, const std::string& name) {
  names.erase(std::remove(names.begin(), names.end(), name), names.end());
}

const ControllerView* find(const std::vector<ControllerView>& controllers,
                           const std::string& name) {
  const auto found = std::find_if(controllers.begin(), controllers.end(),
                                  [&name](const auto& one) { return one.name == name; });
  return found == controllers.end() ? nullptr : &*found;
}

/// The controller that an interface belongs to, or null for one of the hardware.
const ControllerView* owner_of(const std::string& interface,
                               const std::vector<ControllerView>& controllers) {
  for (const ControllerView& controller : controllers) {
    if (has(controller.references, interface) || has(controller.exported_states, interface)) {
      return &controller;
    }
  }
  // A chained controller that is not configured yet has exported nothing.
  return find(controllers, interface.substr(0, interface.find('/')));
}

Names needs_of(const ControllerView& controller) {
  Names all = controller.commands;
  all.insert(all.end(), controller.states.begin(), controller.states.end());
  return all;
}

class Planner {
 public:
  Planner(const SwitchRequest& request, const std::vector<ControllerView>& controllers,
          const InterfacesNow& interfaces)
      : request_(request), controllers_(controllers), interfaces_(interfaces) {}

  SwitchPlan plan() {
    if (!take_known(request_.deactivate, "deactivate", plan_.deactivate) ||
        !take_known(request_.activate, "activate", plan_.activate)) {
      return refused();
    }
    free_followers_of_stopped();
    if (!check_all(plan_.activate, "activate",
                   [this](const auto& one) { return may_start(one); }) ||
        !check_all(plan_.deactivate, "deactivate",
                   [this](const auto& one) { return may_stop(one); })) {
      return refused();
    }
    if (plan_.is_empty()) {
      return nothing_to_do();
    }
    restart_those_that_change_mode();
    if (!interfaces_are_free()) {
      return refused();
    }
    collect_interfaces();
    plan_.ok = true;
    return plan_;
  }

 private:
  SwitchPlan refused() {
    SwitchPlan empty;
    empty.message = plan_.message;
    empty.warnings = plan_.warnings;
    return empty;
  }

  SwitchPlan nothing_to_do() {
    SwitchPlan empty;
    empty.ok = true;
    empty.warnings = plan_.warnings;
    empty.message =
        "After checking the controllers, no controllers need to be activated or deactivated.";
    return empty;
  }

  bool warn(const std::string& text) {
    plan_.message = text;
    plan_.warnings.push_back(text);
    return false;
  }

  /// False for an unknown name in a strict request, and when no name is known.
  bool take_known(const Names& asked, const char* action, Names& into) {
    std::string unknown;
    for (const std::string& name : asked) {
      if (find(controllers_, name) != nullptr) {
        into.push_back(name);
        continue;
      }
      warn(std::string("Could not ") + action + " controller with name '" + name +
           "' because no controller with this name exists");
      if (request_.is_strict) {
        return false;
      }
      unknown += plan_.message + "\n";
    }
    if (into.empty() && !unknown.empty()) {
      plan_.message = unknown;
      return false;
    }
    return true;
  }

  void free_followers_of_stopped() {
    for (const ControllerView& controller : controllers_) {
      if (!has(plan_.deactivate, controller.name) || controller.state != LifeState::kActive) {
        continue;
      }
      for (const std::string& interface : needs_of(controller)) {
        const ControllerView* const follower = owner_of(interface, controllers_);
        if (follower != nullptr && follower->is_in_chained_mode) {
          add_once(plan_.from_chained_mode, follower->name);
        }
      }
    }
  }

  bool check_all(Names& names, const char* action,
                 const std::function<bool(const ControllerView&)>& check) {
    const Names asked = names;
    for (const std::string& name : asked) {
      if (check(*find(controllers_, name))) {
        continue;
      }
      plan_.warnings.push_back(
          std::string("Could not ") + action + " controller with name '" + name +
          "'. Check above warnings for more details. Check the state of the controllers and their "
          "required interfaces using `ros2 control list_controllers -v` CLI to get more "
          "information.");
      if (request_.is_strict) {
        return false;
      }
      remove(names, name);
    }
    return true;
  }

  bool may_start(const ControllerView& controller) {
    const std::string subject = "Controller with name '" + controller.name + "' is ";
    if (controller.state == LifeState::kUnconfigured) {
      return warn(subject +
                  "in 'unconfigured' state. The controller needs to be configured to be in "
                  "'inactive' state before it can be checked and activated.");
    }
    if (controller.state == LifeState::kActive) {
      return has(plan_.deactivate, controller.name) || warn(subject + "already active.");
    }
    if (controller.state != LifeState::kInactive) {
      return warn(subject +
                  "not in 'inactive' state. The controller needs to be in 'inactive' state before "
                  "it can be checked and activated.");
    }
    return followers_are_ready(controller) && fallbacks_are_ready(controller);
  }

  bool followers_are_ready(const ControllerView& controller) {
    for (const std::string& interface : needs_of(controller)) {
      const ControllerView* const follower = owner_of(interface, controllers_);
      if (follower == nullptr || follower == &controller) {
        continue;
      }
      const bool is_command = has(controller.commands, interface);
      const std::string subject = "The following controller with name '" + follower->name + "' is ";
      if (!follower->is_chainable) {
        return warn("No state/reference interface from controller : '" + interface +
                    "' exist, since the following controller with name '" + follower->name +
                    "' is not chainable.");
      }
      if (follower->state == LifeState::kActive) {
        const bool stops =
            has(plan_.deactivate, follower->name) && !has(plan_.activate, follower->name);
        if (stops && (is_command ? controller.takes_all_commands : controller.takes_all_states)) {
          continue;
        }
        if (stops) {
          return warn(subject + "currently active but it is requested to be deactivated.");
        }
      } else if (!has(plan_.activate, follower->name)) {
        return warn(subject + "currently inactive and it is not requested to be activated.");
      }
      if (!followers_are_ready(*follower)) {
        return false;
      }
      if (!is_command) {
        continue;
      }
      if (follower->is_in_chained_mode) {
        remove(plan_.from_chained_mode, follower->name);
      } else {
        add_once(plan_.to_chained_mode, follower->name);
      }
    }
    return true;
  }

  bool fallbacks_are_ready(const ControllerView& controller) {
    for (const std::string& name : controller.fallbacks) {
      const ControllerView* const fallback = find(controllers_, name);
      const std::string subject = "Unable to find the fallback controller : '" + name +
                                  "' of the controller : '" + controller.name +
                                  "' within the controller list";
      if (fallback == nullptr) {
        return warn(subject);
      }
      if (fallback->state != LifeState::kInactive && fallback->state != LifeState::kActive) {
        return warn("Controller with name '" + controller.name +
                    "' cannot be activated, as its fallback controller : '" + name +
                    "' need to be configured and be in inactive/active state!");
      }
    }
    return true;
  }

  bool may_stop(const ControllerView& controller) {
    if (controller.state != LifeState::kActive) {
      return warn("Controller with name '" + controller.name +
                  "' can not be deactivated since it is not active.");
    }
    for (const ControllerView& preceding : controllers_) {
      if (&preceding == &controller || !depends_on(preceding, controller)) {
        continue;
      }
      const std::string subject = "Unable to deactivate controller with name '" + controller.name +
                                  "' because preceding controller with name '" + preceding.name +
                                  "' is ";
      if (preceding.state == LifeState::kInactive && has(plan_.activate, preceding.name) &&
          !has(plan_.activate, controller.name)) {
        return warn(subject + "inactive and will be activated.");
      }
      if (preceding.state == LifeState::kActive && !has(plan_.deactivate, preceding.name)) {
        return warn(subject + "currently active and will not be deactivated.");
      }
    }
    return true;
  }

  bool depends_on(const ControllerView& preceding, const ControllerView& following) const {
    const auto is_its = [&](const std::string& interface) {
      return owner_of(interface, controllers_) == &following;
    };
    return (!preceding.takes_all_commands &&
            std::any_of(preceding.commands.begin(), preceding.commands.end(), is_its)) ||
           (!preceding.takes_all_states &&
            std::any_of(preceding.states.begin(), preceding.states.end(), is_its));
  }

  void restart_those_that_change_mode() {
    for (const ControllerView& controller : controllers_) {
      const bool changes = has(plan_.to_chained_mode, controller.name) ||
                           has(plan_.from_chained_mode, controller.name);
      if (changes && controller.state == LifeState::kActive &&
          !has(plan_.deactivate, controller.name)) {
        plan_.deactivate.push_back(controller.name);
        add_once(plan_.activate, controller.name);
      }
    }
  }

  bool interfaces_are_free() {
    std::set<std::string> freed;
    std::set<std::string> states = interfaces_.available_states;
    std::set<std::string> commands = interfaces_.available_commands;
    for (const ControllerView& controller : controllers_) {
      if (has(plan_.deactivate, controller.name)) {
        freed.insert(controller.commands.begin(), controller.commands.end());
      }
      if (has(plan_.activate, controller.name)) {
        commands.insert(controller.references.begin(), controller.references.end());
        states.insert(controller.exported_states.begin(), controller.exported_states.end());
      }
    }
    std::set<std::string> taken;
    for (const std::string& name : plan_.activate) {
      const ControllerView& controller = *find(controllers_, name);
      const std::string subject = "Unable to activate controller '" + name + "' since the ";
      for (const std::string& command : controller.commands) {
        const std::string text = subject + "command interface '" + command + "' ";
        if (commands.count(command) == 0) {
          return warn(text + "is not available.");
        }
        if (interfaces_.claimed_commands.count(command) > 0 && freed.count(command) == 0) {
          return warn(text + "is currently claimed by another controller.");
        }
        if (!taken.insert(command).second) {
          return warn(text + "will be used by another controller that is being activated.");
        }
      }
      for (const std::string& state : controller.states) {
        if (states.count(state) == 0) {
          return warn(subject + "state interface '" + state + "' is not available.");
        }
      }
    }
    return true;
  }

  void collect_interfaces() {
    for (const ControllerView& controller : controllers_) {
      if (has(plan_.activate, controller.name)) {
        plan_.start_interfaces.insert(plan_.start_interfaces.end(), controller.commands.begin(),
                                      controller.commands.end());
      }
      if (has(plan_.deactivate, controller.name)) {
        plan_.stop_interfaces.insert(plan_.stop_interfaces.end(), controller.commands.begin(),
                                     controller.commands.end());
      }
    }
  }

  const SwitchRequest& request_;
  const std::vector<ControllerView>& controllers_;
  const InterfacesNow& interfaces_;
  SwitchPlan plan_;
};

/// The controllers whose interfaces a controller needs.
Names followers_of(const ControllerView& controller,
                   const std::vector<ControllerView>& controllers) {
  Names result;
  for (const std::string& interface : needs_of(controller)) {
    const ControllerView* const owner = owner_of(interface, controllers);
    if (owner != nullptr && owner != &controller) {
      add_once(result, owner->name);
    }
  }
  return result;
}

}  // namespace

SwitchPlan plan_switch(const SwitchRequest& request, const std::vector<ControllerView>& controllers,
                       const InterfacesNow& interfaces) {
  return Planner(request, controllers, interfaces).plan();
}

std::vector<std::string> update_order(const std::vector<ControllerView>& controllers) {
  Names order;
  Names open;
  // Followers are placed before those that need them; the result is reversed.
  const std::function<void(const ControllerView&)> place = [&](const ControllerView& controller) {
    if (has(order, controller.name) || has(open, controller.name)) {
      return;
    }
    open.push_back(controller.name);
    for (const std::string& follower : followers_of(controller, controllers)) {
      place(*find(controllers, follower));
    }
    order.push_back(controller.name);
  };
  for (auto one = controllers.rbegin(); one != controllers.rend(); ++one) {
    place(*one);
  }
  std::reverse(order.begin(), order.end());
  return order;
}

std::vector<std::string> chain_of(const std::string& name,
                                  const std::vector<ControllerView>& controllers) {
  Names chain = {name};
  for (std::size_t before = 0; before != chain.size();) {
    before = chain.size();
    for (const ControllerView& controller : controllers) {
      for (const std::string& follower : followers_of(controller, controllers)) {
        if (has(chain, controller.name) || has(chain, follower)) {
          add_once(chain, controller.name);
          add_once(chain, follower);
        }
      }
    }
  }
  Names ordered;
  for (const ControllerView& controller : controllers) {
    if (has(chain, controller.name)) {
      ordered.push_back(controller.name);
    }
  }
  return ordered;
}

}  // namespace controller_manager
