// Names that are read without a full parse are those that the full parse finds.
#include "bundler/channel/spec_table.hpp"

#include <gtest/gtest.h>

namespace ros2wasm {
namespace {

TEST(PlainName, IsTheNameThatAFullParseFinds) {
  for (const char* text :
       {"numpy", "numpy 1.2", "numpy >=1.2,<2", "numpy 1.8.*", "numpy 1.8 py27_*", "_r-mutex 1.* *",
        "__unix", "lib.with-all_9 >=3|2"}) {
    const auto plain = plain_name(text);
    ASSERT_TRUE(plain) << text;
    const auto full = MatchSpec::parse(text);
    ASSERT_TRUE(full) << text;
    EXPECT_EQ(full->exact_name(), *plain) << text;
  }
}

TEST(PlainName, IsNotGuessed) {
  for (const char* text :
       {"", " ", " numpy", "Numpy", "numpy>=1", "numpy=1", "num*", "conda-forge::numpy 1",
        "conda-forge ::numpy", "numpy[version=1]", "a [name=b]", "a (name=b)", "a https://x/y",
        "https://host/forge/noarch/pkg-1.0-h_0.conda", "^numpy$", "./numpy-1-0.conda"})
    EXPECT_FALSE(plain_name(text)) << text;
}

}  // namespace
}  // namespace ros2wasm
