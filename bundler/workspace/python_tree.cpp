// See python_tree.hpp.
#include "bundler/workspace/python_tree.hpp"

#include "bundler/io/files.hpp"
#include "bundler/workspace/installed_tree.hpp"

namespace ros2wasm {
namespace fs = std::filesystem;
namespace {

/// Compiled programs and what stands beside them. Modules may have such files as their data.
bool is_for_compiled(const fs::path& path) {
  const std::string ending = path.extension().string();
  return ending == ".wasm" || ending == ".names" || ending == ".left_out" || ending == ".a";
}

/// Begin of what the sites' Python has compiled and holds against the source by its hash (PEP 552):
/// by a time it would never hold.
constexpr std::string_view kCheckedByHash{"\xcb\x0d\x0d\x0a\x03\x00\x00\x00", 8};

Outcome<LeftOut> collect(const fs::path& prefix, const std::string& folder, PythonFiles& into) {
  LeftOut left_out;
  std::error_code error;
  if (!fs::is_directory(prefix / folder, error)) return left_out;
  if (!path_within(prefix, prefix / folder)) return LeftOut{folder + kLeadsElsewhere};
  const auto tree = list_tree(prefix / folder);
  if (!tree) return tree.errors();
  for (const TreeEntry& entry : *tree) {
    const std::string path = folder + "/" + entry.path;
    const bool is_link = entry.kind == FileKind::kLink;
    const bool is_program = folder != kPythonModules && is_for_compiled(path);
    if ((!is_link && entry.kind != FileKind::kFile) || into.contains(path) || is_program) continue;
    if (is_link && !is_installed_file(prefix, path)) {
      left_out.push_back(path + kLeadsElsewhere);
      continue;
    }
    auto bytes = read_file(prefix / path, kMostOfData);
    if (!bytes) return std::move(bytes).errors();
    if (path.ends_with(".pyc") && !bytes->starts_with(kCheckedByHash)) continue;
    into.emplace(path, std::move(bytes).value());
  }
  return left_out;
}

}  // namespace

Outcome<LeftOut> collect_python_modules(const fs::path& prefix, PythonFiles& into) {
  return collect(prefix, kPythonModules, into);
}

Outcome<LeftOut> collect_python_scripts(const fs::path& prefix, const std::string& package,
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
