// When CMake has to look at a package again, and what becomes of the prefix in its files if not.
#include "bundler/build/cached_configure.hpp"

#include <gtest/gtest.h>

#include "bundler/build/cached_work.hpp"
#include "unit/bundler/support/temporary_tree.hpp"

namespace ros2wasm {
namespace {

class KeptConfigure : public ::testing::Test {
 protected:
  KeptConfigure() {
    tree.write("source/CMakeLists.txt", "add_executable(a a.cpp)");
    tree.write("source/a.cpp", "int main() {}");
    tree.write("source/m.msg", "int32 x");
    tree.write("work/build.ninja", "-DSHARE=/built/a-1/share\nlink\n");
    tree.write("work/plain.txt", "nothing");
    tree.write("work/a.o", "/built/a-1");
  }
  [[nodiscard]] std::string key(const std::vector<std::string>& arguments = {"cmake"}) const {
    EXPECT_TRUE(forget_what_times_hide(tree / "work", tree / "source", tree / "source"));
    const auto result = configure_key(tree / "work", tree / "source", arguments);
    return result ? *result : std::string();
  }

  testing::TemporaryTree tree;
};

TEST_F(KeptConfigure, DependsOnArgumentsFilesAndWhatIsNotCompiled) {
  const std::string first = key();
  EXPECT_EQ(key(), first);
  EXPECT_NE(key({"cmake", "-DX=1"}), first);
  tree.write("source/a.cpp", "int main() { return 1; }");
  EXPECT_EQ(key(), first);
  tree.write("source/list.cmake", "file(GLOB sources *.cpp)");
  const std::string listing = key();
  tree.write("source/a.cpp", "int main() { return 2; }");
  EXPECT_EQ(key(), listing) << "names are no contents";
  tree.write("source/b.cpp", "");
  const std::string with_b = key();
  EXPECT_NE(with_b, listing);
  tree.write("source/m.msg", "int64 x");
  EXPECT_NE(key(), with_b);
}

TEST_F(KeptConfigure, DependsOnCompiledFilesOfAPackageThatReadsFilesItself) {
  for (const char* reads :
       {"file( STRINGS a.cpp text)", "File(READ a.cpp text)", "execute_process(COMMAND cat a.cpp)",
        "configure_file (a.cpp b.cpp)", "file(GLOB all *.cpp) file(COPY a.cpp DESTINATION out)"}) {
    tree.write("source/more.cmake", reads);
    tree.write("source/a.cpp", "int main() {}");
    const std::string first = key();
    tree.write("source/a.cpp", "int main() { return 1; }");
    EXPECT_NE(key(), first) << reads;
  }
}

TEST_F(KeptConfigure, GivesTheFilesTheirNewPrefix) {
  const auto work = tree / "work";
  ASSERT_TRUE(keep_configure(work, "key", "/built/a-1"));
  EXPECT_TRUE(reuse_configure(work, "key", "/built/a-2"));
  EXPECT_EQ(tree.read("work/build.ninja"), "-DSHARE=/built/a-2/share\nlink\n");
  EXPECT_EQ(tree.read("work/a.o"), "/built/a-1") << "it is compiled again, as its command changed";
  EXPECT_TRUE(reuse_configure(work, "key", "/built/a-2"));
  EXPECT_TRUE(reuse_configure(work, "key", "/built/a-3"));
  EXPECT_EQ(tree.read("work/build.ninja"), "-DSHARE=/built/a-3/share\nlink\n");
}

TEST_F(KeptConfigure, IsDroppedForAnotherKeyOrALostFile) {
  const auto work = tree / "work";
  EXPECT_FALSE(reuse_configure(work, "key", "/built/a-1"));
  ASSERT_TRUE(keep_configure(work, "key", "/built/a-1"));
  EXPECT_FALSE(reuse_configure(work, "other", "/built/a-1"));
  EXPECT_FALSE(reuse_configure(work, "key", "/built/a-1"))
      << "the configure for other may have failed";
  ASSERT_TRUE(keep_configure(work, "key", "/built/a-1"));
  forget_configure(work);
  EXPECT_FALSE(reuse_configure(work, "key", "/built/a-1"));
  ASSERT_TRUE(keep_configure(work, "key", "/built/a-1"));
  std::filesystem::remove(work / "build.ninja");
  EXPECT_FALSE(reuse_configure(work, "key", "/built/a-2"));
}

}  // namespace
}  // namespace ros2wasm
