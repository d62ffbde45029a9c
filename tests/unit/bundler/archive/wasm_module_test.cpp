// The outer structure of modules: imports, kinds of link, names kept apart, hostile bytes.
#include "bundler/archive/wasm_module.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "bundler/build/link_line.hpp"
#include "bundler/build/single_link_object.hpp"

namespace ros2wasm {
namespace {

const std::string kHeader("\0asm\1\0\0\0", 8);

std::string sized(const std::string& text) {
  return std::string(1, static_cast<char>(text.size())) + text;
}
/// Sections may be longer than 127 bytes: two bytes of length.
std::string section(char id, const std::string& contents) {
  const std::size_t size = contents.size();
  return std::string({id, static_cast<char>((size & 0x7F) | 0x80), static_cast<char>(size >> 7U)}) +
         contents;
}
std::string custom(const std::string& name, const std::string& contents) {
  return section('\0', sized(name) + contents);
}

/// A module that imports one function of each given module and name.
std::string importing(const std::vector<std::pair<std::string, std::string>>& functions,
                      const std::string& memory_limits = "") {
  std::string imports;
  std::size_t count = functions.size();
  for (const auto& [module, name] : functions)
    imports += sized(module) + sized(name) + std::string("\0\0", 2);
  if (!memory_limits.empty()) {
    imports += sized("env") + sized("memory") + '\2' + memory_limits;
    ++count;
  }
  return kHeader + section('\1', std::string("\1\x60\0\0", 4)) +
         section('\2', std::string(1, static_cast<char>(count)) + imports);
}

TEST(WasmModule, ReadsImportsAndSections) {
  const auto module = read_wasm_module(importing({{"env", "a"}, {"ros2wasm", "wait"}}));
  ASSERT_TRUE(module);
  ASSERT_EQ(module->imports.size(), 2U);
  EXPECT_EQ(module->imports[1].module, "ros2wasm");
  EXPECT_EQ(module->imports[1].name, "wait");
  EXPECT_EQ(module->sections.size(), 2U);
  EXPECT_FALSE(imports_shared_memory(*module));
}

TEST(WasmModule, ASharedMemoryTellsThreadsApart) {
  const auto shared = read_wasm_module(importing({}, std::string("\3\1\2", 3)));
  ASSERT_TRUE(shared);
  EXPECT_TRUE(imports_shared_memory(*shared));
  const auto own = read_wasm_module(importing({}, std::string("\1\1\2", 3)));
  ASSERT_TRUE(own);
  EXPECT_FALSE(imports_shared_memory(*own));
}

// Guarantee, hostile input: a WebAssembly file that was cut or changed anywhere is refused, or read
// as what is there
TEST(WasmModule, EveryTruncationIsRefusedOrRead) {
  const std::string whole =
      importing({{"env", "a"}}, std::string("\3\1\2", 3)) + custom("name", "abc");
  for (std::size_t length = 0; length < whole.size(); ++length) {
    const auto module = read_wasm_module(std::string_view(whole).substr(0, length));
    if (module) {
      EXPECT_LE(module->sections.size(), 3U) << length;
    }
  }
  for (std::size_t at = 0; at < whole.size(); ++at) {
    std::string hostile = whole;
    hostile[at] = '\xff';
    (void)read_wasm_module(hostile);  // must not read outside or hang
  }
}

TEST(WasmModule, NamesAreKeptApart) {
  const std::string plain = importing({{"env", "a"}});
  const auto split =
      split_names(plain + custom("name", "the names") + custom("producers", "clang"));
  ASSERT_TRUE(split);
  EXPECT_EQ(split->program, plain);
  const auto names = read_wasm_module(split->names);
  ASSERT_TRUE(names);
  ASSERT_EQ(names->sections.size(), 1U);
  EXPECT_EQ(names->sections[0].name, "name");
  EXPECT_EQ(split->names.substr(names->sections[0].contents), "the names");
  EXPECT_TRUE(split_names(plain)->names.empty());
  EXPECT_FALSE(split_names("not a module"));
}

TEST(SingleLinkObject, IsAnObjectWithTheImport) {
  const auto object = read_wasm_module(single_link_object(TlsBase::kOfLinker));
  ASSERT_TRUE(object);
  const auto findings = classify_imports(*object);
  EXPECT_TRUE(findings.needs_threads);
  ASSERT_EQ(object->sections.size(), 6U);
  EXPECT_EQ(object->sections[4].name, "linking");
  EXPECT_EQ(object->sections[5].name, "reloc.CODE");
}

TEST(SingleLinkObject, HoldsTheBaseOfThreadLocalsForLinkersThatNeedIt) {
  const auto object = read_wasm_module(single_link_object(TlsBase::kZero));
  ASSERT_TRUE(object);
  constexpr int kGlobalSection = 6;
  ASSERT_EQ(object->sections.size(), 7U);
  EXPECT_EQ(object->sections[3].id, kGlobalSection);
  EXPECT_TRUE(classify_imports(*object).needs_threads);
}

TEST(SingleLinkObject, TheCompilerOfAnObjectTellsWhichLinkersThoseAre) {
  const auto made_by = [](const std::string& name, const std::string& version) {
    return kHeader + custom("producers", std::string("\2") + sized("language") + "\1" +
                                             sized("C11") + sized("") + sized("processed-by") +
                                             "\1" + sized(name) + sized(version));
  };
  EXPECT_EQ(producer_version(made_by("Debian clang", "14.0.6"), "clang"), "14.0.6");
  EXPECT_EQ(tls_base_for(made_by("Debian clang", "14.0.6")), TlsBase::kZero);
  EXPECT_EQ(tls_base_for(made_by("clang", "19.1.0 (https://example.org 0123)")), TlsBase::kZero);
  EXPECT_EQ(tls_base_for(made_by("clang", "20.0.0git (https://example.org 0123)")),
            TlsBase::kOfLinker);
  EXPECT_EQ(tls_base_for(made_by("rustc", "99.0.0")), TlsBase::kZero);
  EXPECT_EQ(tls_base_for(made_by("clang", "21.0").substr(0, 20)), TlsBase::kZero);
}

TEST(LinkLine, FindsWhatNobodyDefines) {
  const auto module = read_wasm_module(importing({{"wasi_snapshot_preview1", "fd_write"},
                                                  {"ros2wasm", "wait"},
                                                  {"env", "__syscall_getdents64"},
                                                  {"env", "getentropy"},
                                                  {"env", "_ZN3far4awayEi"},
                                                  {"elsewhere", "thing"}}));
  ASSERT_TRUE(module);
  const auto findings = classify_imports(*module);
  EXPECT_FALSE(findings.needs_threads);
  EXPECT_EQ(findings.undefined, (std::vector<std::string>{"_ZN3far4awayEi", "thing"}));
  EXPECT_EQ(demangled("_ZN3far4awayEi"), "far::away(int)");
  EXPECT_EQ(demangled("plain_c"), "plain_c");
}

TEST(LinkLine, LeavesOutWhatOnlyNativeLinkersKnow) {
  const LinkLine line =
      parse_link_line({"em++", "-rdynamic", "a.o", "-o", "x.wasm", "-lpthread", "-Wl,-rpath,/lib",
                       "-pthread", "libb.a", "-sSTACK_SIZE=1MB"});
  EXPECT_EQ(line.compiler, "em++");
  EXPECT_EQ(line.output, "x.wasm");
  EXPECT_EQ(line.arguments, (std::vector<std::string>{"a.o", "libb.a", "-sSTACK_SIZE=1MB"}));
}

TEST(LinkLine, TheTwoKindsDifferInThreadsOnly) {
  const LinkLine line = parse_link_line({"em++", "a.o", "-o", "x.wasm"});
  const auto single = link_command(line, LinkKind::kSingle, "/t/program");
  const auto threads = link_command(line, LinkKind::kThreads, "/t/program");
  const auto has = [](const std::vector<std::string>& words, const std::string& word) {
    return std::find(words.begin(), words.end(), word) != words.end();
  };
  EXPECT_TRUE(has(single, "-sSTANDALONE_WASM"));
  EXPECT_FALSE(has(single, "-pthread"));
  EXPECT_EQ(single.back(), "/t/program.wasm");
  EXPECT_FALSE(has(threads, "-sSTANDALONE_WASM"));
  EXPECT_TRUE(has(threads, "-pthread"));
  EXPECT_EQ(threads.back(), "/t/program.js");
  EXPECT_TRUE(has(single, "a.o") && has(threads, "a.o"));
}

TEST(LinkLine, ResponseFilesAreSplitAsGnuToolsDo) {
  EXPECT_EQ(split_response_file("a.o \"b c.o\"\n'd e' f\\ g ''"),
            (std::vector<std::string>{"a.o", "b c.o", "d e", "f g", ""}));
  EXPECT_TRUE(split_response_file("  \n").empty());
}

}  // namespace
}  // namespace ros2wasm
