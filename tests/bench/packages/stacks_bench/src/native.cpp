#include "bench.hpp"

int main() {
  std::printf("%s\n", measured_navfn().c_str());
}
