// Switches of controllers: strictness, claims, chains and the order of updates.
#include <gtest/gtest.h>

#include "spawner/arguments.hpp"
#include "spawner/param_files.hpp"
#include "switch_plan.hpp"

namespace {

using namespace controller_manager;
using Names = std::vector<std::string>;

ControllerView view(const std::string& name, LifeState state, const Names& commands) {
  ControllerView result;
  result.name = name;
  result.state = state;
  result.commands = commands;
  return result;
}

struct Yard {
  std::vector<ControllerView> controllers = {view("a", LifeState::kActive, {"slew/position"}),
                                             view("b", LifeState::kInactive, {"slew/position"}),
                                             view("fresh", LifeState::kUnconfigured, {})};
  InterfacesNow interfaces = {{"slew/position"}, {"slew/position"}, {}};

  [[nodiscard]] SwitchPlan plan(const Names& activate, const Names& deactivate, bool strict) const {
    return plan_switch({activate, deactivate, strict}, controllers, interfaces);
  }
};

TEST(control_switch, a_claimed_command_is_refused) {
  const SwitchPlan plan = Yard().plan({"b"}, {}, true);
  EXPECT_FALSE(plan.ok);
  EXPECT_EQ(plan.message,
            "Unable to activate controller 'b' since the command interface 'slew/position' is "
            "currently claimed by another controller.");
  EXPECT_TRUE(plan.is_empty());
}

TEST(control_switch, a_swap_frees_what_it_needs) {
  const SwitchPlan plan = Yard().plan({"b"}, {"a"}, true);
  ASSERT_TRUE(plan.ok) << plan.message;
  EXPECT_EQ(plan.activate, Names{"b"});
  EXPECT_EQ(plan.deactivate, Names{"a"});
  EXPECT_EQ(plan.start_interfaces, Names{"slew/position"});
  EXPECT_EQ(plan.stop_interfaces, Names{"slew/position"});
}

TEST(control_switch, unknown_names_matter_to_strict_requests) {
  const SwitchPlan loose = Yard().plan({"b", "nonsense"}, {"a"}, false);
  ASSERT_TRUE(loose.ok) << loose.message;
  EXPECT_EQ(loose.activate, Names{"b"});
  const SwitchPlan strict = Yard().plan({"b", "nonsense"}, {"a"}, true);
  EXPECT_FALSE(strict.ok);
  EXPECT_EQ(strict.message,
            "Could not activate controller with name 'nonsense' because no controller with this "
            "name exists");
  EXPECT_TRUE(strict.is_empty());
  EXPECT_FALSE(Yard().plan({"nonsense"}, {}, false).ok);
}

TEST(control_switch, states_are_checked) {
  EXPECT_FALSE(Yard().plan({"fresh"}, {}, true).ok);
  const SwitchPlan nothing = Yard().plan({"fresh", "a"}, {"b"}, false);
  EXPECT_TRUE(nothing.ok);
  EXPECT_TRUE(nothing.is_empty());
  EXPECT_EQ(nothing.message,
            "After checking the controllers, no controllers need to be activated or deactivated.");
  EXPECT_EQ(Yard().plan({}, {"b"}, true).message,
            "Controller with name 'b' can not be deactivated since it is not active.");
}

/// drive commands the reference of a speed controller, which commands the wheel.
struct Chain {
  std::vector<ControllerView> controllers;
  InterfacesNow interfaces = {{"wheel/velocity"}, {}, {}};

  Chain(LifeState drive_state, LifeState speed_state) {
    ControllerView speed = view("speed", speed_state, {"wheel/velocity"});
    speed.is_chainable = true;
    speed.references = {"speed/wheel/velocity"};
    controllers = {speed, view("drive", drive_state, {"speed/wheel/velocity"})};
    if (speed_state == LifeState::kActive) {
      interfaces.available_commands.insert("speed/wheel/velocity");
      interfaces.claimed_commands.insert("wheel/velocity");
    }
    if (drive_state == LifeState::kActive) {
      controllers[0].is_in_chained_mode = true;
      interfaces.claimed_commands.insert("speed/wheel/velocity");
    }
  }
  [[nodiscard]] SwitchPlan plan(const Names& activate, const Names& deactivate) const {
    return plan_switch({activate, deactivate, true}, controllers, interfaces);
  }
};

TEST(control_switch, a_follower_must_be_there) {
  const Chain chain(LifeState::kInactive, LifeState::kInactive);
  EXPECT_EQ(chain.plan({"drive"}, {}).message,
            "The following controller with name 'speed' is currently inactive and it is not "
            "requested to be activated.");
  const SwitchPlan together = chain.plan({"drive", "speed"}, {});
  ASSERT_TRUE(together.ok) << together.message;
  EXPECT_EQ(together.to_chained_mode, Names{"speed"});
  EXPECT_EQ(together.activate, (Names{"drive", "speed"}));
}

TEST(control_switch, an_active_follower_restarts_in_chained_mode) {
  const SwitchPlan plan = Chain(LifeState::kInactive, LifeState::kActive).plan({"drive"}, {});
  ASSERT_TRUE(plan.ok) << plan.message;
  EXPECT_EQ(plan.deactivate, Names{"speed"});
  EXPECT_EQ(plan.activate, (Names{"drive", "speed"}));
  EXPECT_EQ(plan.to_chained_mode, Names{"speed"});
}

TEST(control_switch, a_follower_in_use_stays) {
  const Chain chain(LifeState::kActive, LifeState::kActive);
  EXPECT_EQ(chain.plan({}, {"speed"}).message,
            "Unable to deactivate controller with name 'speed' because preceding controller with "
            "name 'drive' is currently active and will not be deactivated.");
  const SwitchPlan alone = chain.plan({}, {"drive"});
  ASSERT_TRUE(alone.ok) << alone.message;
  EXPECT_EQ(alone.from_chained_mode, Names{"speed"});
  EXPECT_EQ(alone.deactivate, (Names{"drive", "speed"}));
  EXPECT_EQ(alone.activate, Names{"speed"});
}

TEST(control_switch, updates_go_from_the_head_of_a_chain) {
  std::vector<ControllerView> controllers =
      Chain(LifeState::kInactive, LifeState::kInactive).controllers;
  controllers.insert(controllers.begin(), view("first", LifeState::kInactive, {}));
  controllers.push_back(view("last", LifeState::kInactive, {}));
  EXPECT_EQ(update_order(controllers), (Names{"first", "drive", "speed", "last"}));
  EXPECT_EQ(chain_of("speed", controllers), (Names{"speed", "drive"}));
  EXPECT_EQ(chain_of("last", controllers), Names{"last"});
}

TEST(control_spawner, options_are_read) {
  const SpawnerOptions options = read_spawner_arguments(
      {"one", "two", "-c", "/yard/cm", "--inactive", "-p", "a.yaml", "--param-file=b.yaml",
       "--switch-timeout", "2.5", "--controller-ros-args", "-r x:=y"});
  ASSERT_EQ(options.controllers.size(), 2U);
  EXPECT_EQ(options.controllers[1].name, "two");
  EXPECT_TRUE(options.controllers[1].inactive);
  EXPECT_EQ(options.controllers[0].param_files, (Names{"a.yaml", "b.yaml"}));
  EXPECT_EQ(options.controllers[0].ros_args, (Names{"-r", "x:=y"}));
  EXPECT_EQ(options.controller_manager, "/yard/cm");
  EXPECT_DOUBLE_EQ(options.switch_timeout, 2.5);
  EXPECT_TRUE(options.switch_asap);
}

TEST(control_spawner, the_advanced_form_has_options_per_controller) {
  const SpawnerOptions options = read_spawner_arguments(
      {"--activate-as-group", "--controller", "one", "--load-only", "--controller", "two"});
  ASSERT_EQ(options.controllers.size(), 2U);
  EXPECT_TRUE(options.controllers[0].load_only);
  EXPECT_FALSE(options.controllers[1].load_only);
  EXPECT_TRUE(options.activate_as_group);
  EXPECT_FALSE(options.switch_asap);
}

TEST(control_spawner, mistakes_end_with_code_2) {
  for (const Names& arguments : {Names{}, Names{"x", "--nonsense"}, Names{"x", "-c"},
                                 Names{"x", "--switch-timeout", "soon"}}) {
    try {
      read_spawner_arguments(arguments);
      ADD_FAILURE() << "was read";
    } catch (const UsageError& error) {
      EXPECT_EQ(error.exit_code, 2);
      EXPECT_NE(error.text.find("spawner: error: "), std::string::npos) << error.text;
    }
  }
}

TEST(SpawnerParameters, OfLaunchFilesGoToTheirController) {
  const Names arguments = {"spawner",
                           "wheels",
                           "--ros-args",
                           "-p",
                           "prefix:='a'",
                           "-p",
                           "/wheels:type:='pkg/Wheels'",
                           "-p",
                           "/arm:type:='pkg/Arm'",
                           "-p",
                           "/wheels:names:=['l', 'r']",
                           "-p",
                           "/**:rate:=5",
                           "-p",
                           "/wheels:fallback_controllers:=['brake']"};
  const ControllerArgumentFacts facts = read_param_arguments("wheels", "/", arguments);
  EXPECT_EQ(facts.type, "pkg/Wheels");
  EXPECT_EQ(facts.fallbacks, Names{"brake"});
  EXPECT_EQ(facts.ros_args, (Names{"--ros-args", "-p", "/wheels:type:='pkg/Wheels'", "-p",
                                   "/wheels:names:=['l', 'r']", "-p", "/**:rate:=5", "-p",
                                   "/wheels:fallback_controllers:=['brake']"}));
  EXPECT_TRUE(read_param_arguments("wheels", "/left", {"-p", "/wheels:type:='a/B'"}).type.empty());
  EXPECT_EQ(read_param_arguments("wheels", "/left", {"-p", "/left/wheels:type:='a/B'"}).type,
            "a/B");
  EXPECT_TRUE(read_param_arguments("wheels", "/", {"-p", "type:='a/B'"}).ros_args.empty());
}

}  // namespace
