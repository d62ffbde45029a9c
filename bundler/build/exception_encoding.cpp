// See exception_encoding.hpp.
#include "bundler/build/exception_encoding.hpp"

#include <array>
#include <vector>

#include "bundler/io/files.hpp"
#include "bundler/io/installation.hpp"
#include "bundler/io/process.hpp"
#include "bundler/io/sha256.hpp"

namespace ros2wasm {
namespace fs = std::filesystem;
namespace {

/// The features that Emscripten 3.1.6 uses and that the standard encoding needs. Not "all": newer
/// features change the encoding of other sections, which fewer browsers read.
constexpr std::array<const char*, 7> kFeatures = {
    "--enable-exception-handling", "--enable-reference-types", "--enable-threads",
    "--enable-bulk-memory",        "--enable-mutable-globals", "--enable-sign-ext",
    "--enable-multivalue"};

}  // namespace

Outcome<std::string> with_standard_exceptions(std::string_view program, const fs::path& executable,
                                              const fs::path& cache,
                                              const Cancellation& cancellation) {
  const fs::path kept = cache / "exnref" / (sha256_hex(program) + ".wasm");
  if (auto known = read_file(kept, kMostOfData)) return std::move(known).value();
  const auto tool = find_npm_tool(executable, "wasm-opt");
  if (!tool) {
    return Diagnostic{
        .code = "R2W0509",
        .kind = FailureKind::kEnvironment,
        .message = "`site: exceptions: standard` needs binaryen's wasm-opt, which is not there",
        .why = {"it comes with the npm package binaryen"}};
  }
  auto folder = TemporaryDirectory::make(cache / "exnref", ".new-");
  if (!folder) return std::move(folder).errors();
  const fs::path input = folder->path() / "in.wasm";
  const fs::path output = folder->path() / "out.wasm";
  if (auto written = write_file(input, program); !written) return std::move(written).errors();
  // npm's node lies beside npm's tools; whichever `node` is on PATH may be too old for them.
  const fs::path node = tool->parent_path() / "node";
  std::error_code error;
  const std::string interpreter = fs::exists(node, error) ? node.string() : "node";
  std::vector<std::string> command = {interpreter, tool->string()};
  command.insert(command.end(), kFeatures.begin(), kFeatures.end());
  command.insert(command.end(), {"--translate-to-exnref", input.string(), "-o", output.string()});
  const auto result = run_process({.arguments = std::move(command)}, cancellation);
  if (!result) return result.errors();
  if (result->exit_code != 0) {
    return Diagnostic{.code = "R2W0509",
                      .kind = FailureKind::kBug,
                      .message = "wasm-opt cannot translate a program's exceptions",
                      .detail = result->output};
  }
  auto translated = read_file(output, kMostOfData);
  if (translated) fs::rename(output, kept, error);  // the cache is a help, not a must
  return translated;
}

}  // namespace ros2wasm
