// See nearest_name.hpp.
#include "sdf/nearest_name.hpp"

#include <algorithm>
#include <cstddef>
#include <numeric>

namespace ros2wasm_sim {
namespace {

constexpr std::size_t kMaxLength = 80;

std::size_t changes(const std::string& a, const std::string& b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t changed = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({changed, row[j] + 1, row[j - 1] + 1});
    }
  }
  return row[b.size()];
}

}  // namespace

std::string nearest_name(const std::string& wrong, const std::vector<std::string>& names) {
  if (wrong.size() > kMaxLength) {
    return "";
  }
  std::string result;
  std::size_t fewest = std::max<std::size_t>(2, wrong.size() / 2) + 1;
  for (const std::string& name : names) {
    const std::size_t difference =
        name.size() > wrong.size() ? name.size() - wrong.size() : wrong.size() - name.size();
    if (difference >= fewest) {
      continue;
    }
    const std::size_t count = changes(wrong, name);
    if (count < fewest) {
      fewest = count;
      result = name;
    }
  }
  return result;
}

}  // namespace ros2wasm_sim
