// See site_components.hpp.
#include "bundler/site_components.hpp"

#include <algorithm>

#include "bundler/io/files.hpp"
#include "workspace_schema/base/secret_text.hpp"
#include "workspace_schema/base/text_encoding.hpp"
#include "workspace_schema/base/text_pattern.hpp"
#include "workspace_schema/base/trimmed_text.hpp"

namespace ros2wasm {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostFiles = 32;
constexpr std::uint64_t kLargest = 256 * 1024;

/// `LICENSE`, `COPYING.txt`, `LICENSE-MIT`, `UNLICENSE`.
bool is_license_name(const std::string& path) {
  const std::string name = ascii_lower(fs::path(path).filename().string());
  return name.starts_with("license") || name.starts_with("licence") ||
         name.starts_with("copying") || name.starts_with("notice") || name.starts_with("unlicense");
}

bool is_license_text(const std::string& text) {
  return !text.empty() && text.size() <= kLargest && !first_invalid_utf8(text) &&
         text.find('\0') == std::string::npos;
}

/// Letters, digits and `.-_~`, as package URLs have them.
std::string in_purl(std::string_view text) {
  constexpr std::string_view kHex = "0123456789ABCDEF";
  std::string out;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if ((c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '.' ||
        c == '-' || c == '_' || c == '~') {
      out += c;
    } else {
      out += '%';
      out += kHex[byte >> 4U];
      out += kHex[byte & 15U];
    }
  }
  return out;
}

SiteComponent of_channel(const PackageRecord& record, const Store& store) {
  SiteComponent component{.kind = ComponentKind::kConda,
                          .name = record.name,
                          .version = record.version,
                          .licenses = {},
                          .sha256 = {},  // of its archive: the same files come in several forms
                          .address = {},
                          .purl = "pkg:conda/" + in_purl(record.name) + "@" +
                                  in_purl(record.version) + "?build=" + in_purl(record.build) +
                                  "&subdir=" + in_purl(record.subdir),
                          .texts = {}};
  if (!record.license.empty()) component.licenses.push_back(record.license);
  if (const fs::path place = store.package_place(record); !place.empty())
    component.texts = license_texts(place / "info" / "licenses", true);
  return component;
}

/// A field of the METADATA of a wheel, of one line; empty when there is none.
std::string wheel_field(std::string_view metadata, std::string_view name) {
  while (!metadata.empty() && !metadata.starts_with('\n') && !metadata.starts_with('\r')) {
    const std::size_t end = std::min(metadata.find('\n'), metadata.size());
    const std::string_view line = metadata.substr(0, end);
    metadata.remove_prefix(std::min(end + 1, metadata.size()));
    if (line.starts_with(name) && line.substr(name.size()).starts_with(':'))
      return std::string(trimmed(line.substr(name.size() + 1)));
  }
  return {};
}

void add_licenses(const Wheel& wheel, SiteComponent& component) {
  for (const auto& [path, bytes] : wheel.files) {
    const std::size_t info = path.find(".dist-info/");
    if (info == std::string::npos) continue;
    if (path.substr(info) == ".dist-info/METADATA") {
      std::string license = wheel_field(bytes, "License-Expression");
      if (license.empty()) license = wheel_field(bytes, "License");
      if (!license.empty()) component.licenses.push_back(std::move(license));
    } else if ((is_license_name(path) || path.find("/licenses/", info) != std::string::npos ||
                path.find("/license_files/", info) != std::string::npos) &&
               is_license_text(bytes)) {
      component.texts.push_back(bytes);
    }
  }
}

SiteComponent of_wheel(const NamedWheel& wheel) {
  SiteComponent component{.kind = ComponentKind::kWheel,
                          .name = wheel.locked.project,
                          .version = wheel.locked.version,
                          .licenses = {},
                          .sha256 = wheel.locked.sha256,
                          .address = with_masked_secrets(wheel.locked.url),
                          .purl = {},
                          .texts = {}};
  add_licenses(wheel.wheel, component);
  return component;
}

/// Sorted; those of the folder itself, or of all below it, with `whatever_name`.
std::vector<fs::path> license_paths(const fs::path& folder, bool whatever_name) {
  std::vector<fs::path> files;
  std::error_code error;
  fs::recursive_directory_iterator it(folder, error);
  for (const fs::recursive_directory_iterator end; !error && it != end; it.increment(error)) {
    if (!whatever_name) it.disable_recursion_pending();
    std::error_code unknown;
    if (it->symlink_status(unknown).type() != fs::file_type::regular) continue;
    if (it->file_size(unknown) > kLargest || unknown) continue;
    if (whatever_name || is_license_name(it->path().string())) files.push_back(it->path());
  }
  std::sort(files.begin(), files.end());
  if (files.size() > kMostFiles) files.resize(kMostFiles);
  return files;
}

}  // namespace

std::vector<fs::path> license_files(const fs::path& folder) {
  return license_paths(folder, false);
}

std::vector<std::string> license_texts(const fs::path& folder, bool whatever_name) {
  std::vector<std::string> texts;
  for (const fs::path& file : license_paths(folder, whatever_name)) {
    auto text = read_file(file, kMostOfText);
    if (text && is_license_text(*text)) texts.push_back(std::move(text).value());
  }
  return texts;
}

SiteComponent library_component(const LibraryFiles& library, const std::string& index) {
  SiteComponent component{
      .kind = ComponentKind::kWheel,
      .name = library.locked.project,
      .version = library.locked.version,
      .licenses = {},
      .sha256 = library.locked.sha256,
      .address = is_network_url(index) ? with_masked_secrets(index + library.locked.file) : "",
      .purl = {},
      .texts = {}};
  add_licenses(library.wheel, component);
  return component;
}

std::vector<SiteComponent> site_components(const std::vector<PackageRecord>& records,
                                           const Store& store,
                                           const std::vector<NamedWheel>& wheels,
                                           const std::vector<LocalPackage>& packages,
                                           const LeftOutChains& left_out) {
  std::vector<SiteComponent> components;
  components.reserve(records.size() + wheels.size() + packages.size());
  for (const PackageRecord& record : records) components.push_back(of_channel(record, store));
  for (const NamedWheel& wheel : wheels) components.push_back(of_wheel(wheel));
  for (const LocalPackage& package : packages) {
    if (left_out.contains(package.xml.name.value)) continue;
    SiteComponent component{.kind = ComponentKind::kWorkspace,
                            .name = package.xml.name.value,
                            .version = package.xml.version.value,
                            .licenses = {},
                            .sha256 = {},
                            .address = package.origin.find("://") == std::string::npos
                                           ? ""
                                           : with_masked_secrets(package.origin),
                            .purl = {},
                            .texts = license_texts(package.directory, false)};
    for (const auto& license : package.xml.licenses) component.licenses.push_back(license.value);
    if (component.texts.empty()) component.texts = license_texts(package.base, false);
    components.push_back(std::move(component));
  }
  return components;
}

void append_models(const std::vector<SourceTree>& trees, std::vector<SiteComponent>& components) {
  for (const SourceTree& tree : trees) {
    if (tree.locked.model.empty()) continue;
    components.push_back({.kind = ComponentKind::kGeneric,
                          .name = tree.locked.model,
                          .version = {},
                          .licenses = {},
                          .sha256 = tree.locked.sha256,
                          .address = tree.locked.archive,
                          .purl = {},
                          .texts = license_texts(tree.folder, false)});
  }
}

}  // namespace ros2wasm
