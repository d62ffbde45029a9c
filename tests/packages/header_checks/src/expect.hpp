// Counts what holds, for programs that use nothing of ROS.
#pragma once

#include <cmath>
#include <cstdio>
#include <cstdlib>

class Expectations {
 public:
  void that(bool holds, const char* text, const char* file, int line) {
    ++count_;
    if (holds) return;
    ++failed_;
    std::fprintf(stderr, "%s:%d: %s does not hold\n", file, line, text);
  }
  int finish() const {
    if (failed_ == 0) std::printf("all %d checks hold\n", count_);
    return failed_ == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
  }

 private:
  int count_ = 0;
  int failed_ = 0;
};

inline bool near(double value, double expected, double tolerance = 1e-9) {
  return std::abs(value - expected) <= tolerance;
}

#define EXPECT(CONDITION) expectations.that((CONDITION), #CONDITION, __FILE__, __LINE__)
#define EXPECT_THROWS(ERROR, ...) \
  try {                           \
    __VA_ARGS__;                  \
    EXPECT(!"threw " #ERROR);     \
  } catch (const ERROR&) {        \
    EXPECT(true);                 \
  }

void check_boost(Expectations& expectations);
void check_logs(Expectations& expectations);
void check_matrices(Expectations& expectations);
void check_neighbours(Expectations& expectations);
void check_ranges(Expectations& expectations);
