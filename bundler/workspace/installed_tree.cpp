// See installed_tree.hpp.
#include "bundler/workspace/installed_tree.hpp"

#include <algorithm>
#include <array>

#include "bundler/io/files.hpp"
#include "bundler/workspace/python_imports.hpp"

namespace ros2wasm {
namespace fs = std::filesystem;
namespace {

constexpr std::array<std::string_view, 3> kInterfaceKinds = {"msg", "srv", "action"};

template <typename Visit>
void each_entry(const fs::path& folder, Visit visit) {
  std::error_code error;
  for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error))
    visit(*it);
}

/// The files of a folder of an installation, but links that lead out of it.
template <typename Visit>
void each_file(const fs::path& prefix, const fs::path& folder, Visit visit) {
  if (!path_within(prefix, prefix / folder)) return;
  each_entry(prefix / folder, [&](const fs::directory_entry& entry) {
    std::error_code error;
    const bool is_ours = entry.is_symlink(error)
                             ? is_installed_file(prefix, folder / entry.path().filename())
                             : entry.is_regular_file(error);
    if (is_ours) visit(entry);
  });
}

bool is_script(const fs::directory_entry& entry) {
  const auto text = read_file(entry.path(), kMostOfList);
  return text && is_python_script(*text);
}

bool may_be_run(const fs::directory_entry& entry) {
  std::error_code error;
  return (entry.status(error).permissions() & fs::perms::owner_exec) != fs::perms::none;
}

}  // namespace

bool is_installed_file(const fs::path& prefix, const fs::path& path) {
  std::error_code error;
  const auto real = path_within(prefix, prefix / path);
  return real && fs::is_regular_file(*real, error);
}

std::vector<InstalledProgram> installed_programs(const fs::path& prefix,
                                                 const std::string& package) {
  std::vector<InstalledProgram> result;
  each_file(prefix, fs::path("lib") / package, [&](const fs::directory_entry& entry) {
    const fs::path& file = entry.path();
    if (file.extension() == ".names") return;
    const bool is_wasm = file.extension() == ".wasm";
    const bool is_note = file.extension() == ".left_out";
    const fs::path name = is_wasm || is_note ? file.stem() : file.filename();
    const Outcome<std::string> note = is_note ? read_file(file, kMostOfList) : std::string();
    const bool runs_python = !is_wasm && !is_note && is_script(entry);
    // As natively: who may not be run is none, whatever its first line says.
    const auto kind = is_wasm                            ? ProgramKind::kWasm
                      : runs_python && may_be_run(entry) ? ProgramKind::kPython
                                                         : ProgramKind::kNone;
    result.push_back({.package = package,
                      .executable = name.string(),
                      .file = file,
                      .kind = kind,
                      .left_out = note ? *note : "a library",
                      .may_not_be_run = runs_python && kind == ProgramKind::kNone});
  });
  std::sort(result.begin(), result.end(), [](const InstalledProgram& a, const InstalledProgram& b) {
    return a.executable < b.executable;
  });
  return result;
}

std::vector<std::string> programs_in_bin(const fs::path& prefix) {
  std::vector<std::string> names;
  each_file(prefix, "bin", [&](const fs::directory_entry& entry) {
    const fs::path& file = entry.path();
    if (file.extension() == ".wasm") {
      names.push_back(file.stem().string());
    } else if (is_script(entry)) {
      names.push_back(file.filename().string());
    }
  });
  std::sort(names.begin(), names.end());
  return names;
}

std::vector<InstalledPackage> installed_packages(const fs::path& prefix) {
  std::vector<InstalledPackage> result;
  each_entry(prefix / "share", [&](const fs::directory_entry& entry) {
    std::error_code error;
    if (!fs::is_regular_file(entry.path() / "package.xml", error)) return;
    const std::string name = entry.path().filename().string();
    result.push_back({.name = name,
                      .version = {},
                      .prefix = prefix,
                      .programs = installed_programs(prefix, name)});
  });
  std::sort(result.begin(), result.end(),
            [](const InstalledPackage& a, const InstalledPackage& b) { return a.name < b.name; });
  return result;
}

void collect_interfaces(const fs::path& prefix, const std::string& package, InterfaceTexts& into) {
  for (const std::string_view kind : kInterfaceKinds) {
    each_file(prefix, fs::path("share") / package / kind, [&](const fs::directory_entry& entry) {
      const fs::path& file = entry.path();
      if (file.extension() != "." + std::string(kind)) return;
      const std::string type = package + "/" + std::string(kind) + "/" + file.stem().string();
      if (into.contains(type)) return;
      if (auto text = read_file(file, kMostOfList)) into.emplace(type, std::move(text).value());
    });
  }
}

}  // namespace ros2wasm
