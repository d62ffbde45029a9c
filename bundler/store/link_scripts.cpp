// See link_scripts.hpp.
#include "bundler/store/link_scripts.hpp"

#include <algorithm>

#include "bundler/archive/link_rules.hpp"
#include "bundler/io/files.hpp"
#include "workspace_schema/base/text_pattern.hpp"

namespace ros2wasm {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostShown = 2000;  // bytes of a script

/// Without what a terminal would obey.
std::string shown(std::string_view text) {
  std::string out;
  for (const char c : text.substr(0, kMostShown)) {
    const auto byte = static_cast<unsigned char>(c);
    out += (byte < 0x20 && c != '\n' && c != '\t') || byte == 0x7F ? '?' : c;
  }
  while (out.ends_with('\n')) out.pop_back();
  return text.size() > kMostShown ? out + "\n..." : out;
}

/// The package that brought a file of `bin` or `Scripts`: the last one that has it won. `named`
/// where that is not known.
std::string bringer_of(const std::string& path, const std::string& named,
                       const std::vector<PackageRecord>& records, const Store& store) {
  const std::string file = fs::path(path).filename().string();
  for (auto record = records.rbegin(); record != records.rend(); ++record) {
    const fs::path package = store.package_place(*record);
    for (const std::string& packed : {path, "python-scripts/" + file}) {
      const bool moved = packed != path;
      if (moved && (record->noarch != NoarchKind::kPython || !path.starts_with("bin/"))) continue;
      std::error_code error;
      if (!package.empty() && fs::exists(fs::symlink_status(package / packed, error)))
        return record->name;
    }
  }
  return named;
}

}  // namespace

Outcome<std::vector<LinkScript>> link_scripts_in(const fs::path& prefix,
                                                 const std::vector<PackageRecord>& records,
                                                 const Store& store) {
  std::vector<LinkScript> scripts;
  for (const char* folder : {"bin", "Scripts"}) {
    std::error_code error;
    if (!fs::is_directory(prefix / folder, error)) continue;
    fs::directory_iterator it(prefix / folder, error);
    for (const fs::directory_iterator end; !error && it != end; it.increment(error)) {
      std::string path = std::string(folder) + "/" + it->path().filename().string();
      if (const auto named = link_script_package(path))
        scripts.push_back({.package = bringer_of(path, *named, records, store), .path = path});
    }
    if (error) return cannot_read(prefix / folder, error.value());
  }
  std::sort(scripts.begin(), scripts.end(),
            [](const LinkScript& a, const LinkScript& b) { return a.path < b.path; });
  return scripts;
}

Diagnostics refused_link_scripts(const fs::path& prefix, const std::vector<LinkScript>& scripts,
                                 const std::vector<std::string>& ignored) {
  Diagnostics errors;
  for (const LinkScript& script : scripts) {
    if (std::any_of(ignored.begin(), ignored.end(), [&script](const std::string& name) {
          return ascii_lower(name) == ascii_lower(script.package);
        }))
      continue;
    const auto text = read_file(prefix / script.path, kMostOfText);
    errors.push_back(Diagnostic{
        .code = "R2W0227",
        .message = "`" + script.package + "` has a link script, `" + script.path +
                   "`, which ros2wasm does not run",
        .why = {"conda would run it on this machine; what it does may be needed"},
        .fix = {"where the package works without it, name `" + ascii_lower(script.package) +
                "` under `ignore_link_scripts:` in workspace.yaml"},
        .detail = text ? shown(*text) : std::string()});
  }
  return errors;
}

}  // namespace ros2wasm
