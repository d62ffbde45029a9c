// Which Emscripten is taken, and whether the channels have packages for it.
#include "bundler/build/compiler.hpp"

#include <gtest/gtest.h>

#include "bundler/build/compiler_parts.hpp"
#include "tests/unit/bundler/support/temporary_tree.hpp"

namespace ros2wasm {
namespace {

namespace fs = std::filesystem;

/// A folder with an em++ that says it is of `version`.
fs::path install(const testing::TemporaryTree& tree, const std::string& folder,
                 const std::string& version) {
  tree.write(folder + "/em++", "#!/bin/sh\n");
  fs::permissions(tree.root() / folder / "em++", fs::perms::owner_all);
  tree.write(folder + "/emscripten-version.txt", "\"" + version + "\"\n");
  return tree.root() / folder;
}

TEST(Compiler, EmsdkComesBeforePath) {
  const testing::TemporaryTree tree;
  const fs::path on_path = install(tree, "bin", "3.1.6");
  const fs::path of_sdk = install(tree, "sdk/upstream/emscripten", "3.1.64");
  const EnvironmentVariables both = {{"PATH", on_path.string()},
                                     {"EMSDK", (tree.root() / "sdk").string()}};
  const auto sdk = find_compiler(both);
  ASSERT_TRUE(sdk);
  EXPECT_EQ(sdk->cxx, of_sdk / "em++");
  EXPECT_EQ(sdk->c, of_sdk / "emcc");
  EXPECT_EQ(sdk->version, "3.1.64");
  const auto path = find_compiler({{"PATH", on_path.string()}});
  ASSERT_TRUE(path);
  EXPECT_EQ(path->version, "3.1.6");
  EXPECT_NE(path->identity, sdk->identity);
  EXPECT_EQ(find_compiler({{"PATH", tree.root().string()}}).errors().front().code.text(),
            "R2W0501");
}

TEST(Compiler, PackagesMustComeOfTheSameOne) {
  const testing::TemporaryTree tree;
  const fs::path on_path = install(tree, "bin", "3.1.6");
  install(tree, "sdk/upstream/emscripten", "3.1.64");
  const EnvironmentVariables both = {{"PATH", on_path.string()},
                                     {"EMSDK", (tree.root() / "sdk").string()}};
  const auto sdk = find_compiler(both);
  ASSERT_TRUE(sdk);
  const auto refused = no_packages_for(*sdk, {"3.1.5", "3.1.6"}, both);
  ASSERT_TRUE(refused);
  EXPECT_EQ(refused->code, "R2W0530");
  EXPECT_EQ(refused->message, "the channels have no packages for Emscripten 3.1.64");
  EXPECT_NE(refused->why.back().find("Emscripten 3.1.5, 3.1.6"), std::string::npos);
  EXPECT_EQ(refused->fix, (std::vector<std::string>{"unset EMSDK"}));
  // Offered only when it helps.
  EXPECT_TRUE(no_packages_for(*sdk, {"3.1.5"}, both)->fix.empty());
  EXPECT_FALSE(no_packages_for(*sdk, {"3.1.6", "3.1.64"}, both));
  EXPECT_FALSE(no_packages_for(*sdk, {}, both));
}

TEST(Compiler, OfOneVersionButOfOtherPartsIsAnother) {
  const testing::TemporaryTree tree;
  const fs::path home = install(tree, "sdk/upstream/emscripten", "3.1.64");
  const EnvironmentVariables sdk = {{"EMSDK", (tree.root() / "sdk").string()}};
  const std::string libraries = "sdk/upstream/emscripten/cache/sysroot/lib/wasm32-emscripten/";
  tree.write("sdk/upstream/bin/clang", "a program");
  tree.write("sdk/upstream/lib/clang/19.0.0/include/stddef.h", "");
  EXPECT_EQ(abi_build(find_compiler_parts(home, sdk), {}), "");  // none made yet
  for (const std::string name :
       {"libc++-except", "libc++-mt-except", "libc++abi-except", "libc++abi-mt-except", "libc-mt",
        "libc", "libcompiler_rt-mt", "libcompiler_rt", "libdlmalloc-mt", "libdlmalloc",
        "libstandalonewasm-memgrow", "libunwind-except", "libunwind-mt-except"})
    tree.write(libraries + name + ".a", name);
  const auto before = find_compiler(sdk);
  ASSERT_TRUE(before);
  const std::string build = abi_build(find_compiler_parts(home, sdk), tree / "cache");
  EXPECT_TRUE(build.starts_with("clang19.0.0_h")) << build;
  EXPECT_EQ(abi_build(find_compiler_parts(home, sdk), tree / "cache"), build);
  EXPECT_EQ(abi_build(find_compiler_parts(home, sdk), {}), build);
  EXPECT_FALSE(other_parts(*before, build, {build}));
  EXPECT_FALSE(other_parts(*before, build, {"0"}));  // a channel that does not say

  tree.write(libraries + "libc.a", "mended libc");
  const auto after = find_compiler(sdk);
  ASSERT_TRUE(after);
  EXPECT_NE(after->identity, before->identity);  // nothing that was built is taken
  const std::string mended = abi_build(find_compiler_parts(home, sdk), tree / "cache");
  EXPECT_NE(mended, build);
  const auto refused = other_parts(*after, mended, {build});
  ASSERT_TRUE(refused);
  EXPECT_EQ(refused->code, "R2W0530");
  EXPECT_NE(refused->why[0].find(mended), std::string::npos);
  EXPECT_NE(refused->why[1].find(build), std::string::npos);

  fs::rename(tree / "sdk/upstream/lib/clang/19.0.0", tree / "sdk/upstream/lib/clang/19.1.0");
  EXPECT_TRUE(abi_build(find_compiler_parts(home, sdk), {}).starts_with("clang19.1.0_h"));
}

TEST(Compiler, WhereADistributionHasItsClang) {
  const testing::TemporaryTree tree;
  const fs::path home = install(tree, "share/emscripten", "3.1.6");
  tree.write("llvm-14/bin/clang", "a program");
  tree.write("llvm-14/lib/clang/14.0.6/include/stddef.h", "");
  tree.write("share/emscripten/.emscripten",
             "# where\nLLVM_ROOT = '" + (tree / "llvm-14/bin").string() + "' # directory\n");
  EXPECT_EQ(find_compiler_parts(home, {}).clang_version, "14.0.6");
  EXPECT_EQ(find_compiler_parts(home, {{"EM_LLVM_ROOT", "/nowhere"}}).clang_version, "");
}

TEST(Compiler, WhichOfSeveralClangsADistributionMeans) {
  const testing::TemporaryTree tree;
  const fs::path home = install(tree, "share/emscripten", "3.1.6");
  const std::string root = (tree / "bin").string();
  for (const char* version : {"14", "16"}) {
    const std::string folder = "llvm-" + std::string(version);
    tree.write(folder + "/bin/clang", "a program");
    tree.write(folder + "/lib/clang/" + version + ".0.6/include/stddef.h", "");
    fs::create_directories(tree / "bin");
    fs::create_symlink(tree / (folder + "/bin/clang"),
                       tree / ("bin/clang-" + std::string(version)));
  }
  tree.write("share/emscripten/.emscripten",
             "LLVM_ROOT = '" + root + "'\nLLVM_ADD_VERSION = '15'\nCLANG_ADD_VERSION = '14'");
  EXPECT_EQ(find_compiler_parts(home, {}).clang_version, "14.0.6");
  EXPECT_EQ(find_compiler_parts(home, {{"EM_CLANG_ADD_VERSION", "16"}}).clang_version, "16.0.6");
  EXPECT_EQ(find_compiler_parts(home, {{"EM_CLANG_ADD_VERSION", "17"}}).clang_version, "");
}

TEST(Compiler, ToolsBesideItComeFirstInALink) {
  const EnvironmentVariables variables = {{"PATH", "/home/me/bin:/usr/bin"}};
  EXPECT_EQ(tool_environment(variables, "/opt/sdk/em++").at("PATH"),
            "/opt/sdk:/home/me/bin:/usr/bin");
  EXPECT_FALSE(tool_environment(variables, "em++").contains("PATH"));
  EXPECT_FALSE(tool_environment({}, "/opt/sdk/em++").contains("PATH"));
  // Only links are told: cmake and ninja are those that the user has chosen.
  EXPECT_FALSE(compiler_environment(variables).contains("PATH"));
}

}  // namespace
}  // namespace ros2wasm
