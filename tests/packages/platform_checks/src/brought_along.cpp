// Each header alone brings what it does with g++: programs are written against that.

// Compatibility, works: what g++'s headers bring along: `std::max` with `<cmath>`, `std::size_t`
// with `<cstdint>`, `std::sort` with
// `<functional>`, `std::string` with `<stdexcept>`, `sleep()` with `rclcpp.hpp`, glibc's options in
// `<malloc.h>`, and the like

#include "along_cmath.hpp"
#include "along_cstdint.hpp"
#include "along_malloc.hpp"
#include "checks.hpp"

int from_functional();
int from_stdexcept();

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  Checks checks("brought_along");
  CHECK(larger(2, 3) == 3);
  CHECK(bytes_of_int() == 4);
  CHECK(allocator_takes_options() >= 0);
  CHECK(from_functional() == 1);
  CHECK(from_stdexcept() == 4);
  CHECK(::sleep(0) == 0);
  return checks.finish();
}
