// Filling and printing of single values for the conformance driver; see driver.hpp.
#include <cmath>
#include <cstdio>

#include "driver.hpp"

namespace driver {

uint64_t Random::next() {
  uint64_t z = (state_ += 0x9E3779B97F4A7C15u);
  z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
  z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
  return z ^ (z >> 31);
}

void fill_bool(bool& value, Random& random) {
  value = random.below(2) == 1;
}

int32_t fill_sixty_fourths(Random& random) {
  return static_cast<int32_t>(random.next());
}

void fill_string(std::string& value, Random& random, size_t bound) {
  value.resize(random.below(bound == 0 || bound > 20 ? 20 : bound + 1));
  for (char& c : value) c = static_cast<char>(' ' + random.below(95));
}

void fill_string(std::u16string& value, Random& random, size_t bound) {
  value.resize(random.below(bound == 0 || bound > 9 ? 9 : bound + 1));
  for (char16_t& c : value) c = static_cast<char16_t>('a' + random.below(500));
}

void fill_members(MemberRows rows, void* message, Random& random) {
  for (size_t i = 0; i < rows.count; ++i) {
    const MemberRow& row = rows.first[i];
    row.operations->fill(static_cast<char*>(message) + row.offset, random, row.string_bound);
  }
}

void print_double(double value, std::string& json) {
  char buffer[40];
  if (!std::isfinite(value)) {
    json += "null";
    return;
  }
  std::snprintf(buffer, sizeof buffer, "%.17g", value);
  json += buffer;
}

namespace {

/// Bytes of UTF-8 pass as they are; wide units and control characters are escaped.
void print_unit(unsigned unit, bool wide, std::string& json) {
  char buffer[8];
  if (unit == '"' || unit == '\\') json += '\\';
  if (unit < 32 || (wide && unit > 126)) {
    std::snprintf(buffer, sizeof buffer, "\\u%04x", unit);
    json += buffer;
  } else {
    json += static_cast<char>(unit);
  }
}

}  // namespace

void print_string(const std::string& value, std::string& json) {
  json += '"';
  for (char c : value) print_unit(static_cast<unsigned char>(c), false, json);
  json += '"';
}

void print_string(const std::u16string& value, std::string& json) {
  json += '"';
  for (char16_t c : value) print_unit(c, true, json);
  json += '"';
}

void print_members(MemberRows rows, const void* message, std::string& json) {
  json += '{';
  for (size_t i = 0; i < rows.count; ++i) {
    const MemberRow& row = rows.first[i];
    if (json.back() != '{') json += ',';
    json += '"' + std::string(row.name) + "\":";
    row.operations->print(static_cast<const char*>(message) + row.offset, json);
  }
  json += '}';
}

}  // namespace driver
