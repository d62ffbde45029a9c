// Ends by terminate(): an exception reaches a function that promised none. With an argument, by
// abort().
#include <cstdlib>
#include <stdexcept>

namespace {

__attribute__((noinline)) void turn() {
  throw std::runtime_error("the brake is stuck");
}
__attribute__((noinline)) void promise() noexcept {
  turn();
}

}  // namespace

int main(int argc, char**) {
  if (argc > 1) std::abort();
  promise();
}
