// Texts of formats are those of a 64-bit machine, where int64_t is a long.

// Compatibility, works: formats of the logging macros of rclcpp and rcutils, of the families of
// printf and scanf, and of syslog in C++ read each integer by the width that `%ld`, `%lu`, `%zu`,
// `%jd` and their like have on a 64-bit machine

// Compatibility, differs: formats in C, and of functions of a package that take `...` -> `long` has
// 32 bits in a site; a 64-bit argument for `%ld` is an error of the compiler where it can see the
// format (R2W0502), and a function that hands on a va_list without `__attribute__((format))` gets a
// warning (R2W0525); wide ones (`wprintf`) are not looked at

#include <fcntl.h>
#include <unistd.h>

#include <cinttypes>
#include <cstdarg>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <string>

#include "checks.hpp"
#include "rcutils/format_string.h"
#include "rcutils/logging_macros.h"
#include "rcutils/snprintf.h"

namespace {

std::string logged;
void keep(const rcutils_log_location_t*, int, const char*, rcutils_time_point_value_t,
          const char* format, va_list* args) {
  char text[256];
  std::vsnprintf(text, sizeof(text), format, *args);
  logged = text;
}

template <typename... A>
std::string text_of(const char* format, A... arguments) {
  char text[512];
  const int length = std::snprintf(text, sizeof(text), format, arguments...);
  return length == static_cast<int>(std::strlen(text)) ? text : "a wrong length";
}

enum Plain { kSeven = 7 };
/// Its member is nobody's printf.
struct Printer {
  int printf(const char*, int value) { return value; }
};

void log_texts(Checks& checks) {
  const rclcpp::Logger logger = rclcpp::get_logger("texts");
  const rcutils_logging_output_handler_t earlier = rcutils_logging_get_output_handler();
  rcutils_logging_set_output_handler(keep);
  const int64_t a = 41;
  const int64_t b = 17;
  RCLCPP_INFO(logger, "a: %ld b: %ld", a, b);
  const std::string two = logged;
  RCLCPP_WARN_ONCE(logger, "id=%ld name=%s", a, "turtle");
  const std::string named = logged;
  RCLCPP_ERROR_EXPRESSION(logger, true, "%lu of %zu", static_cast<uint64_t>(-1), sizeof(b));
  const std::string counted = logged;
  RCUTILS_LOG_INFO_NAMED("texts", "%ld ns", static_cast<int64_t>(1'700'000'000'123'456'789));
  const std::string time = logged;
  rcutils_log(nullptr, RCUTILS_LOG_SEVERITY_INFO, "texts", "%*ld|%s", 4, b, "end");
  const std::string direct = logged;
  RCLCPP_INFO(logger, "plain");
  const std::string plain = logged;
  rcutils_logging_set_output_handler(earlier);
  CHECK(two == "a: 41 b: 17");
  CHECK(named == "id=41 name=turtle");
  CHECK(counted == "18446744073709551615 of 8");
  CHECK(time == "1700000000123456789 ns");
  CHECK(direct == "  17|end");
  CHECK(plain == "plain");
}

void integers(Checks& checks) {
  const int64_t low = -9'000'000'000;
  const uint64_t most = UINT64_MAX;
  long narrow = -3;
  unsigned long narrow_unsigned = 4'000'000'000;
  const size_t size = 12;
  CHECK(text_of("%ld %c", low, 'x') == "-9000000000 x");
  CHECK(text_of("%lu %lx %lX %lo", most, most, most, most) ==
        "18446744073709551615 ffffffffffffffff FFFFFFFFFFFFFFFF 1777777777777777777777");
  CHECK(text_of("%li %lld %lu", narrow, static_cast<long long>(narrow), narrow_unsigned) ==
        "-3 -3 4000000000");
  CHECK(text_of("%zu %lu %zd %jd %td %lld", size, size, static_cast<ssize_t>(-1),
                static_cast<intmax_t>(low), static_cast<ptrdiff_t>(5),
                low) == "12 12 -1 -9000000000 5 -9000000000");
  CHECK(text_of("%" PRId64 " %" PRIu64, low, most) == "-9000000000 18446744073709551615");
  CHECK(text_of("%d %d %hhu %hhd %hu %d", true, kSeven, 255, 255, 65535, 'a') ==
        "1 7 255 -1 65535 97");
  CHECK(text_of("%*ld|%-*ld|%0*ld|%.*ld", 5, low / low, 3, low / low, 4, low / low, 3, low / low) ==
        "    1|1  |0001|001");
  CHECK(text_of("%3$s %1$ld %2$s", low, "a", "b") == "b -9000000000 a");
  CHECK(text_of("%2$*1$ld|%2$ld", 4, int64_t{41}) == "  41|41");
  // An argument has a register of its own there, so one of another width spoils none that follows.
  CHECK(text_of("%d %s", int64_t{41}, "next") == "41 next");
}

void others(Checks& checks) {
  CHECK(text_of("%.1Lf %.2f %g %5.*f", 3.5L, 2.25, 2.5F, 1, 0.5) == "3.5 2.25 2.5   0.5");
  CHECK(text_of("100%% %s %p", "x", static_cast<void*>(nullptr)) == "100% x (nil)");
  errno = ENOENT;
  CHECK(text_of("%m, %d", 1) == "No such file or directory, 1");
  int64_t wide = -1;
  long narrow = -1;
  int plain = -1;
  CHECK(text_of("abc%ln %d%ln%n", &wide, 5, &narrow, &plain) == "abc 5");
  CHECK(wide == 3 && narrow == 5 && plain == 5);
  CHECK(text_of((std::string(300, '-') + "%ld %s").c_str(), int64_t{41}, "end") ==
        std::string(300, '-') + "41 end");
  CHECK(Printer().printf("%d", 4) == 4);
  int (*const chosen)(char*, size_t, const char*, ...) = std::snprintf;
  char text[32];
  CHECK(chosen(text, sizeof(text), "%d", 3) == 1);
}

void other_functions(Checks& checks) {
  const int64_t value = 41;
  char text[32];
  CHECK(std::sprintf(text, "%ld %s", value, "x") == 4 && std::string(text) == "41 x");
  CHECK(rcutils_snprintf(text, sizeof(text), "%ld-%s", value, "y") == 4 &&
        std::string(text) == "41-y");
  const rcutils_allocator_t allocator = rcutils_get_default_allocator();
  char* made = rcutils_format_string(allocator, "%ld+%s", value, "z");
  CHECK(std::string(made) == "41+z");
  allocator.deallocate(made, allocator.state);
  CHECK(asprintf(&made, "%ld/%s", value, "v") == 4 && std::string(made) == "41/v");
  std::free(made);
  std::FILE* file = std::fopen("/tmp/formats", "w+");
  std::fprintf(file, "%ld %s\n", value, "in a file");
  std::rewind(file);
  int64_t read = 0;
  CHECK(std::fscanf(file, "%ld", &read) == 1 && read == 41);
  std::fclose(file);
  const int descriptor = ::open("/tmp/formats", O_RDWR | O_TRUNC);
  CHECK(dprintf(descriptor, "%ld %s", value, "w") == 4);
  ::close(descriptor);
}

void scanned(Checks& checks) {
  int64_t wide = -1;
  long narrow = -1;
  uint64_t most = 0;
  size_t size = 0;
  int plain = 0;
  double real = 0;
  float single = 0;
  char word[8];
  char rest[8];
  CHECK(std::sscanf("5000000000 12 18446744073709551615 word 7 2.5 1.5 9 8 ]x",
                    "%ld %ld %lu %7s %d %lf %f %zu %*d %[]x]", &wide, &narrow, &most, word, &plain,
                    &real, &single, &size, rest) == 9);
  CHECK(wide == 5'000'000'000 && narrow == 12 && most == UINT64_MAX && std::string(word) == "word");
  CHECK(plain == 7 && real == 2.5 && single == 1.5F && size == 9 && std::string(rest) == "]x");
}

}  // namespace

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  Checks checks("formats");
  log_texts(checks);
  integers(checks);
  others(checks);
  other_functions(checks);
  scanned(checks);
  return checks.finish();
}
