// Libraries that are headers only, each in a source of its own.
#include "expect.hpp"

int main() {
  Expectations expectations;
  check_boost(expectations);
  check_logs(expectations);
  check_matrices(expectations);
  check_neighbours(expectations);
  check_ranges(expectations);
  return expectations.finish();
}
