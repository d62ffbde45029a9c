// See python_tree.hpp.
#include "bundler/launch/python_tree.hpp"

#include "bundler/io/files.hpp"

namespace ros2wasm {
namespace fs = std::filesystem;
namespace {

/// Compiled programs and what stands beside them.
bool is_for_compiled(const fs::path& path) {
  const std::string ending = path.extension().string();
  return ending == ".wasm" || ending == ".names" || ending == ".left_out" || ending == ".a";
}

Outcome<Done> collect(const fs::path& prefix, const std::string& folder, PythonFiles& into) {
  std::error_code error;
  if (!fs::is_directory(prefix / folder, error)) return Done{};
  const auto tree = list_tree(prefix / folder);
  if (!tree) return tree.errors();
  for (const TreeEntry& entry : *tree) {
    const std::string path = folder + "/" + entry.path;
    const bool is_file = fs::is_regular_file(prefix / path, error);
    if (!is_file || into.contains(path) || is_for_compiled(path) || path.ends_with(".pyc"))
      continue;
    auto bytes = read_file(prefix / path);
    if (!bytes) return std::move(bytes).errors();
    into.emplace(path, std::move(bytes).value());
  }
  return Done{};
}

}  // namespace

Outcome<Done> collect_python_modules(const fs::path& prefix, PythonFiles& into) {
  return collect(prefix, kPythonModules, into);
}

Outcome<Done> collect_python_scripts(const fs::path& prefix, const std::string& package,
                                     PythonFiles& into) {
  return collect(prefix, "lib/" + package, into);
}

Diagnostic no_pyodide(std::string why) {
  return Diagnostic{.code = "R2W0517",
                    .kind = FailureKind::kEnvironment,
                    .message = "no channel has Pyodide, which reads and runs Python packages",
                    .why = {std::move(why)}};
}

}  // namespace ros2wasm
