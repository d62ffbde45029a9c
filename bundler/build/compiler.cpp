// See compiler.hpp.
#include "bundler/build/compiler.hpp"

#include <sys/stat.h>

#include <fstream>

#include "bundler/io/process.hpp"

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
  Compiler compiler{.cxx = *cxx, .c = cxx->parent_path() / "emcc"};
  compiler.version = version_beside(real.parent_path());
  struct stat info {};
  if (::stat((real.parent_path() / "emcc.py").c_str(), &info) != 0) ::stat(real.c_str(), &info);
  compiler.identity = compiler.version + " " + real.string() + " " + std::to_string(info.st_size) +
                      " " + std::to_string(info.st_mtim.tv_sec);
  return compiler;
}

EnvironmentVariables compiler_environment(const EnvironmentVariables& variables) {
  EnvironmentVariables result;
  std::error_code error;
  if (!variables.contains("NODE_PATH") && fs::is_directory(kDebianNodeModules, error)) {
    result["NODE_PATH"] = kDebianNodeModules;
  }
  return result;
}

}  // namespace ros2wasm
