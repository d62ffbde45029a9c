// See compiler_parts.hpp.
#include "bundler/build/compiler_parts.hpp"

#include <sys/stat.h>

#include <algorithm>
#include <array>
#include <regex>
#include <set>

#include "bundler/io/files.hpp"
#include "bundler/io/sha256.hpp"
#include "workspace_schema/base/suggestion.hpp"

namespace ros2wasm {
namespace fs = std::filesystem;
namespace {

constexpr const char* kBuildPrefix = "clang";

/// The libraries of single links and of links with threads, as the driver chooses them for our
/// options.
constexpr auto kLibraries = std::to_array<std::string_view>({
    "libc++-except.a",
    "libc++-mt-except.a",
    "libc++abi-except.a",
    "libc++abi-mt-except.a",
    "libc-mt.a",
    "libc.a",
    "libcompiler_rt-mt.a",
    "libcompiler_rt.a",
    "libdlmalloc-mt.a",
    "libdlmalloc.a",
    "libstandalonewasm-memgrow.a",
    "libunwind-except.a",
    "libunwind-mt-except.a",
});

std::string variable(const EnvironmentVariables& variables, const std::string& name) {
  const auto found = variables.find(name);
  return found == variables.end() ? std::string() : found->second;
}

/// A value of Emscripten's configuration, which is written in Python: only one that is a text.
std::string configured(const fs::path& emscripten, const EnvironmentVariables& variables,
                       const std::string& key) {
  if (std::string value = variable(variables, "EM_" + key); !value.empty()) return value;
  const std::string named = variable(variables, "EM_CONFIG");
  const fs::path file = named.empty() ? emscripten / ".emscripten" : fs::path(named);
  std::error_code error;
  if (!fs::is_regular_file(file, error)) return {};
  const auto text = read_file(file, kMostOfData);
  if (!text) return {};
  const std::regex line("(?:^|\\n)" + key + R"( *= *['"]([^'"\n]+)['"])");
  std::smatch match;
  return std::regex_search(*text, match, line) ? std::string(match[1]) : std::string();
}

/// An SDK has clang beside Emscripten's folder; distributions say in the configuration where it is,
/// and which of several versions: Debian alone has clang-14 there, and clang only with a package
/// that nothing asks for.
fs::path find_clang(const fs::path& emscripten, const EnvironmentVariables& variables) {
  const std::string root = configured(emscripten, variables, "LLVM_ROOT");
  const std::string version = configured(emscripten, variables, "CLANG_ADD_VERSION");
  const std::string name = version.empty() ? "clang" : "clang-" + version;
  std::error_code error;
  for (const fs::path& folder : {fs::path(root), emscripten.parent_path() / "bin"}) {
    if (!folder.empty() && fs::exists(folder / name, error))
      return fs::canonical(folder / name, error);
  }
  return {};
}

/// The folder of clang's own headers is named by its version.
std::string version_of_clang(const fs::path& clang) {
  std::string longest;
  std::error_code error;
  for (fs::directory_iterator it(clang.parent_path().parent_path() / "lib/clang", error), end;
       !error && it != end; it.increment(error)) {
    const std::string name = it->path().filename().string();
    const bool is_version = name.find_first_not_of("0123456789.") == std::string::npos;
    if (is_version && name.size() > longest.size()) longest = name;
  }
  return longest;
}

void add_stamp(std::string& text, const fs::path& file) {
  struct stat info {};
  if (::stat(file.c_str(), &info) != 0) return;
  text += " " + file.string() + " " + std::to_string(info.st_size) + " " +
          std::to_string(info.st_mtim.tv_sec);
}

std::string hash_of(const std::vector<fs::path>& libraries) {
  Hasher hasher;
  for (const fs::path& library : libraries) {
    const auto hashes = hash_file(library);
    if (!hashes) return {};
    hasher.add(library.filename().string() + " " + hashes->sha256 + "\n");
  }
  return hasher.hex();
}

}  // namespace

CompilerParts find_compiler_parts(const fs::path& emscripten,
                                  const EnvironmentVariables& variables) {
  CompilerParts parts{.clang = find_clang(emscripten, variables), .clang_version = {}};
  if (!parts.clang.empty()) parts.clang_version = version_of_clang(parts.clang);
  const std::string cache = configured(emscripten, variables, "CACHE");
  const fs::path folder =
      (cache.empty() ? emscripten / "cache" : fs::path(cache)) / "sysroot/lib/wasm32-emscripten";
  std::error_code error;
  for (const std::string_view name : kLibraries)
    if (fs::exists(folder / name, error)) parts.libraries.push_back(folder / name);
  parts.has_all_libraries = parts.libraries.size() == kLibraries.size();
  return parts;
}

std::string stamp_of(const CompilerParts& parts) {
  std::string text = parts.clang_version;
  add_stamp(text, parts.clang);
  for (const fs::path& library : parts.libraries) add_stamp(text, library);
  return text;
}

std::string abi_build(const CompilerParts& parts, const fs::path& cache) {
  constexpr std::size_t kDigits = 12;
  if (parts.clang_version.empty() || !parts.has_all_libraries) return {};
  const fs::path kept = cache / "compilers" / sha256_hex(stamp_of(parts)).substr(0, 16);
  std::error_code error;
  if (!cache.empty() && fs::exists(kept, error))
    if (const auto known = read_file(kept, kMostOfData); known && known->starts_with(kBuildPrefix))
      return *known;
  const std::string hash = hash_of(parts.libraries);
  if (hash.empty()) return {};
  std::string build = kBuildPrefix + parts.clang_version + "_h" + hash.substr(0, kDigits) + "_0";
  // Not kept is only slower.
  if (!cache.empty()) (void)write_file(kept, build);
  return build;
}

std::optional<Diagnostic> other_parts(const Compiler& compiler, const std::string& own_build,
                                      const std::vector<std::string>& packaged) {
  std::vector<std::string> known;
  for (const std::string& build : packaged)
    if (build.starts_with(kBuildPrefix)) known.push_back(build);
  if (own_build.empty() || known.empty() ||
      std::find(known.begin(), known.end(), own_build) != known.end())
    return std::nullopt;
  return Diagnostic{
      .code = "R2W0530",
      .kind = FailureKind::kEnvironment,
      .message = "the channels' packages for Emscripten " + compiler.version +
                 " come of another clang, or have other system libraries in them",
      .why = {"here they are " + own_build + ", clang's version and a hash of the libraries",
              "those of the packages are " + name_list(known),
              "the compiler is " + compiler.cxx.string()}};
}

Outcome<Compiler> fitting_compiler(Outcome<Compiler> found,
                                   const std::vector<PackageRecord>& packaged,
                                   const EnvironmentVariables& variables, const fs::path& cache) {
  std::set<std::string> versions;
  for (const PackageRecord& record : packaged) versions.insert(record.version);
  const std::vector<std::string> sorted(versions.begin(), versions.end());
  if (!found) return no_compiler(sorted);
  if (auto none = no_packages_for(*found, sorted, variables)) return std::move(*none);
  std::vector<std::string> builds;
  for (const PackageRecord& record : packaged)
    if (record.version == found->version) builds.push_back(record.build);
  const CompilerParts parts = find_compiler_parts(found->home, variables);
  if (auto other = other_parts(*found, abi_build(parts, cache), builds)) return std::move(*other);
  return found;
}

}  // namespace ros2wasm
