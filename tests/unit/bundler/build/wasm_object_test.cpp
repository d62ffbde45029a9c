#include "bundler/build/wasm_object.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "bundler/build/single_link_object.hpp"

namespace ros2wasm {
namespace {

using namespace std::string_view_literals;

/// An archive of these members, as GNU's ar writes it.
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

const std::string kMark("\0asm\1\0\0\0\0\x09\x07linking\x02"sv);

/// Symbols: f (strong), g (hidden), h (weak), i (undefined), j (data), of one letter each.
std::string object() {
  const std::string symbols("\x05\0\0\0\1f\0\4\1\1g\0\1\2\1h\0\x50\3\1i\1\0\1j\0\0\4"sv);
  const std::string table = std::string(1, '\x08') + static_cast<char>(symbols.size()) + symbols;
  const std::string contents = "\x07linking\x02" + table;
  return std::string("\0asm\1\0\0\0"sv) + '\0' + static_cast<char>(contents.size()) + contents;
}

std::vector<std::string> names_of(const std::vector<ObjectSymbol>& symbols) {
  std::vector<std::string> result;
  for (const ObjectSymbol& one : symbols) result.push_back(one.name);
  return result;
}

TEST(WasmObject, StrongDefinitionsOfAnObject) {
  const auto symbols = strong_definitions(object());
  ASSERT_TRUE(symbols);
  EXPECT_EQ(names_of(*symbols), (std::vector<std::string>{"f", "g", "j"}));
  EXPECT_FALSE(symbols->at(0).is_hidden);
  EXPECT_TRUE(symbols->at(1).is_hidden);
}

TEST(WasmObject, WeakOnesAreNoStrongOnesAnyMore) {
  std::string bytes = archive_of({kMark, object(), "no object"});
  const auto symbols = archive_definitions(bytes);
  ASSERT_TRUE(symbols);
  ASSERT_EQ(names_of(*symbols), (std::vector<std::string>{"f", "g", "j"}));
  const std::size_t size = bytes.size();
  make_weak(bytes, symbols->at(2));
  EXPECT_EQ(bytes.size(), size);
  EXPECT_EQ(names_of(archive_definitions(bytes).value()), (std::vector<std::string>{"f", "g"}));
}

TEST(WasmObject, TheFunctionOfTheSingleLinkIsWeak) {
  const auto symbols = strong_definitions(single_link_object(TlsBase::kZero));
  ASSERT_TRUE(symbols);
  EXPECT_EQ(names_of(*symbols), (std::vector<std::string>{"__tls_base"}));
}

TEST(WasmObject, TheMarkOfSharedLibraries) {
  EXPECT_TRUE(is_natively_shared(archive_of({object(), kMark})));
  EXPECT_FALSE(is_natively_shared(archive_of({object()})));
  EXPECT_FALSE(is_natively_shared(kMark));
}

TEST(WasmObject, DamagedOnesDefineNothing) {
  const std::string whole = object();
  for (std::size_t length = 0; length < whole.size(); ++length) {
    const auto symbols = strong_definitions(whole.substr(0, length));
    EXPECT_TRUE(!symbols || symbols->empty()) << length;
  }
  const std::string archive = archive_of({whole});
  for (std::size_t length = 9; length < 68 + whole.size(); ++length) {
    const auto symbols = archive_definitions(archive.substr(0, length));
    EXPECT_TRUE(!symbols || symbols->empty()) << length;
  }
  for (std::size_t i = 0; i < archive.size(); ++i) {
    std::string damaged = archive;
    damaged[i] = '\xff';
    if (auto symbols = archive_definitions(damaged))
      for (const ObjectSymbol& one : *symbols) make_weak(damaged, one);
  }
}

}  // namespace
}  // namespace ros2wasm
