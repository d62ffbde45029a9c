// Handles and the ledger of interfaces of ros2_control.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <utility>

#include "hardware_interface/handle.hpp"
#include "hardware_interface/lexical_casts.hpp"
#include "interface_ledger.hpp"

namespace {

using hardware_interface::CommandInterface;
using hardware_interface::InterfaceLedger;
using hardware_interface::StateInterface;

TEST(control_handles, the_older_form_refers_to_a_double) {
  double value = 1.5;
  StateInterface state("slew", "position", &value);
  EXPECT_EQ(state.get_name(), "slew/position");
  EXPECT_EQ(state.get_prefix_name(), "slew");
  EXPECT_EQ(state.get_interface_name(), "position");
  value = 2.5;
  EXPECT_DOUBLE_EQ(state.get_value(), 2.5);
  StateInterface copy(state);
  ASSERT_TRUE(copy.set_value(3.5));
  EXPECT_DOUBLE_EQ(value, 3.5);
  EXPECT_DOUBLE_EQ(state.get_optional().value(), 3.5);
}

TEST(control_handles, the_newer_form_has_a_value_of_its_type) {
  StateInterface number("slew", "position");
  EXPECT_TRUE(std::isnan(number.get_optional().value()));
  StateInterface start("slew", "position", "double", "0.25");
  EXPECT_DOUBLE_EQ(start.get_optional().value(), 0.25);
  StateInterface moved(std::move(start));
  ASSERT_TRUE(moved.set_value(0.5));
  EXPECT_DOUBLE_EQ(moved.get_optional().value(), 0.5);

  StateInterface lamp("lamp", "on", "bool");
  EXPECT_FALSE(lamp.get_optional<bool>().value());
  ASSERT_TRUE(lamp.set_value(true));
  EXPECT_TRUE(lamp.get_optional<bool>().value());
  EXPECT_THROW(std::ignore = lamp.get_optional(), std::runtime_error);
  EXPECT_THROW(std::ignore = lamp.set_value<std::uint8_t>(1), std::runtime_error);
  StateInterface count("lamp", "count", "uint8");
  EXPECT_EQ(count.get_optional<std::uint8_t>().value(), std::numeric_limits<std::uint8_t>::max());
  EXPECT_THROW(StateInterface("a", "b", "text"), std::runtime_error);
  EXPECT_THROW(StateInterface("a", "b", "double", "1.5x"), std::invalid_argument);
}

TEST(control_handles, a_locked_value_is_not_waited_for) {
  CommandInterface command("slew", "position", "double", "1");
  const std::unique_lock<std::shared_mutex> lock(command.get_mutex());
  EXPECT_FALSE(command.get_optional().has_value());
  EXPECT_FALSE(command.set_value(2.0));
  EXPECT_TRUE(std::isnan(command.get_value()));
}

TEST(control_handles, a_limiter_sees_each_command) {
  CommandInterface command("slew", "position");
  command.set_on_set_command_limiter([](double value, bool& limited) {
    limited = value > 1.0;
    return limited ? 1.0 : value;
  });
  ASSERT_TRUE(command.set_limited_value(3.0));
  EXPECT_DOUBLE_EQ(command.get_optional().value(), 1.0);
  EXPECT_TRUE(command.is_limited());
}

TEST(control_handles, texts_become_values) {
  EXPECT_DOUBLE_EQ(hardware_interface::stod("-1.5e2"), -150.0);
  EXPECT_THROW(hardware_interface::stod("1,5"), std::invalid_argument);
  EXPECT_THROW(hardware_interface::stod("inf"), std::invalid_argument);
  EXPECT_EQ(hardware_interface::stoi8("-128"), -128);
  EXPECT_THROW(hardware_interface::stoui8("256"), std::out_of_range);
  EXPECT_THROW(hardware_interface::stoui8("-1"), std::out_of_range);
  EXPECT_TRUE(hardware_interface::parse_bool("TrUe"));
  EXPECT_THROW(hardware_interface::parse_bool("1"), std::invalid_argument);
  EXPECT_EQ(hardware_interface::parse_array<int>("[1, 2 , 3]"), (std::vector<int>{1, 2, 3}));
  EXPECT_TRUE(hardware_interface::parse_string_array("[ ]").empty());
  EXPECT_THROW(hardware_interface::parse_string_array("[a, [b]]"), std::invalid_argument);
}

TEST(control_handles, a_command_is_claimed_once) {
  InterfaceLedger ledger;
  ledger.add(std::make_shared<CommandInterface>("slew", "position"));
  EXPECT_THROW(ledger.add(std::make_shared<CommandInterface>("slew", "position")),
               std::runtime_error);
  EXPECT_THROW(ledger.claim("slew/position"), std::runtime_error);  // not available yet
  ledger.set_commands_available({"slew/position"}, true);
  EXPECT_NE(ledger.claim("slew/position"), nullptr);
  EXPECT_TRUE(ledger.is_claimed("slew/position"));
  EXPECT_THROW(ledger.claim("slew/position"), std::runtime_error);
  ledger.release("slew/position");
  EXPECT_FALSE(ledger.is_claimed("slew/position"));
  ledger.set_commands_available({"slew/position"}, false);
  EXPECT_EQ(ledger.available_command("slew/position"), nullptr);
  EXPECT_EQ(ledger.commands(), std::vector<std::string>{"slew/position"});
}

}  // namespace
