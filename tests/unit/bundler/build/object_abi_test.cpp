#include "bundler/build/object_abi.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace ros2wasm {
namespace {

using namespace std::string_view_literals;

using Faults = std::vector<std::string>;
const std::string kThreads =
    "it was compiled without threads (-pthread), which programs of a site have";
const std::string kExceptions =
    "it throws exceptions through JavaScript (-fexceptions), not as WebAssembly does "
    "(-fwasm-exceptions)";

const std::string kHead("\0asm\1\0\0\0"sv);

std::string section(char id, const std::string& contents) {
  return std::string(1, id) + static_cast<char>(contents.size()) + contents;
}

/// A section that says which features of WebAssembly an object uses (`+`) or forbids (`-`).
std::string features(const std::string& entries, int count) {
  return section('\0', "\x0ftarget_features" + std::string(1, static_cast<char>(count)) + entries);
}

/// One imported function without a type that matters.
std::string import(const std::string& name) {
  return section('\x02',
                 "\x01\x03"
                 "env" +
                     std::string(1, static_cast<char>(name.size())) + name + std::string("\0\0"sv));
}

std::string archive_of(const std::vector<std::string>& members) {
  std::string result = "!<arch>\n";
  for (const std::string& member : members) {
    std::string header = "member.o/";
    header.resize(48, ' ');
    header += std::to_string(member.size());
    header.resize(58, ' ');
    result += header + "`\n" + member + (member.size() % 2 == 1 ? "\n" : "");
  }
  return result;
}

TEST(ObjectAbi, ObjectsWithThreadsAndWasmExceptionsFit) {
  EXPECT_EQ(object_abi_faults(kHead + features("+\x07"
                                               "atomics+\x12"
                                               "exception-handling",
                                               2)),
            Faults{});
  EXPECT_EQ(object_abi_faults(kHead), Faults{});
}

TEST(ObjectAbi, WhatForbidsSharedMemoryHasNoThreads) {
  EXPECT_EQ(object_abi_faults(kHead + features("-\x0a"
                                               "shared-mem",
                                               1)),
            Faults{kThreads});
}

TEST(ObjectAbi, ExceptionsThroughJavaScriptAreKnownByTheirHelpers) {
  EXPECT_EQ(object_abi_faults(kHead + import("invoke_vi")), Faults{kExceptions});
  EXPECT_EQ(object_abi_faults(kHead + import("involved")), Faults{});
  EXPECT_EQ(object_abi_faults(kHead + import("invoke_callback")), Faults{});
  EXPECT_EQ(object_abi_faults(kHead + import("invoke_")), Faults{});
}

TEST(ObjectAbi, EachReasonOfAnArchiveIsSaidOnce) {
  const std::string one = kHead + features(
                                      "-\x0a"
                                      "shared-mem",
                                      1);
  EXPECT_EQ(object_abi_faults(archive_of({one, one, kHead + import("invoke_ii"), "a text"})),
            (Faults{kThreads, kExceptions}));
}

TEST(ObjectAbi, OtherMachinesAndBitcode) {
  const Faults other{"it is not compiled for WebAssembly"};
  EXPECT_EQ(object_abi_faults("\x7f"
                              "ELF and more"),
            other);
  EXPECT_EQ(object_abi_faults(archive_of({"BC\xc0\xde"
                                          "1234"})),
            other);
}

TEST(ObjectAbi, DamagedFilesSayNothing) {
  const std::string whole = kHead + features(
                                        "-\x0a"
                                        "shared-mem",
                                        1);
  for (std::size_t size = 0; size < whole.size(); ++size)
    EXPECT_EQ(object_abi_faults(whole.substr(0, size)), Faults{}) << size;
  EXPECT_EQ(object_abi_faults("!<arch>\nnonsense"), Faults{});
}

TEST(ObjectAbi, PythonOfACompiledModule) {
  EXPECT_EQ(python_version_of_module("x.cpython-312-wasm32-emscripten.so"), "3.12");
  EXPECT_EQ(python_version_of_module("x.cpython-39-wasm32-emscripten.so"), "3.9");
  EXPECT_EQ(python_version_of_module("x.abi3.so"), "");
  EXPECT_EQ(python_version_of_module("x.cpython-.so"), "");
}

}  // namespace
}  // namespace ros2wasm
