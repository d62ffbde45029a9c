// What differs between the machine of a site (wasm32, with musl and LLVM's C++ library) and those
// that ROS 2 is run on.

// Compatibility, differs: `long`, `unsigned long`, `size_t`, `time_t` and pointers -> have 32 bits:
// LONG_MAX, `sizeof(long)`, `std::numeric_limits<long>`, and the sizes of structures that hold such
// members, and `long` overflows there. What the compiler sees (a 64-bit value for a `long` without
// a cast) is a warning (R2W0525); `std::stol` throws out_of_range, `strtol` and `atol` stop at
// LONG_MAX. `int64_t` is a `long long`, so a function that is overloaded for `long` alone is
// ambiguous for it, and `time_t` ends in January 2038

// Compatibility, differs: numbers from `std::uniform_int_distribution`, `normal_distribution`,
// `std::shuffle`, `rand` of a seed and `std::hash`, and so the order of `unordered_map` -> those of
// LLVM's library and musl; the engines (`mt19937`) give the same

// Compatibility, differs: `what()` of exceptions of the C++ library -> LLVM's words ("vector" for
// `at()`, "stoi: no conversion")

// Compatibility, differs: `long double` -> has 113 bits of mantissa instead of 64, and is computed
// in software

// Compatibility, differs: locales -> each name is taken, and each is the C locale with UTF-8

// Compatibility, differs: the file system of a node -> has no /proc, /sys and /etc; `argv[0]` is
// the name of the program

#include <climits>
#include <clocale>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <fstream>
#include <limits>
#include <locale>
#include <random>
#include <sstream>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

#include "checks.hpp"

namespace {

void widths(Checks& checks) {
  CHECK(sizeof(long) == 4 && sizeof(size_t) == 4 && sizeof(void*) == 4 && sizeof(std::time_t) == 4);
  CHECK(LONG_MAX == INT32_MAX && std::numeric_limits<long>::max() == INT32_MAX);
  CHECK((std::is_same<int64_t, long long>::value));
  CHECK_THROWS(std::out_of_range, (void)std::stol("5000000000"));
  CHECK(std::stoll("5000000000") == 5'000'000'000);
  CHECK(std::strtol("5000000000", nullptr, 10) == LONG_MAX);
  CHECK(std::to_string(int64_t{5'000'000'000}) == "5000000000");
  std::ostringstream stream;
  stream << int64_t{-5'000'000'000} << ' ' << sizeof(int64_t);
  CHECK(stream.str() == "-5000000000 8");
  // As on x86-64.
  CHECK(sizeof(wchar_t) == 4 && alignof(double) == 8 && alignof(int64_t) == 8);
  CHECK(std::numeric_limits<char>::is_signed);
}

void numbers(Checks& checks) {
  CHECK(std::mt19937(42)() == 1608637542);
  CHECK(std::numeric_limits<long double>::digits == 113);
  std::ostringstream stream;
  stream << 0.1 << ' ' << 1e21 << ' ' << 1.0 / 3 << ' ' << 100000.0 << ' ' << 1000000.0 << ' '
         << 0.1F;
  CHECK(stream.str() == "0.1 1e+21 0.333333 100000 1e+06 0.1");
  stream.str("");
  stream << std::numeric_limits<double>::infinity() << ' ' << -std::nan("");
  CHECK(stream.str() == "inf -nan");
  CHECK(std::to_string(0.1) == "0.100000");
}

void texts(Checks& checks) {
  std::string said;
  try {
    (void)std::vector<int>().at(1);
  } catch (const std::out_of_range& error) {
    said = error.what();
  }
  CHECK(said == "vector");
  try {
    (void)std::stoi("none");
  } catch (const std::invalid_argument& error) {
    said = error.what();
  }
  CHECK(said == "stoi: no conversion");
  CHECK(std::setlocale(LC_ALL, "de_DE.UTF-8") != nullptr);
  CHECK(std::locale("de_DE.UTF-8").name() == "de_DE.UTF-8");
  std::setlocale(LC_ALL, "C");
}

int depth_of(int left) {
  volatile char frame[128];
  frame[0] = static_cast<char>(left);
  return left == 0 ? frame[0] : depth_of(left - 1) + 1;
}

}  // namespace

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  Checks checks("platform");
  widths(checks);
  numbers(checks);
  texts(checks);
  CHECK(std::string(argv[0]).find("platform") != std::string::npos);
  CHECK(!std::ifstream("/proc/self/status"));
  CHECK(depth_of(10'000) == 10'000);
  return checks.finish();
}
