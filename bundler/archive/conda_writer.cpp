// See conda_writer.hpp. The parts: a tar of the files, a tar of info/, both compressed, in a ZIP of
// stored members.
#include "bundler/archive/conda_writer.hpp"

#include <algorithm>
#include <map>
#include <optional>

#include "bundler/archive/link_json.hpp"
#include "bundler/archive/link_rules.hpp"
#include "bundler/archive/tar_writer.hpp"
#include "bundler/archive/zip_writer.hpp"
#include "bundler/archive/zstd.hpp"
#include "bundler/io/files.hpp"
#include "bundler/io/sha256.hpp"
#include "workspace_schema/base/json_writer.hpp"
#include "workspace_schema/conda/match_spec.hpp"
#include "workspace_schema/conda/record_rules.hpp"

namespace ros2wasm {
namespace {

namespace fs = std::filesystem;

constexpr int kCompressionLevel = 17;  // near the best, and still quick for static libraries
/// For folders of thousands of headers, which level 17 makes a tenth smaller in six times the time.
constexpr int kLevelOfLargeTrees = 12;
constexpr std::size_t kLargeTree = 64U << 20U;  // bytes
constexpr std::uint64_t kLargestPart = 0xFFFFFFFFULL - (1U << 20U);

Diagnostic bad_metadata(const CondaPackage& package, const std::string& why) {
  return Diagnostic{
      .code = "R2W0205",
      .message = "the metadata of package `" + package.name + "` cannot go into a channel",
      .why = {why}};
}

Diagnostic bad_prefix(const fs::path& prefix, const std::string& why) {
  return Diagnostic{
      .code = "R2W0206", .message = "`" + prefix.string() + "` cannot be packed", .why = {why}};
}

std::string link_json(const CondaPackage& package) {
  JsonWriter json;
  json.begin_object().key("noarch").begin_object();
  if (!package.entry_points.empty()) {
    json.key("entry_points").begin_array();
    for (const std::string& one : package.entry_points) json.string(one);
    json.end_array();
  }
  json.field("type", "python").end_object();
  json.field_integer("package_metadata_version", 1).end_object();
  return json.text() + "\n";
}

Diagnostics metadata_faults(const CondaPackage& package) {
  Diagnostics faults;
  const PackageRecord record{.name = package.name,
                             .version = package.version,
                             .build = package.build,
                             .subdir = package.subdir,
                             .file_name = conda_file_name(package)};
  if (const auto fault = record_fault(record, Strictness::kWriting)) {
    faults.push_back(bad_metadata(package, *fault));
  } else if (const auto version = Version::parse(package.version); !version) {
    faults.push_back(bad_metadata(package, version.errors().front().message));
  }
  if ((package.noarch != NoarchKind::kNo) != (package.subdir == "noarch")) {
    faults.push_back(
        bad_metadata(package, "a package is noarch if and only if its subdirectory is"));
  }
  for (const auto* list : {&package.depends, &package.constrains}) {
    for (const std::string& spec : *list) {
      if (const auto parsed = MatchSpec::parse(spec); !parsed) {
        faults.push_back(bad_metadata(package, parsed.errors().front().message));
      }
    }
  }
  if (package.noarch != NoarchKind::kPython && !package.entry_points.empty())
    faults.push_back(bad_metadata(package, "only packages for every Python have entry points"));
  if (const auto read = parse_entry_points(link_json(package), package.name); !read)
    faults.push_back(bad_metadata(package, read.errors().front().why.front()));
  return faults;
}

void field_strings(JsonWriter& json, std::string_view name, std::vector<std::string> values) {
  std::sort(values.begin(), values.end());
  json.key(name).begin_array();
  for (const std::string& value : values) json.string(value);
  json.end_array();
}

// Keys in the order of their names, as conda writes them.
std::string index_json(const CondaPackage& package) {
  const bool any_platform = package.subdir == "noarch";
  const std::size_t dash = package.subdir.find('-');
  JsonWriter json;
  json.begin_object();
  json.key("arch");
  any_platform ? json.null() : json.string(package.subdir.substr(dash + 1));
  json.field("build", package.build);
  json.key("build_number").unsigned_integer(package.build_number);
  field_strings(json, "constrains", package.constrains);
  field_strings(json, "depends", package.depends);
  json.field("license", package.license).field("name", package.name);
  if (package.noarch != NoarchKind::kNo) {
    json.field("noarch", package.noarch == NoarchKind::kPython ? "python" : "generic");
  }
  json.key("platform");
  any_platform ? json.null() : json.string(package.subdir.substr(0, dash));
  json.field("subdir", package.subdir);
  if (package.timestamp_ms != 0) json.field_integer("timestamp", package.timestamp_ms);
  json.field("version", package.version).end_object();
  return json.text() + "\n";
}

std::string about_json(const CondaPackage& package) {
  JsonWriter json;
  json.begin_object();
  if (!package.home.empty()) json.field("home", package.home);
  json.field("license", package.license);
  if (!package.source.empty()) json.field("source_url", package.source);
  json.field("summary", package.summary).end_object();
  return json.text() + "\n";
}

bool looks_like_text(std::string_view bytes) {
  return bytes.find('\0') == std::string_view::npos;
}

/// Collects the files' tar, and the lists that info/ has of them.
class Payload {
 public:
  explicit Payload(const CondaPackage& package) : package_(package) {
    paths_.begin_object().key("paths").begin_array();
  }

  void add_file(const TreeEntry& entry, std::string_view bytes) {
    tar_.file(entry.path, bytes, entry.executable);
    begin(entry.path);
    if (!package_.placeholder.empty() &&
        bytes.find(package_.placeholder) != std::string_view::npos) {
      paths_.field("file_mode", looks_like_text(bytes) ? "text" : "binary");
      paths_.field("path_type", "hardlink").field("prefix_placeholder", package_.placeholder);
    } else {
      paths_.field("path_type", "hardlink");
    }
    end(bytes);
  }

  /// `target_bytes` is the content of the file that the link leads to, if it is one.
  void add_link(const TreeEntry& entry, const std::optional<std::string>& target_bytes) {
    tar_.link(entry.path, entry.link_target);
    begin(entry.path);
    paths_.field("path_type", "softlink");
    if (target_bytes) {
      end(*target_bytes);
    } else {
      paths_.end_object();
    }
  }

  void add_directory(const TreeEntry& entry) {
    tar_.directory(entry.path);
    begin(entry.path);
    paths_.field("path_type", "directory").end_object();
  }

  std::string take_tar() { return tar_.finish(); }
  const std::string& files() const { return files_; }
  std::string take_paths_json() {
    paths_.end_array().field_integer("paths_version", 1).end_object();
    return paths_.text() + "\n";
  }

 private:
  void begin(const std::string& path) {
    files_ += path + "\n";
    paths_.begin_object().field("_path", path);
  }
  void end(std::string_view bytes) {
    paths_.field("sha256", sha256_hex(bytes)).key("size_in_bytes").unsigned_integer(bytes.size());
    paths_.end_object();
  }

  const CondaPackage& package_;
  TarWriter tar_;
  JsonWriter paths_;
  std::string files_;
};

Outcome<Done> add_entries(const fs::path& prefix, const std::vector<TreeEntry>& entries,
                          Payload& payload) {
  for (const TreeEntry& entry : entries) {
    if (entry.path == "info" || entry.path.starts_with("info/")) {
      return bad_prefix(prefix, "`" + entry.path + "`: the folder info/ is the archive's own");
    }
    switch (entry.kind) {
      case FileKind::kFile: {
        const auto bytes = read_file(prefix / entry.path, kMostOfData);
        if (!bytes) return bytes.errors();
        payload.add_file(entry, *bytes);
        break;
      }
      case FileKind::kLink: {
        if (!link_stays_inside(entry.path, entry.link_target)) {
          return bad_prefix(prefix, "the link `" + entry.path + "` leads outside, to `" +
                                        entry.link_target + "`");
        }
        std::error_code error;
        std::optional<std::string> target;
        if (fs::is_regular_file(prefix / entry.path, error)) {
          auto bytes = read_file(prefix / entry.path, kMostOfData);
          if (!bytes) return std::move(bytes).errors();
          target = std::move(bytes).value();
        }
        payload.add_link(entry, target);
        break;
      }
      case FileKind::kDirectory:
        payload.add_directory(entry);
        break;
      case FileKind::kOther:
        return bad_prefix(prefix, "`" + entry.path + "` is neither a file, a link nor a directory");
    }
  }
  return Done{};
}

/// The members of info/, by name.
Outcome<std::map<std::string, std::string>> info_files(const CondaPackage& package,
                                                       Payload& payload) {
  std::map<std::string, std::string> members{{"info/about.json", about_json(package)},
                                             {"info/files", payload.files()},
                                             {"info/index.json", index_json(package)},
                                             {"info/paths.json", payload.take_paths_json()}};
  if (package.noarch == NoarchKind::kPython) {
    members["info/link.json"] = link_json(package);
  }
  for (const fs::path& license : package.license_files) {
    auto bytes = read_file(license, kMostOfData);
    if (!bytes) return std::move(bytes).errors();
    members["info/licenses/" + license.filename().string()] = std::move(bytes).value();
  }
  return members;
}

}  // namespace

std::string conda_file_name(const CondaPackage& package) {
  return package.name + "-" + package.version + "-" + package.build + ".conda";
}

Outcome<std::string> write_conda(const CondaPackage& package, const fs::path& staged_prefix) {
  if (Diagnostics faults = metadata_faults(package); !faults.empty()) return faults;
  const auto entries = list_tree(staged_prefix);
  if (!entries) return entries.errors();
  Payload payload(package);
  if (auto added = add_entries(staged_prefix, *entries, payload); !added)
    return std::move(added).errors();
  const auto info = info_files(package, payload);
  if (!info) return info.errors();

  TarWriter info_tar;
  for (const auto& [name, bytes] : *info) info_tar.file(name, bytes);
  const std::string stem = package.name + "-" + package.version + "-" + package.build;
  const std::string tar = payload.take_tar();
  const std::string files_part =
      zstd_compressed(tar, tar.size() > kLargeTree ? kLevelOfLargeTrees : kCompressionLevel);
  const std::string info_part = zstd_compressed(info_tar.finish(), kCompressionLevel);
  if (files_part.size() + info_part.size() > kLargestPart) {
    return bad_prefix(staged_prefix, "the archive would be larger than 4 GiB");
  }
  ZipWriter zip;
  zip.member("metadata.json", "{\"conda_pkg_format_version\":2}");
  zip.member("pkg-" + stem + ".tar.zst", files_part);
  zip.member("info-" + stem + ".tar.zst", info_part);
  return zip.finish();
}

}  // namespace ros2wasm
