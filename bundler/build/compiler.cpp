// See compiler.hpp.
#include "bundler/build/compiler.hpp"

#include <sys/stat.h>

#include <algorithm>
#include <fstream>

#include "bundler/build/compiler_parts.hpp"
#include "bundler/io/process.hpp"
#include "workspace_schema/base/suggestion.hpp"
#include "workspace_schema/conda/version.hpp"

namespace ros2wasm {
namespace fs = std::filesystem;
namespace {

constexpr const char* kDebianNodeModules = "/usr/share/nodejs";

/// The version stands in a file beside the compiler's scripts, in quotes in some versions.
std::string version_beside(const fs::path& folder) {
  std::ifstream stream(folder / "emscripten-version.txt");
  std::string text;
  std::getline(stream, text);
  std::erase(text, '"');
  return text;
}

}  // namespace

Outcome<Compiler> find_compiler(const EnvironmentVariables& variables) {
  std::optional<fs::path> cxx;
  const auto sdk = variables.find("EMSDK");
  if (sdk != variables.end() && !sdk->second.empty()) {
    cxx = find_program((fs::path(sdk->second) / "upstream/emscripten/em++").string());
  }
  const auto path = variables.find("PATH");
  if (!cxx) cxx = find_program("em++", path == variables.end() ? "/usr/bin:/bin" : path->second);
  if (!cxx) {
    return Diagnostic{.code = "R2W0501",
                      .kind = FailureKind::kEnvironment,
                      .message = "Emscripten, the compiler for sites, is not installed",
                      .why = {"there is no `em++` on PATH and none under EMSDK"},
                      .fix = {"sudo apt-get install emscripten"}};
  }
  std::error_code error;
  const fs::path real = fs::canonical(*cxx, error);
  Compiler compiler{.cxx = *cxx, .c = cxx->parent_path() / "emcc", .home = real.parent_path()};
  compiler.version = version_beside(real.parent_path());
  struct stat info {};
  if (::stat((real.parent_path() / "emcc.py").c_str(), &info) != 0) ::stat(real.c_str(), &info);
  compiler.identity = compiler.version + " " + real.string() + " " + std::to_string(info.st_size) +
                      " " + std::to_string(info.st_mtim.tv_sec) + " " +
                      stamp_of(find_compiler_parts(real.parent_path(), variables));
  return compiler;
}

Compiler no_compiler(const std::vector<std::string>& packaged) {
  Compiler compiler{.cxx = {}, .c = {}, .home = {}, .version = {}, .identity = {}};
  std::optional<Version> newest;
  for (const std::string& text : packaged) {
    auto version = Version::parse(text);
    if (!version || (newest && *version <= *newest)) continue;
    compiler.version = text;
    newest = std::move(*version);
  }
  return compiler;
}

std::optional<Diagnostic> no_packages_for(const Compiler& compiler,
                                          const std::vector<std::string>& packaged,
                                          const EnvironmentVariables& variables) {
  const auto has = [&](const std::string& version) {
    return std::find(packaged.begin(), packaged.end(), version) != packaged.end();
  };
  if (packaged.empty() || compiler.version.empty() || has(compiler.version)) return std::nullopt;
  Diagnostic result{
      .code = "R2W0530",
      .kind = FailureKind::kEnvironment,
      .message = "the channels have no packages for Emscripten " + compiler.version,
      .why = {"the compiler is " + compiler.cxx.string(),
              "programs and the libraries in them must come of one compiler; those of the channels "
              "come of Emscripten " +
                  name_list(packaged)}};
  EnvironmentVariables without = variables;
  if (without.erase("EMSDK") > 0) {
    const auto other = find_compiler(without);
    if (other && has(other->version)) result.fix.emplace_back("unset EMSDK");
  }
  return result;
}

EnvironmentVariables compiler_environment(const EnvironmentVariables& variables) {
  EnvironmentVariables result;
  std::error_code error;
  if (!variables.contains("NODE_PATH") && fs::is_directory(kDebianNodeModules, error)) {
    result["NODE_PATH"] = kDebianNodeModules;
  }
  return result;
}

EnvironmentVariables tool_environment(const EnvironmentVariables& variables,
                                      const fs::path& compiler) {
  EnvironmentVariables result = compiler_environment(variables);
  const auto path = variables.find("PATH");
  if (path != variables.end() && compiler.is_absolute()) {
    result["PATH"] = compiler.parent_path().string() + ":" + path->second;
  }
  return result;
}

}  // namespace ros2wasm
