#include <stdexcept>

int from_stdexcept() {
  const std::string text = "four";
  return static_cast<int>(text.size());
}
