// License statements as SPDX expressions, and names of people as citations have them.
#include "bundler/render/citation.hpp"

#include <gtest/gtest.h>

#include "bundler/render/spdx_expression.hpp"

namespace ros2wasm {
namespace {

TEST(SpdxExpression, KnowsIdentifiersOperatorsAndWhatPeopleWrite) {
  EXPECT_EQ(spdx_expression("Apache-2.0"), "Apache-2.0");
  EXPECT_EQ(spdx_expression(" Apache License 2.0 "), "Apache-2.0");
  EXPECT_EQ(spdx_expression("mit"), "MIT");
  EXPECT_EQ(spdx_expression("MIT and (bsd-3-clause OR Zlib)"), "MIT AND (BSD-3-Clause OR Zlib)");
  EXPECT_EQ(spdx_expression("Apache-2.0 WITH LLVM-exception"), "Apache-2.0 WITH LLVM-exception");
  EXPECT_EQ(spdx_expression("GPLv3"), "GPL-3.0-only");
}

TEST(SpdxExpression, LeavesTheRestToItsOwnWords) {
  for (const char* text :
       {"", "BSD", "TODO: License declaration", "MIT OR", "OR MIT", "(MIT", "MIT)", "()",
        "MIT Zlib", "MIT WITH", "MIT WITH nothing", "(MIT) WITH LLVM-exception"})
    EXPECT_EQ(spdx_expression(text), std::nullopt) << text;
  EXPECT_EQ(spdx_expression(std::string(100'000, '(')), std::nullopt);
  EXPECT_TRUE(is_spdx_identifier("MIT"));
  EXPECT_FALSE(is_spdx_identifier("MIT AND Zlib"));
}

TEST(PersonName, IsSplitAtTheCommaOrBeforeTheLastWord) {
  EXPECT_EQ(person_name("Jo van Doe").family, "Doe");
  EXPECT_EQ(person_name("van Doe, Jo").family, "van Doe");
  EXPECT_EQ(person_name("van Doe, Jo").given, "Jo");
  EXPECT_EQ(person_name(" Collective ").family, "Collective");
  EXPECT_EQ(person_name(" Collective ").given, "");
}

}  // namespace
}  // namespace ros2wasm
