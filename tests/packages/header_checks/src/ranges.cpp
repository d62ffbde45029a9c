#include <range/v3/algorithm/sort.hpp>
#include <range/v3/numeric/accumulate.hpp>
#include <range/v3/range/conversion.hpp>
#include <range/v3/view/filter.hpp>
#include <range/v3/view/iota.hpp>
#include <range/v3/view/take.hpp>
#include <range/v3/view/transform.hpp>
#include <range/v3/view/zip.hpp>
#include <string>
#include <vector>

#include "expect.hpp"

void check_ranges(Expectations& expectations) {
  const auto is_odd = [](int number) { return number % 2 == 1; };
  const auto square = [](int number) { return number * number; };
  auto squares = ranges::views::iota(1) | ranges::views::filter(is_odd) |
                 ranges::views::transform(square) | ranges::views::take(4);
  EXPECT((squares | ranges::to<std::vector<int>>()) == (std::vector<int>{1, 9, 25, 49}));
  EXPECT(ranges::accumulate(squares, 0) == 84);
  std::vector<int> ids = {3, 1, 2};
  std::vector<std::string> names = {"map", "base", "odom"};
  ranges::sort(ranges::views::zip(ids, names));
  EXPECT(names.front() == "base" && names.back() == "map");
}
