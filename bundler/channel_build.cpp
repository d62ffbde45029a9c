// See channel_build.hpp.
#include "bundler/channel_build.hpp"

#include <algorithm>
#include <charconv>
#include <map>
#include <optional>

#include "bundler/archive/conda_writer.hpp"
#include "bundler/build/compiler_parts.hpp"
#include "bundler/build/movable_tree.hpp"
#include "bundler/channel/channel_writer.hpp"
#include "bundler/io/files.hpp"
#include "bundler/io/sha256.hpp"
#include "bundler/pipeline.hpp"
#include "bundler/site_components.hpp"
#include "bundler/workspace/channel_record.hpp"
#include "workspace_schema/base/json_reader.hpp"
#include "workspace_schema/base/json_writer.hpp"
#include "workspace_schema/conda/record_rules.hpp"

namespace ros2wasm {
namespace fs = std::filesystem;
namespace {

/// Part of every key: raise it when archives of the same packages are written differently.
constexpr std::string_view kFormat = "1";

/// An archive that an earlier run has written, and all that it was made from.
struct KnownBuild {
  std::string key;
  std::string archive;  ///< `<subdir>/<file>`
};
using KnownBuilds = std::map<std::string, KnownBuild>;  ///< by the package's name

/// In the cache, not in the channel, which is published.
Outcome<fs::path> notes_of(const fs::path& channel, const fs::path& cache) {
  const auto real = real_path(channel);
  if (!real) return real.errors();
  return cache / "channels" / (sha256_hex(real->string()).substr(0, 16) + ".json");
}

/// Notes that cannot be read only cost time.
KnownBuilds read_notes(const fs::path& file) {
  KnownBuilds builds;
  const auto text = read_file(file, kMostOfList);
  if (!text) return builds;
  const auto json = parse_json(*text, file.string(), "R2W0210");
  if (!json) return builds;
  for (const auto& [name, value] : json->members())
    builds[name] = {value.text_of("key"), value.text_of("archive")};
  return builds;
}

Outcome<Done> write_notes(const fs::path& file, const KnownBuilds& builds) {
  JsonWriter json;
  json.begin_object();
  for (const auto& [name, build] : builds)
    json.key(name)
        .begin_object()
        .field("archive", build.archive)
        .field("key", build.key)
        .end_object();
  json.end_object();
  return write_file(file, json.text() + "\n");
}

std::string key_of(const BuiltPackage& built, const CondaPackage& record) {
  std::string text = std::string(kFormat) + "\n" + built.hash + "\n" + record.name + "\n" +
                     record.version + "\n" + record.license + "\n" + record.summary + "\n" +
                     record.source + "\n";
  for (const std::string& spec : record.depends) text += spec + "\n";
  // They may be those of the repository, which the hash of the build does not see.
  for (const fs::path& file : record.license_files) {
    const auto license = read_file(file, kMostOfText);
    text += license ? sha256_hex(*license) + "\n" : "\n";
  }
  return sha256_hex(text);
}

/// The highest build number of the archives of a version in a folder of the channel. A solver
/// compares them over all folders.
std::optional<std::uint64_t> highest_build(const fs::path& folder, const CondaPackage& package) {
  std::optional<std::uint64_t> highest;
  const std::string begin = package.name + "-" + package.version + "-";
  std::error_code error;
  for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
    const std::string file = it->path().filename().string();
    const std::string_view stem = archive_stem(file);
    if (!stem.starts_with(begin)) continue;
    const std::string_view digits = stem.substr(stem.rfind('_') + 1);
    std::uint64_t number = 0;
    const auto read = std::from_chars(digits.data(), digits.data() + digits.size(), number);
    if (read.ec != std::errc() || read.ptr != digits.data() + digits.size()) number = 0;
    highest = std::max(highest.value_or(0), number);
  }
  return highest;
}

Diagnostic names_this_machine(const std::string& package, const std::vector<std::string>& files) {
  return Diagnostic{
      .code = "R2W0533",
      .severity = Severity::kWarning,
      .message = "package `" + package + "` of the channel names folders of this machine",
      .why = {"`" + files.front() + "` has them" +
                  (files.size() > 1 ? ", and " + std::to_string(files.size() - 1) + " other files"
                                    : "") +
                  ": it is compiled, so that nothing is replaced in it, or it leads to the sources",
              "another machine would make other bytes, and the program finds nothing there"},
      .fix = {}};
}

class ChannelBuilder {
 public:
  ChannelBuilder(const ChannelBuildRequest& request, BuiltWorkspace workspace)
      : request_(request), workspace_(std::move(workspace)) {
    for (const LocalPackage& one : workspace_.built.sources) {
      if (built_of(one)) built_packages_.push_back(one);
    }
    abi_ = {.compiler_version = workspace_.built.tools.compiler.version,
            .compiler_build = {},
            .client_build = workspace_.supplies.client_abi};
  }

  Outcome<ChannelBuildReport> run(const EnvironmentVariables& variables,
                                  const Cancellation& cancellation, const ProgressSink& progress) {
    const auto notes = notes_of(request_.channel, workspace_.supplies.roots.cache);
    if (!notes) return notes.errors();
    known_ = read_notes(*notes);
    abi_.compiler_build =
        abi_build(find_compiler_parts(workspace_.built.tools.compiler.home, variables),
                  workspace_.supplies.roots.cache);
    begin_step(progress, "pack");
    for (const LocalPackage& one : workspace_.built.sources) {
      if (cancellation.requested()) return interrupted();
      report_.packages.push_back(result_of(one));
      const Diagnostics& errors = report_.packages.back().errors;
      // A full disk is not a fault of one package.
      if (std::any_of(errors.begin(), errors.end(), [](const Diagnostic& error) {
            return error.kind == FailureKind::kEnvironment;
          }))
        return errors;
      // So that a run that is interrupted goes on where it was.
      if (!is_noted_) {
        if (auto written = write_notes(*notes, known_); !written)
          return std::move(written).errors();
        is_noted_ = true;
      }
    }
    add_missing_names();
    std::sort(report_.packages.begin(), report_.packages.end(),
              [](const ChannelPackage& a, const ChannelPackage& b) { return a.name < b.name; });
    const auto indexed = index_channel(request_.channel);
    if (!indexed) return indexed.errors();
    report_.warnings.insert(report_.warnings.begin(), workspace_.notes.warnings.begin(),
                            workspace_.notes.warnings.end());
    report_.remarks = std::move(workspace_.notes.remarks);
    report_.remarks.push_back("the channel has " + std::to_string(indexed->packages) + " packages");
    return std::move(report_);
  }

 private:
  [[nodiscard]] const BuiltPackage* built_of(const LocalPackage& package) const {
    const auto found =
        std::find_if(workspace_.built.packages.begin(), workspace_.built.packages.end(),
                     [&](const BuiltPackage& one) { return one.name == package.xml.name.value; });
    return found == workspace_.built.packages.end() ? nullptr : &*found;
  }

  [[nodiscard]] ChannelPackage result_of(const LocalPackage& package) {
    const std::string& name = package.xml.name.value;
    ChannelPackage result{.name = name,
                          .version = package.xml.version.value,
                          .origin = package.origin,
                          .archive = {}};
    const BuiltPackage* built = built_of(package);
    if (built == nullptr) {
      const auto failed =
          std::find_if(workspace_.built.failed.begin(), workspace_.built.failed.end(),
                       [&](const FailedPackage& one) { return one.name == name; });
      if (failed != workspace_.built.failed.end()) {
        result.state = ChannelPackageState::kFailed;
        result.errors = failed->errors;
      } else {
        result.state = ChannelPackageState::kSkipped;
        if (const auto chain = workspace_.built.left_out.find(name);
            chain != workspace_.built.left_out.end())
          result.reason = chain->second;
      }
      return result;
    }
    auto added = add(package, *built);
    if (!added) {
      result.state = ChannelPackageState::kFailed;
      result.errors = std::move(added).errors();
      return result;
    }
    result.archive = known_[name].archive;
    result.state = *added ? ChannelPackageState::kAdded : ChannelPackageState::kUnchanged;
    return result;
  }

  /// False when the channel has that very archive.
  Outcome<bool> add(const LocalPackage& package, const BuiltPackage& built) {
    const KnownNames names{
        .names = workspace_.supplies.channel_names, .of_lock = false, .absent = {}};
    const auto record = [&](bool is_compiled) {
      CondaPackage made = channel_record(package, built_packages_, names,
                                         workspace_.read.manifest.distro, is_compiled, abi_);
      made.license_files = license_files(package.directory);
      if (made.license_files.empty()) made.license_files = license_files(package.base);
      return made;
    };
    // By the record of a compiled package, which has all that the other has.
    const std::string key = key_of(built, record(true));
    const auto known = known_.find(built.name);
    if (known != known_.end() && known->second.key == key &&
        !is_absent(request_.channel / known->second.archive))
      return false;

    const auto staging = TemporaryDirectory::make("ros2wasm-channel-");
    if (!staging) return staging.errors();
    BuildPlaces places{
        .prefixes = {workspace_.fetched.prefix},
        .others = {package.directory, package.base, workspace_.built.settings.cache / "work"}};
    for (const BuiltPackage& one : workspace_.built.packages) places.prefixes.push_back(one.prefix);
    const auto tree = make_movable(built.prefix, built.name, places, staging->path());
    if (!tree) return tree.errors();
    if (!tree->fixed.empty())
      report_.warnings.push_back(names_this_machine(built.name, tree->fixed));

    CondaPackage made = record(tree->is_compiled);
    made.placeholder = kMovablePrefix;
    const auto highest = std::max(highest_build(request_.channel / "noarch", made),
                                  highest_build(request_.channel / "emscripten-wasm32", made));
    made.build_number = highest.value_or(0);
    auto written = write(made, *tree, staging->path(), highest.has_value());
    if (written && !*written) {
      made.build_number += 1;
      written = write(made, *tree, staging->path(), false);
    }
    if (!written) return std::move(written).errors();
    known_[built.name] = {key, made.subdir + "/" + conda_file_name(made)};
    is_noted_ = false;
    return **written;
  }

  /// Whether an archive was written; nothing when the build number is taken by another archive.
  Outcome<std::optional<bool>> write(CondaPackage& package, const MovableTree& tree,
                                     const fs::path& staged, bool is_taken) {
    package.build = channel_build_string(package, abi_, tree.hash);
    const auto bytes = write_conda(package, staged);
    if (!bytes) return bytes.errors();
    const fs::path file = request_.channel / package.subdir / conda_file_name(package);
    if (is_taken) {
      const auto there = read_file(file, kMostOfData);
      return there && *there == *bytes ? std::optional<bool>(false) : std::nullopt;
    }
    if (auto done = write_file(file, *bytes); !done) return std::move(done).errors();
    return std::optional<bool>(true);
  }

  /// Names that were asked for and that no source brought.
  void add_missing_names() {
    for (const std::string& name : request_.names) {
      const auto there =
          std::find_if(report_.packages.begin(), report_.packages.end(),
                       [&name](const ChannelPackage& one) { return one.name == name; });
      if (there != report_.packages.end()) {
        if (there->state != ChannelPackageState::kSkipped) continue;
        there->state = ChannelPackageState::kFailed;
        there->errors = {
            Diagnostic{.code = "R2W0519",
                       .message = "the package `" + name + "` was asked for, and is skipped",
                       .why = there->reason}};
        continue;
      }
      const std::string conda = conda_name(name, workspace_.read.manifest.distro);
      const auto& names = workspace_.supplies.channel_names;
      const bool is_ready = std::binary_search(names.begin(), names.end(), conda);
      report_.packages.push_back(
          {.name = name,
           .version = {},
           .origin = {},
           .archive = {},
           .state = is_ready ? ChannelPackageState::kSkipped : ChannelPackageState::kFailed,
           .errors = {},
           .reason = {}});
      if (is_ready) {
        report_.packages.back().reason = {"a channel of the workspace has it: `" + conda + "`"};
      } else {
        report_.packages.back().errors = {
            Diagnostic{.code = "R2W0513",
                       .message = "no source and no distribution has the package `" + name + "`"}};
      }
    }
  }

  const ChannelBuildRequest& request_;
  BuiltWorkspace workspace_;
  std::vector<LocalPackage> built_packages_;
  ChannelAbi abi_;
  KnownBuilds known_;
  bool is_noted_ = true;  ///< known_ is on the disk
  ChannelBuildReport report_;
};

}  // namespace

Outcome<ChannelBuildReport> build_channel(const ChannelBuildRequest& request,
                                          const Cancellation& cancellation,
                                          const ProgressSink& progress) {
  if (auto made = make_directories(request.channel); !made) return std::move(made).errors();
  PackRequest pack = request.pack;
  pack.for_channel = true;
  auto workspace = build(pack, cancellation, progress);
  if (!workspace) return std::move(workspace).errors();
  return ChannelBuilder(request, *std::move(workspace))
      .run(request.pack.variables, cancellation, progress);
}

}  // namespace ros2wasm
