// Ends by an exception that nobody catches.
#include <cstdio>
#include <stdexcept>

int main() {
  std::printf("last words");
  throw std::runtime_error("the wheel came off");
}
