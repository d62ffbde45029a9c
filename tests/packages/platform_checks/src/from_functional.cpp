#include <functional>

int from_functional() {
  std::vector<int> numbers = {3, 1, 2};
  std::sort(numbers.begin(), numbers.end(), std::less<int>());
  return numbers.front();
}
