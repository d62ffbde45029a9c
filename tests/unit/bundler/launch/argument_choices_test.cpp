// Which values of launch arguments are tried.
#include <gtest/gtest.h>

#include "bundler/launch/host/argument_choices.hpp"

namespace ros2wasm {
namespace {

using Given = std::map<std::string, std::string>;

LaunchArgument argument(const std::string& name, const std::string& value,
                        std::vector<std::string> choices = {}) {
  return {.name = name, .choices = std::move(choices), .value = value};
}

TEST(ArgumentTrials, AreOneValueThenTwoInTheOrderOfDeclaration) {
  const auto tried =
      argument_trials({argument("robot", "b", {"a", "b", "c", "a"}), argument("speed", "1.0"),
                       argument("fast", "true"), argument("loud", "False")},
                      100);
  EXPECT_TRUE(tried.is_complete);
  const std::vector<Given> expected{
      {{"robot", "a"}},
      {{"robot", "c"}},
      {{"fast", "false"}},
      {{"loud", "True"}},
      {{"robot", "a"}, {"fast", "false"}},
      {{"robot", "a"}, {"loud", "True"}},
      {{"robot", "c"}, {"fast", "false"}},
      {{"robot", "c"}, {"loud", "True"}},
      {{"fast", "false"}, {"loud", "True"}},
      {{"robot", "a"}, {"fast", "false"}, {"loud", "True"}},
      {{"robot", "c"}, {"fast", "false"}, {"loud", "True"}},
  };
  EXPECT_EQ(tried.trials, expected);
}

TEST(ArgumentTrials, AreNoMoreThanAskedFor) {
  std::vector<LaunchArgument> many;
  for (int i = 0; i < 40; ++i) many.push_back(argument("a" + std::to_string(i), "true"));
  const auto tried = argument_trials(many, 31);
  EXPECT_FALSE(tried.is_complete);
  ASSERT_EQ(tried.trials.size(), 31U);
  EXPECT_EQ(tried.trials.back(), (Given{{"a30", "false"}}));
  ASSERT_EQ(tried.names.size(), 31U);  // those of which each value is tried
  EXPECT_EQ(tried.names.back(), "a30");
  EXPECT_TRUE(argument_trials({}, 31).trials.empty());
  EXPECT_TRUE(argument_trials({argument("a", "1")}, 0).is_complete);
}

}  // namespace
}  // namespace ros2wasm
