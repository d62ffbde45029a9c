// Compiled modules of Python wheels: what is read of a good one, and how each bad one is refused.
#include "bundler/archive/side_module.hpp"

#include <gtest/gtest.h>

namespace ros2wasm {
namespace {

using namespace std::string_literals;

std::string leb(std::uint64_t value) {
  std::string out;
  do {
    auto next = static_cast<std::uint8_t>(value & 0x7FU);
    value >>= 7U;
    if (value != 0) next |= 0x80U;
    out += static_cast<char>(next);
  } while (value != 0);
  return out;
}

std::string text(const std::string& words) {
  return leb(words.size()) + words;
}

std::string section(char id, const std::string& contents) {
  return id + leb(contents.size()) + contents;
}

std::string part(char kind, const std::string& contents) {
  return kind + leb(contents.size()) + contents;
}

const std::string kHeader = "\0asm\1\0\0\0"s;

std::string memory(std::uint64_t bytes, std::uint64_t table = 0) {
  return part(1, leb(bytes) + leb(4) + leb(table) + leb(0));
}

std::string dylink(const std::string& parts) {
  return section(0, text("dylink.0") + parts);
}

std::string import_of(const std::string& module, const std::string& name) {
  return section(2, leb(1) + text(module) + text(name) + "\0\0"s);
}

/// Data at `__memory_base` + `offset`.
std::string data(const std::string& place, std::size_t size) {
  return section(11, leb(1) + "\0"s + place + leb(size) + std::string(size, 'x'));
}

const std::string kAtBase = "\x23\0\x0b"s;

/// The fault that is found; empty: it was read.
std::string fault(const std::string& bytes) {
  const auto read = read_side_module(bytes);
  const auto* found = std::get_if<SideModuleFault>(&read);
  return found == nullptr ? "" : found->why;
}

TEST(SideModule, SaysWhatItNeeds) {
  const auto read = read_side_module(
      kHeader +
      dylink(memory(64) + part(2, leb(2) + text("libgeos.so") + text("libgeos_c.so.1")) +
             part(9, "later")) +
      import_of("env", "malloc") + data(kAtBase, 64));
  ASSERT_TRUE(std::holds_alternative<SideModule>(read));
  EXPECT_EQ(std::get<SideModule>(read).memory_bytes, 64U);
  EXPECT_EQ(std::get<SideModule>(read).needed,
            (std::vector<std::string>{"libgeos.so", "libgeos_c.so.1"}));
}

TEST(SideModule, RefusesWhatIsNone) {
  EXPECT_EQ(fault(""), "is not a whole WebAssembly module");
  EXPECT_EQ(fault("\x7f"
                  "ELF"),
            "is not a whole WebAssembly module");
  EXPECT_EQ(fault(kHeader), "does not begin with the section `dylink.0` of side modules");
  EXPECT_EQ(fault(kHeader + section(0, text("name")) + dylink(memory(1))),
            "does not begin with the section `dylink.0` of side modules");
  EXPECT_EQ(fault(kHeader + section(0, text("dylink") + memory(1))),
            "was linked by an Emscripten older than 2.0.31");
  EXPECT_EQ(fault(kHeader + dylink("")), "does not say how much memory it needs");
}

// Guarantee, hostile input: a compiled module of a Python library that was cut anywhere, whose
// section `dylink.0` lies, that asks for 300 MiB, places data elsewhere than in its memory, imports
// from the page or brings JavaScript is refused
TEST(SideModule, RefusesEveryTruncation) {
  const std::string whole = kHeader + dylink(memory(64) + part(2, leb(1) + text("libgeos.so"))) +
                            import_of("env", "malloc") + data(kAtBase, 64);
  EXPECT_EQ(fault(whole), "");
  const std::size_t import = whole.size() - data(kAtBase, 64).size();
  const std::size_t end = import - import_of("env", "malloc").size();
  for (std::size_t size = 0; size < whole.size(); ++size) {
    // Between two sections it is a smaller module, and as good.
    if (size != import && size != end) {
      EXPECT_NE(fault(whole.substr(0, size)), "") << size;
    }
  }
}

TEST(SideModule, RefusesASectionThatLies) {
  constexpr const char* kEarly = "has a section `dylink.0` that ends too early";
  EXPECT_EQ(fault(kHeader + dylink(part(1, leb(64)))), kEarly);
  EXPECT_EQ(fault(kHeader + dylink(memory(64) + "\x02\x7f")), kEarly);
  EXPECT_EQ(fault(kHeader + dylink(memory(64) + part(2, leb(1) + leb(100) + "lib"))), kEarly);
  EXPECT_EQ(fault(kHeader + dylink(part(1, leb(64) + leb(0) + leb(0) + leb(0) + leb(0)))),
            "has a section `dylink.0` with more than it says");
  EXPECT_EQ(fault(kHeader + dylink(memory(64) + part(2, leb(1'000'000'000)))),
            "names 1000000000 libraries");
  EXPECT_EQ(fault(kHeader + dylink(memory(64) + part(2, leb(1) + text("../libc.so")))),
            "needs a library whose name is not one");
  EXPECT_EQ(fault(kHeader + dylink(memory(64) + part(2, leb(1) + text("a\0b"s)))),
            "needs a library whose name is not one");
}

TEST(SideModule, RefusesDataOutsideOfItsMemory) {
  constexpr const char* kMore =
      "has more data than the memory that its section `dylink.0` asks for";
  EXPECT_EQ(fault(kHeader + dylink(memory(63)) + data(kAtBase, 64)), kMore);
  const std::string behind = "\x23\0\x41\x3f\x6a\x0b"s;  // base + 63
  EXPECT_EQ(fault(kHeader + dylink(memory(64)) + data(behind, 1)), "");
  EXPECT_EQ(fault(kHeader + dylink(memory(64)) + data(behind, 2)), kMore);
  const std::string before = "\x23\0\x41\x7f\x6a\x0b"s;  // base - 1
  EXPECT_EQ(fault(kHeader + dylink(memory(64)) + data(before, 1)), kMore);
  EXPECT_EQ(fault(kHeader + dylink(memory(64)) + data("\x41\x10\x0b", 4)),
            "places data at an address of its own choice");
}

TEST(SideModule, RefusesMoreThanALibraryNeeds) {
  EXPECT_EQ(fault(kHeader + dylink(memory(300ULL << 20U))),
            "asks for 314572800 bytes of memory, more than 268435456");
  EXPECT_EQ(fault(kHeader + dylink(memory(64, 1ULL << 32U))),
            "asks for a table or an alignment that no library has");
  EXPECT_EQ(fault(kHeader + dylink(memory(64)) + section(5, leb(1) + "\0\1"s)),
            "has a memory of its own");
}

TEST(SideModule, RefusesOtherImportsAndScripts) {
  EXPECT_EQ(fault(kHeader + dylink(memory(64)) + import_of("window", "fetch")),
            "imports `fetch` from `window`, which no interpreter of a site has");
  EXPECT_EQ(fault(kHeader + dylink(memory(64)) + import_of("env", "emscripten_run_script_int")),
            "imports `emscripten_run_script_int`, which runs JavaScript from text");
  for (const char* name : {"__em_js__leave", "__start_em_asm"}) {
    const std::string exports = section(7, leb(1) + text(name) + "\3\0"s);
    EXPECT_EQ(fault(kHeader + dylink(memory(64)) + exports),
              "brings JavaScript as text (`"s + name + "`), which a site never runs");
  }
  const std::string threads = section(2, leb(1) + text("env") + text("memory") + "\2\3\1\1"s);
  EXPECT_EQ(fault(kHeader + dylink(memory(64)) + threads),
            "is made for threads, which the interpreter does not have");
}

}  // namespace
}  // namespace ros2wasm
