// See manifest_init.hpp.
#include "bundler/workspace/manifest_init.hpp"

#include <algorithm>

#include "bundler/io/files.hpp"
#include "bundler/resolve/locked_solve.hpp"
#include "bundler/resolve/solve.hpp"
#include "bundler/workspace/bringup_file.hpp"
#include "bundler/workspace/default_manifest.hpp"
#include "bundler/workspace/discovery.hpp"
#include "bundler/workspace/foreign_environment.hpp"
#include "bundler/workspace/manifest_draft.hpp"
#include "workspace_schema/base/replaced_text.hpp"
#include "workspace_schema/base/suggestion.hpp"
#include "workspace_schema/schema/lock.hpp"
#include "workspace_schema/schema/manifest_reader.hpp"

namespace ros2wasm {
namespace fs = std::filesystem;
namespace {

struct NewFile {
  fs::path path;
  std::string bytes;
};

Outcome<std::vector<fs::path>> write_new(const std::vector<NewFile>& files) {
  std::error_code error;
  std::vector<std::string> existing;
  for (const NewFile& file : files) {
    if (fs::exists(fs::symlink_status(file.path, error))) existing.push_back(file.path.string());
  }
  if (!existing.empty()) {
    Diagnostic refusal{.code = "R2W0630",
                       .message = "`" + existing.front() + "` exists already",
                       .why = {"`ros2wasm init` writes over nothing; nothing was written"}};
    existing.erase(existing.begin());
    if (!existing.empty()) refusal.why.push_back("so do " + name_list(existing));
    return refusal;
  }
  std::vector<fs::path> written;
  for (const NewFile& file : files) {
    if (auto done = write_file(file.path, file.bytes); !done) return std::move(done).errors();
    written.push_back(file.path);
  }
  return written;
}

std::string relative_text(const fs::path& path, const fs::path& base) {
  return path.lexically_relative(base).generic_string();
}

DraftPackage draft_package(const LocalPackage& package, const fs::path& base) {
  DraftPackage draft{
      .name = package.xml.name.value,
      .version = package.xml.version.value,
      .license = package.xml.licenses.empty() ? std::string() : package.xml.licenses.front().value,
      .build_type = package.xml.build_type,
      .folder = relative_text(package.directory, base),
      .programs = {}};
  const auto text_of = [&](const char* file) {
    const auto text = read_file(package.directory / file, kMostOfText);
    return text ? *text : std::string();
  };
  draft.programs = draft.build_type == "ament_python"
                       ? console_script_names(text_of("setup.py"), text_of("setup.cfg"))
                       : installed_program_names(text_of("CMakeLists.txt"));
  return draft;
}

std::vector<std::string> launch_files(const std::vector<LocalPackage>& packages,
                                      const fs::path& base) {
  std::vector<std::string> found;
  for (const LocalPackage& package : packages)
    for (const fs::path& file : package.launch_files) found.push_back(relative_text(file, base));
  return found;
}

std::vector<std::string> draft_remarks(const DraftInput& input) {
  std::vector<std::string> names;
  std::size_t nodes = 0;
  for (const DraftPackage& package : input.packages) {
    names.push_back(package.name);
    nodes += package.programs.size();
  }
  std::vector<std::string> remarks = {std::to_string(names.size()) +
                                      (names.size() == 1 ? " package: " : " packages: ") +
                                      name_list(names, 12)};
  const BringupChoice choice = bringup_file(input.launch_files);
  if (!choice.file.empty()) {
    remarks.push_back("`launch:` starts " + choice.file);
  } else {
    remarks.push_back(std::to_string(nodes) + (nodes == 1 ? " node" : " nodes") +
                      " under `launch:`, one for each program");
  }
  if (!choice.candidates.empty())
    remarks.push_back("other launch files, for `launch:`: " + name_list(choice.candidates, 12));
  return remarks;
}

/// `talker_listener` -> `Talker listener`.
std::string title_of(std::string name) {
  std::replace(name.begin(), name.end(), '_', ' ');
  if (name[0] >= 'a' && name[0] <= 'z') name[0] = static_cast<char>(name[0] - 'a' + 'A');
  return name;
}

}  // namespace

Outcome<InitReport> init_from_workspace(const fs::path& workspace, const fs::path& output) {
  std::error_code error;
  const fs::path folder = fs::canonical(workspace, error);
  Diagnostic no_package{.code = "R2W0631",
                        .message = "`" + workspace.string() + "` has no ROS 2 package"};
  if (error || !fs::is_directory(folder, error)) {
    no_package.why.push_back(error ? "there is no such folder" : "it is not a folder");
    return no_package;
  }
  if (find_package_folders(folder).empty()) {
    no_package.why.push_back("no folder in it has a package.xml");
    no_package.fix.push_back("ros2wasm init cpp my_workspace");
    return no_package;
  }
  const Manifest made = default_manifest(folder);
  const auto packages =
      discover_packages(folder, folder, made.packages, ros_condition_variables(made.distro));
  if (!packages) return packages.errors();
  const auto place = real_path(output);
  if (!place) return place.errors();
  const fs::path base = place->parent_path();
  std::vector<std::string> launches = launch_files(*packages, base);
  DraftInput input{.name = made.name.value,
                   .title = made.title,
                   .packages = {},
                   .launch_files = std::move(launches)};
  for (const LocalPackage& package : *packages)
    input.packages.push_back(draft_package(package, base));
  const bool runs = std::any_of(input.packages.begin(), input.packages.end(),
                                [](const DraftPackage& each) { return !each.programs.empty(); });
  if (!runs && bringup_file(input.launch_files).file.empty()) {
    return Diagnostic{
        .code = "R2W0632",
        .message = "no program to run is seen in the packages of `" + workspace.string() + "`",
        .why = {"a program is made by `add_executable` in a CMakeLists.txt and installed to lib/"},
        .fix = {"ros2wasm pack " + workspace.string()}};
  }
  const std::string text = draft_manifest(input);
  if (auto read = read_manifest(text, output.string()); !read) return std::move(read).errors();
  auto written = write_new({{.path = output, .bytes = text}});
  if (!written) return std::move(written).errors();
  return InitReport{.written = std::move(*written), .remarks = draft_remarks(input)};
}

Outcome<InitReport> init_from_environment(const fs::path& file, const fs::path& output,
                                          const std::string& environment) {
  const auto text = read_file(file, kMostOfText);
  if (!text) return text.errors();
  const auto read = read_foreign_environment(*text, file.string(), environment);
  if (!read) return read.errors();
  const fs::path manifest_file = output.empty() ? file.parent_path() / "workspace.yaml" : output;
  const auto place = real_path(manifest_file);
  if (!place) return place.errors();
  const fs::path base = place->parent_path();
  const Manifest made = default_manifest(base);
  DraftInput input{
      .name = made.name.value, .title = made.title, .packages = {}, .launch_files = {}};
  if (!find_package_folders(base).empty()) {
    const auto packages =
        discover_packages(base, base, made.packages, ros_condition_variables(made.distro));
    if (!packages) return packages.errors();
    for (const LocalPackage& package : *packages)
      input.packages.push_back(draft_package(package, base));
  }
  input.channels = {"embedded"};
  input.channels.insert(input.channels.end(), read->channels.begin(), read->channels.end());
  input.dependencies = read->specs;
  const std::string manifest = draft_manifest(input);
  if (auto again = read_manifest(manifest, manifest_file.string()); !again)
    return std::move(again).errors();
  std::vector<NewFile> files{{.path = manifest_file, .bytes = manifest}};
  if (!read->packages.empty()) {
    std::vector<RequestedSpec> asked;
    for (const std::string& spec : read->specs)
      asked.push_back({.text = spec, .origin = {}, .span = {}});
    if (Diagnostics faults = check_solution(asked, read->packages); !faults.empty()) return faults;
    files.push_back(
        {.path = manifest_file.parent_path() / kLockFileName,
         .bytes = write_lock(
             {.channels = input.channels, .specs = read->specs, .packages = read->packages})});
  }
  auto written = write_new(files);
  if (!written) return std::move(written).errors();
  InitReport report{.written = std::move(*written), .remarks = {}};
  report.remarks.push_back("from the " + read->format + ": " + std::to_string(read->specs.size()) +
                           " dependencies, " + std::to_string(read->channels.size()) + " channels");
  if (!read->packages.empty())
    report.remarks.push_back("its lock has " + std::to_string(read->packages.size()) + " packages");
  if (!read->left_out.empty()) report.remarks.push_back("skipped: " + name_list(read->left_out));
  return report;
}

Outcome<InitReport> init_from_template(const fs::path& template_folder, const fs::path& target) {
  const auto tree = list_tree(template_folder);
  if (!tree) return tree.errors();
  const auto place = absolute_path(target);
  if (!place) return place.errors();
  const fs::path folder = (*place / "").lexically_normal().parent_path();
  const std::string name = default_manifest(folder).name.value;
  std::vector<NewFile> files;
  for (const TreeEntry& entry : *tree) {
    auto text = read_file(template_folder / entry.path, kMostOfText);
    if (!text) return std::move(text).errors();
    const std::string named = with_replaced(*text, "@NAME@", name);
    const fs::path path = entry.path;
    const bool hidden = path.filename() == "gitignore";  // under its real name it would act here
    files.push_back({.path = target / (hidden ? path.parent_path() / ".gitignore" : path),
                     .bytes = with_replaced(named, "@TITLE@", title_of(name))});
  }
  auto written = write_new(files);
  if (!written) return std::move(written).errors();
  return InitReport{.written = std::move(*written), .remarks = {}};
}

Outcome<InitReport> init_workflow(const fs::path& template_file, const fs::path& folder,
                                  const fs::path& target) {
  const auto text = read_file(template_file, kMostOfText);
  if (!text) return text.errors();
  InitReport report;
  const fs::path file = (folder / "workspace.yaml").lexically_normal();
  if (is_absent(file)) {
    report.remarks.push_back("there is no " + file.string() +
                             ": change WORKSPACE in the workflow to where the manifest is");
  } else {
    const auto manifest_text = read_file(file, kMostOfText);
    if (!manifest_text) return manifest_text.errors();
    const auto manifest = read_manifest(*manifest_text, file.string());
    if (!manifest) return manifest.errors();
    if (manifest->checks.empty())
      report.remarks.push_back(file.string() + " has no `checks:`, which the workflow plays");
    if (is_absent(folder / kLockFileName))
      report.remarks.push_back("write " + std::string(kLockFileName) +
                               " with `ros2wasm lock` and commit it");
  }
  auto written = write_new({{.path = (folder / target).lexically_normal(), .bytes = *text}});
  if (!written) return std::move(written).errors();
  report.written = std::move(*written);
  return report;
}

}  // namespace ros2wasm
