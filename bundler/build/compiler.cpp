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

Outcome<Compiler> find_compiler() {
  std::optional<fs::path> cxx;
  if (const auto sdk = environment_variable("EMSDK")) {
    cxx = find_program((fs::path(*sdk) / "upstream/emscripten/em++").string());
  }
  if (!cxx) cxx = find_program("em++");
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

std::map<std::string, std::string> compiler_environment() {
  std::map<std::string, std::string> result;
  std::error_code error;
  if (!environment_variable("NODE_PATH") && fs::is_directory(kDebianNodeModules, error)) {
    result["NODE_PATH"] = kDebianNodeModules;
  }
  return result;
}

}  // namespace ros2wasm
