// C++20 as Jazzy's own compilers have it.

// Compatibility, works: of the C++20 library also std::format (with `std::formatter<T>` of the
// user's own), bit_cast, source_location, the common algorithms of std::ranges with projections,
// std::views filter, transform, take, drop, reverse, iota, elements, keys and values, jthread,
// stop_token and stop_callback

// Compatibility, differs: the rest of the newer C++ library -> the site's compiler has no views
// beyond those and all and common, no ranges::to, condition_variable_any with a stop_token, format
// of chrono, coroutines, expected, pmr or from_chars of floating point: the build names what is
// missing

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <format>
#include <iterator>
#include <map>
#include <numeric>
#include <ranges>
#include <source_location>
#include <span>
#include <string>
#include <vector>

#include "checks.hpp"
#include "rclcpp/version.h"

// rclcpp.hpp brings it, as with GCC's library.
static_assert(std::numbers::pi > 3.14 && std::numbers::pi < 3.15);

namespace {

struct Reading {
  int id = 0;
  std::string name;
};

int line(const std::source_location& here = std::source_location::current()) {
  return static_cast<int>(here.line());
}

enum class Level { kLow, kHigh };
struct Place {
  int x = 0;
  int y = 0;
};

}  // namespace

namespace std {
template <>
struct formatter<Level> : formatter<string_view> {
  auto format(Level level, format_context& context) const {
    return formatter<string_view>::format(level == Level::kLow ? "low" : "high", context);
  }
};
template <>
struct formatter<Place> {
  constexpr auto parse(format_parse_context& context) { return context.begin(); }
  auto format(const Place& place, format_context& context) const {
    return std::format_to(context.out(), "({}, {})", place.x, place.y);
  }
};
}  // namespace std

template <>
struct std::formatter<Reading> : std::formatter<std::string> {
  auto format(const Reading& reading, std::format_context& context) const {
    return std::formatter<std::string>::format("<" + reading.name + ">", context);
  }
};

namespace {

template <class R>
std::vector<int> list(R&& range) {
  return {std::ranges::begin(range), std::ranges::end(range)};
}

void check_views(Checks& checks) {
  namespace views = std::views;
  std::vector<int> numbers = {1, 2, 3, 4, 5, 6};
  int divisor = 2;
  const auto holds = [&divisor](int one) { return one % divisor == 0; };
  auto even = numbers | views::filter(holds);
  CHECK(list(even) == (std::vector<int>{2, 4, 6}) && *std::ranges::min_element(even) == 2);
  CHECK(list(even | views::transform([](int one) { return one * one; })) ==
        (std::vector<int>{4, 16, 36}));
  CHECK(list(even | views::reverse | views::take(2)) == (std::vector<int>{6, 4}));
  CHECK(std::ranges::distance(even) == 3 && std::accumulate(even.begin(), even.end(), 0) == 12);
  divisor = 7;
  CHECK(even.empty() &&
        views::filter(numbers, holds).begin() == views::filter(numbers, holds).end());
  const auto middle = views::drop(1) | views::take(3);
  CHECK(list(numbers | middle) == (std::vector<int>{2, 3, 4}) &&
        list(numbers | views::take(99)).size() == 6);
  CHECK(list(views::iota(3, 6)) == (std::vector<int>{3, 4, 5}) &&
        list(std::ranges::views::iota(8) | views::take(2)) == (std::vector<int>{8, 9}));
  for (int& one : numbers | views::filter([](int number) { return number > 5; })) {
    one = 0;
  }
  CHECK(numbers.back() == 0);
  std::map<std::string, int> heights = {{"a", 3}, {"b", 4}};
  for (int& height : heights | views::values) {
    height += 1;
  }
  std::string names;
  for (const std::string& name : heights | views::keys) {
    names += name;
  }
  CHECK(names == "ab" && heights["b"] == 5);
  // What is made on the way is not referred to.
  auto made = views::iota(1, 4) | views::transform([](int one) {
                return std::pair(one, std::string(40, static_cast<char>('0' + one)));
              });
  auto texts = made | views::values;
  static_assert(std::is_same_v<decltype(*texts.begin()), std::string>);
  static_assert(std::is_same_v<decltype(*(heights | views::values).begin()), int&>);
  std::string joined;
  for (const std::string& one : texts) {
    joined += one.substr(38);
  }
  CHECK(joined == "112233" && list(made | views::keys) == (std::vector<int>{1, 2, 3}));
}

}  // namespace

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  Checks checks("newer_cpp");
  std::vector<Reading> readings = {{3, "c"}, {1, "a"}, {2, "b"}};
  CHECK(std::format("{:.2f} {:>4}|{:04d} {:#x} {}", 2.5, "ab", 7, 255, readings[1]) ==
        "2.50   ab|0007 0xff <a>");
  CHECK_THROWS(std::format_error, (void)std::vformat("{:d}", std::make_format_args("text")));
  std::string text;
  std::format_to(std::back_inserter(text), "{1} {0}", 1, 2);
  CHECK(text == "2 1" && std::formatted_size("{}", 1000) == 4);

  std::ranges::sort(readings, {}, &Reading::id);
  CHECK(readings.front().name == "a" && std::ranges::is_sorted(readings, {}, &Reading::name));
  std::ranges::sort(readings, std::ranges::greater{}, &Reading::id);
  CHECK(readings.front().id == 3);
  CHECK(std::ranges::find(readings, 2, &Reading::id)->name == "b");
  CHECK(std::ranges::find_if(
            readings, [](int id) { return id > 9; }, &Reading::id) == readings.end());
  CHECK(std::ranges::count_if(readings, [](const Reading& one) { return one.id > 1; }) == 2);
  CHECK(std::ranges::any_of(readings, [](const Reading& one) { return one.name == "c"; }));
  CHECK(std::ranges::none_of(
      readings, [](int id) { return id == 0; }, &Reading::id));
  const std::array<double, 4> values = {1.5, 0.5, 2.5, 2.0};
  const std::span<const double> span(values);
  const auto [least, most] = std::ranges::minmax_element(span);
  CHECK(*least == 0.5 && *most == 2.5 && *std::ranges::min_element(span) == 0.5);
  CHECK(std::ranges::max(3, 5) == 5 && std::ranges::min({4, 2, 8}) == 2 &&
        std::ranges::max(values) == 2.5);
  CHECK(std::ranges::max(std::string("a"), std::string("b")) == "b");
  std::vector<int> ids;
  std::ranges::transform(readings, std::back_inserter(ids), &Reading::id);
  std::ranges::reverse(ids);
  CHECK((ids == std::vector<int>{1, 2, 3}));
  std::vector<int> large;
  std::ranges::copy_if(ids, std::back_inserter(large), [](int id) { return id > 1; });
  int sum = 0;
  std::ranges::for_each(large, [&sum](int id) { sum += id; });
  CHECK(sum == 5 && std::ranges::equal(large, std::array{2, 3}));

  check_views(checks);
  CHECK(std::format("{:>5}|{:_<4}|{}", Level::kHigh, Level::kLow, Place{1, -2}) ==
        " high|low_|(1, -2)");
  CHECK(std::bit_cast<std::uint64_t>(1.0) == 0x3ff0000000000000U);
  CHECK(line() == __LINE__);
  CHECK(RCLCPP_VERSION_GTE(28, 0, 0) && !RCLCPP_VERSION_GTE(29, 0, 0));
  return checks.finish();
}
