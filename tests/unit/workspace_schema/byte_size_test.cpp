// Sizes with units: what is one, what was meant, and how they are written.
#include "workspace_schema/base/byte_size.hpp"

#include <gtest/gtest.h>

namespace ros2wasm {
namespace {

TEST(ByteSize, ReadsNumbersWithUnits) {
  EXPECT_EQ(parse_byte_size("12 MB"), 12'000'000U);
  EXPECT_EQ(parse_byte_size("12MB"), 12'000'000U);
  EXPECT_EQ(parse_byte_size("1.5 MiB"), 1'572'864U);
  EXPECT_EQ(parse_byte_size("0.125 kB"), 125U);
  EXPECT_EQ(parse_byte_size("800 kB"), 800'000U);
  EXPECT_EQ(parse_byte_size("7 B"), 7U);
  EXPECT_EQ(parse_byte_size("999999.999 GiB"), 1'073'741'822'926'258U);
}

TEST(ByteSize, RefusesTheRest) {
  for (const char* text : {"", "12", "MB", "12 mb", "12M", "-1 MB", "+1 MB", "1  MB", " 1 MB",
                           "1 MB ", "1. MB", ".5 MB", "1.2345 MB", "1000000 GB",
                           "99999999999999999999 B", "1e3 kB", "0x1 B", "1,5 MB", "1.2.3 B"})
    EXPECT_FALSE(parse_byte_size(text)) << text;
}

TEST(ByteSize, KnowsWhatWasMeant) {
  EXPECT_EQ(meant_byte_size("12 mb"), "12 MB");
  EXPECT_EQ(meant_byte_size("12M"), "12 MB");
  EXPECT_EQ(meant_byte_size("1.5 mib"), "1.5 MiB");
  EXPECT_EQ(meant_byte_size("3KB"), "3 kB");
  EXPECT_EQ(meant_byte_size("12"), std::nullopt);
  EXPECT_EQ(meant_byte_size("many MB"), std::nullopt);
}

TEST(ByteSize, WritesTheLargestUnit) {
  EXPECT_EQ(byte_size_text(0), "0 B");
  EXPECT_EQ(byte_size_text(999), "999 B");
  EXPECT_EQ(byte_size_text(1'000), "1.00 kB");
  EXPECT_EQ(byte_size_text(12'345'678), "12.34 MB");
  EXPECT_EQ(byte_size_text(5'070'000'000), "5.07 GB");
}

}  // namespace
}  // namespace ros2wasm
