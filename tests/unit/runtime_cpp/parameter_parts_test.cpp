// Parts of generated parameter headers, below ROS: the texts of refused values, and strings and
// vectors that never allocate.
#include <gtest/gtest.h>

#include <array>
#include <numeric>

#include "ros2wasm_parameters/refusals.hpp"
#include "rsl/algorithm.hpp"
#include "rsl/static_string.hpp"
#include "rsl/static_vector.hpp"
#include "tcb_span/span.hpp"

namespace {

using namespace ros2wasm_parameters;

TEST(ParameterTexts, AreThoseOfGenerateParameterLibrary) {
  EXPECT_EQ(refused("a.b", 0.5, "less than", 0.25),
            "Parameter 'a.b' with the value '0.5' must be less than '0.25'");
  EXPECT_EQ(refused<int64_t>("n", 1234567, "greater than", 12345678901),
            "Parameter 'n' with the value '1234567' must be greater than '12345678901'");
  EXPECT_EQ(out_of_bounds("r", 1e7, 0.0, 1.0),
            "Parameter 'r' with the value '1e+07' must be within bounds '[0, 1]'");
  EXPECT_EQ(element_out_of_bounds("r", 2.0, 0.0, 1.0),
            "Value '2' in parameter 'r' must be within bounds '[0, 1]'");
  EXPECT_EQ(element_refused("r", 2.0, "below upper bound of", 1.0),
            "Value '2' in parameter 'r' must be below upper bound of '1'");
  EXPECT_EQ(length_refused("s", 3, "equal to", 2),
            "Length of parameter 's' is '3' but must be equal to '2'");
  EXPECT_EQ(not_in_set<std::string>("m", "c", {"a", "b"}),
            "Parameter 'm' with the value 'c' is not in the set '{a, b}'");
  EXPECT_EQ(entry_not_in_set("f", true, {false, false}),
            "Entry 'true' in parameter 'f' is not in the set '{false, false}'");
}

TEST(StaticString, HasItsCapacityOnly) {
  const rsl::StaticString<4> text(std::string("a\0c", 3));
  EXPECT_EQ(rsl::to_string(text), std::string("a\0c", 3));
  EXPECT_EQ(std::string_view(text).size(), 3U);
  EXPECT_EQ(rsl::to_string(rsl::StaticString<4>()), "");
  EXPECT_EQ(rsl::to_string(rsl::StaticString<4>(std::string("abcd"))), "abcd");
}

TEST(StaticVector, IsMadeOfListsAndContainersAndSeenAsASpan) {
  rsl::StaticVector<double, 3> values = {1.0, 2.0};
  for (double& value : values) value *= 2.0;
  EXPECT_EQ(rsl::to_vector(values), (std::vector<double>{2.0, 4.0}));
  const tcb::span<const double> view = std::as_const(values);
  EXPECT_EQ(std::accumulate(view.begin(), view.end(), 0.0), 6.0);
  const rsl::StaticVector<int64_t, 2> numbers = std::vector<int64_t>{7, 8};
  EXPECT_EQ(rsl::to_vector(numbers), (std::vector<int64_t>{7, 8}));
  const rsl::StaticVector<std::string, 2> texts = {"a", "b"};
  EXPECT_EQ(rsl::to_vector(texts), (std::vector<std::string>{"a", "b"}));
}

TEST(Span, ViewsWhatOthersOwn) {
  std::vector<int> values{1, 2, 3, 4};
  tcb::span<int> view(values);
  view[1] = 5;
  EXPECT_EQ(values[1], 5);
  EXPECT_EQ(view.subspan(2).front(), 3);
  EXPECT_EQ(view.first(2).back(), 5);
  EXPECT_EQ(view.last(1).size(), 1U);
  const tcb::span<const int> constant = view;
  EXPECT_EQ(constant.size_bytes(), 4 * sizeof(int));
  const std::array<int, 2> fixed{8, 9};
  EXPECT_EQ(tcb::span(fixed).back(), 9);
  EXPECT_TRUE(tcb::span<int>().empty());
  EXPECT_FALSE((std::is_convertible_v<std::vector<const char*>&, tcb::span<int>>));
}

TEST(Algorithm, LooksIntoContainers) {
  EXPECT_TRUE(rsl::contains(std::vector<int>{1, 2}, 2));
  EXPECT_FALSE(rsl::contains(std::vector<int>{1, 2}, 3));
  EXPECT_TRUE(rsl::is_unique(std::vector<bool>{true, false}));
  EXPECT_FALSE(rsl::is_unique(std::vector<std::string>{"a", "b", "a"}));
}

}  // namespace
