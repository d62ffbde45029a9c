// Writing of lock.hpp. One form for one content: fixed order of keys, packages and texts.
#include "workspace_schema/schema/lock.hpp"

#include <algorithm>

#include "workspace_schema/base/yaml_scalar.hpp"

namespace ros2wasm {
namespace {

void put_text(std::string& out, std::string_view indent, std::string_view key,
              const std::string& value) {
  out.append(indent).append(key).append(": ").append(as_yaml_text(value)).append("\n");
}

void put_number(std::string& out, std::string_view indent, std::string_view key,
                std::uint64_t value) {
  out.append(indent).append(key).append(": ").append(std::to_string(value)).append("\n");
}

void put_list(std::string& out, const std::string& indent, std::string_view key,
              const std::vector<std::string>& values) {
  if (values.empty()) return;
  out.append(indent).append(key).append(":\n");
  for (const std::string& value : values)
    out.append(indent).append("  - ").append(as_yaml_text(value)).append("\n");
}

void put_package(std::string& out, const PackageRecord& record) {
  const std::string indent = "    ";
  out.append("  - name: ").append(as_yaml_text(record.name)).append("\n");
  put_text(out, indent, "version", record.version);
  put_text(out, indent, "build", record.build);
  put_number(out, indent, "build_number", record.build_number);
  put_text(out, indent, "subdir", record.subdir);
  put_text(out, indent, "channel", record.channel);
  put_text(out, indent, "file", record.file_name);
  put_text(out, indent, "url", record.url);
  if (!record.sha256.empty()) put_text(out, indent, "sha256", record.sha256);
  if (!record.md5.empty()) put_text(out, indent, "md5", record.md5);
  put_number(out, indent, "size", record.size);
  put_list(out, indent, "depends", record.depends);
  put_list(out, indent, "constrains", record.constrains);
  put_list(out, indent, "track_features", record.track_features);
  if (!record.license.empty()) put_text(out, indent, "license", record.license);
  if (record.timestamp_ms > 0) {
    put_number(out, indent, "timestamp_ms", static_cast<std::uint64_t>(record.timestamp_ms));
  }
  if (record.noarch != NoarchKind::kNo) {
    put_text(out, indent, "noarch", record.noarch == NoarchKind::kPython ? "python" : "generic");
  }
}

void put_wheel(std::string& out, const LockedWheel& wheel) {
  const std::string indent = "    ";
  out.append("  - name: ").append(as_yaml_text(wheel.project)).append("\n");
  put_text(out, indent, "version", wheel.version);
  if (wheel.url.empty()) put_text(out, indent, "file", wheel.file);
  if (!wheel.url.empty()) put_text(out, indent, "url", wheel.url);
  put_text(out, indent, "sha256", wheel.sha256);
  put_number(out, indent, "size", wheel.size);
}

void put_library(std::string& out, const LockedLibrary& library) {
  const std::string indent = "    ";
  out.append("  - name: ").append(as_yaml_text(library.project)).append("\n");
  put_text(out, indent, "version", library.version);
  put_text(out, indent, "file", library.file);
  put_text(out, indent, "sha256", library.sha256);
  put_list(out, indent, "depends", library.depends);
}

void put_source(std::string& out, const LockedSource& source) {
  const std::string indent = "    ";
  if (source.git.empty()) {
    out.append("  - archive: ").append(as_yaml_text(source.archive)).append("\n");
    put_text(out, indent, "sha256", source.sha256);
    if (source.size != 0) put_number(out, indent, "size", source.size);
    if (!source.model.empty()) put_text(out, indent, "model", source.model);
    return put_list(out, indent, "packages", source.packages);
  }
  out.append("  - git: ").append(as_yaml_text(source.git)).append("\n");
  if (!source.revision.empty()) put_text(out, indent, "revision", source.revision);
  put_text(out, indent, "commit", source.commit);
  put_text(out, indent, "tree", source.tree);
  if (!source.package.empty()) put_text(out, indent, "package", source.package);
  put_list(out, indent, "packages", source.packages);
}

}  // namespace

std::string write_lock(const Lock& lock) {
  std::string out =
      "# Which packages this workspace uses, exactly. Written by ros2wasm; keep it under version "
      "control.\n";
  put_number(out, "", "schema", static_cast<std::uint64_t>(lock.schema));
  put_text(out, "", "platform", lock.platform);
  put_list(out, "", "channels", lock.channels);
  std::vector<std::string> specs = lock.specs;
  std::sort(specs.begin(), specs.end());
  specs.erase(std::unique(specs.begin(), specs.end()), specs.end());
  put_list(out, "", "specs", specs);
  put_list(out, "", "absent", lock.absent);
  put_list(out, "", "built_here", lock.built_here);
  std::vector<const PackageRecord*> packages;
  for (const PackageRecord& record : lock.packages) packages.push_back(&record);
  std::sort(packages.begin(), packages.end(),
            [](const PackageRecord* a, const PackageRecord* b) { return a->name < b->name; });
  out += packages.empty() ? "packages: []\n" : "packages:\n";
  for (const PackageRecord* record : packages) put_package(out, *record);
  if (!lock.sources.empty()) out += "sources:\n";
  for (const LockedSource& source : lock.sources) put_source(out, source);
  if (!lock.wheels.empty()) out += "wheels:\n";
  for (const LockedWheel& wheel : lock.wheels) put_wheel(out, wheel);
  if (lock.libraries.empty()) return out;
  put_text(out, "", "python_index", lock.python_index);
  out += "libraries:\n";
  for (const LockedLibrary& library : lock.libraries) put_library(out, library);
  return out;
}

}  // namespace ros2wasm
