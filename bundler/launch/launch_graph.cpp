// See launch_graph.hpp.
#include "bundler/launch/launch_graph.hpp"

#include <algorithm>

#include "bundler/launch/node_arguments.hpp"
#include "bundler/launch/parameter_file.hpp"
#include "workspace_schema/base/diagnostic_list.hpp"
#include "workspace_schema/base/suggestion.hpp"

namespace ros2wasm {
namespace {

const InstalledPackage* find_package(const std::vector<InstalledPackage>& installed,
                                     const std::string& name) {
  const auto found = std::find_if(installed.begin(), installed.end(),
                                  [&](const InstalledPackage& one) { return one.name == name; });
  return found == installed.end() ? nullptr : &*found;
}

/// The error of a node whose package is skipped, if it is.
std::optional<Diagnostic> left_out_package(const NodeEntry& entry, const LeftOutChains& left_out) {
  const auto chain = left_out.find(entry.package.value);
  if (chain == left_out.end()) return std::nullopt;
  const auto& causes = chain->second;
  return Diagnostic{.code = "R2W0401",
                    .message = "package `" + entry.package.value + "` is skipped: " + causes.back(),
                    .span = entry.package.span,
                    .label = "this node needs it",
                    .why = causes.size() == 1 ? std::vector<std::string>() : causes};
}

Diagnostic no_such_package(const NodeEntry& entry) {
  return Diagnostic{.code = "R2W0401",
                    .message = "there is no package `" + entry.package.value + "`",
                    .span = entry.package.span,
                    .label = "neither in the workspace nor in its channels' packages"};
}

Diagnostic no_such_package(const NodeEntry& entry, const std::vector<InstalledPackage>& installed) {
  std::vector<std::string> with_programs;
  for (const InstalledPackage& package : installed) {
    if (!package.programs.empty()) with_programs.push_back(package.name);
  }
  Diagnostic result = no_such_package(entry);
  result.why.push_back(with_programs.empty()
                           ? "no package here has executables"
                           : "packages with executables are: " + name_list(with_programs));
  if (const auto similar = nearest(entry.package.value, with_programs)) {
    result.fix.push_back("write `package: " + *similar + "`");
  }
  return result;
}

Diagnostic no_such_executable(const NodeEntry& entry, const InstalledPackage& package) {
  std::vector<std::string> names;
  for (const InstalledProgram& program : package.programs) names.push_back(program.executable);
  const std::string version = package.version.empty() ? "" : " " + package.version;
  Diagnostic result{.code = "R2W0402",
                    .message = "package `" + package.name + "` has no executable `" +
                               entry.executable.value + "`",
                    .span = entry.executable.span,
                    .label = "no such executable in " + package.name + version};
  result.why.push_back(names.empty() ? "it installs nothing into lib/" + package.name
                                     : "its executables are: " + name_list(names));
  const auto& elsewhere = package.in_bin;
  if (std::find(elsewhere.begin(), elsewhere.end(), entry.executable.value) != elsewhere.end()) {
    result.why.push_back("it installs `" + entry.executable.value +
                         "` into bin/, where `ros2 run` and launch files do not look");
    result.fix.push_back("in a Python package, write `[install]` and `install_scripts=$base/lib/" +
                         package.name +
                         "` into setup.cfg; in CMake, write `DESTINATION lib/${PROJECT_NAME}`");
  } else if (const auto similar = nearest(entry.executable.value, names)) {
    result.fix.push_back("write `executable: " + *similar + "`");
  }
  return result;
}

Diagnostic not_a_program(const NodeEntry& entry, const InstalledProgram& program) {
  const std::string place = "lib/" + program.package + "/" + program.file.filename().string();
  const std::string why =
      program.may_not_be_run
          ? place + " is not executable, so `ros2 run` and launch files do not find it"
      : program.left_out.empty()
          ? place + " is neither a WebAssembly program nor a Python script"
          : "it was skipped: it needs " + program.left_out + ", which no site has";
  return Diagnostic{
      .code = "R2W0405",
      .message = "`" + program.executable + "` of package `" + program.package +
                 "` is not a program that a site can run",
      .span = entry.executable.span,
      .why = {why},
      .fix = program.may_not_be_run
                 ? std::vector<std::string>{"in CMakeLists.txt: install(PROGRAMS ...), "
                                            "which sets the mode"}
                 : std::vector<std::string>()};
}

/// Errors for the other packages whose components a container needs: each must have a container
/// program itself.
Diagnostics other_containers(const NodeEntry& entry, const std::vector<InstalledPackage>& installed,
                             const ParameterFiles& parameter_files, const LeftOutChains& left_out) {
  std::vector<NodeEntry> others;
  for (const auto& package : entry.linked_with) {
    NodeEntry other = entry;
    other.package = package;
    other.linked_with.clear();
    others.push_back(std::move(other));
  }
  auto nodes = launch_nodes(others, installed, parameter_files, left_out);
  return nodes ? Diagnostics() : std::move(nodes).errors();
}

}  // namespace

std::string program_name(const NodeEntry& entry) {
  std::string name = entry.executable.value;
  for (const auto& package : entry.linked_with) name += "-" + package.value;
  return name;
}

std::string python_script(const LaunchNode& node) {
  return "lib/" + node.package + "/" + node.program.filename().string();
}

Diagnostics missing_packages(const std::vector<NodeEntry>& entries,
                             const std::vector<std::string>& packages,
                             const LeftOutChains& left_out) {
  Diagnostics errors;
  for (const NodeEntry& entry : entries) {
    if (std::find(packages.begin(), packages.end(), entry.package.value) != packages.end())
      continue;
    if (auto error = left_out_package(entry, left_out)) {
      errors.push_back(std::move(*error));
      continue;
    }
    Diagnostic error = no_such_package(entry);
    if (const auto similar = nearest(entry.package.value, packages))
      error.why.push_back("there is `" + *similar + "`");
    errors.push_back(std::move(error));
  }
  return errors;
}

Outcome<std::vector<FileRules>> file_rules(const NodeEntry& entry,
                                           const ParameterFiles& parameter_files) {
  std::vector<FileRules> rules;
  Diagnostics errors;
  for (const Spanned<std::string>& file : entry.parameter_files) {
    const auto text = parameter_files.find(file.value);
    auto read = read_parameter_file(text == parameter_files.end() ? "" : text->second, file.value);
    if (read) {
      rules.push_back(std::move(read).value());
    } else {
      errors.insert(errors.end(), read.errors().begin(), read.errors().end());
    }
  }
  if (!errors.empty()) return errors;
  return rules;
}

Outcome<std::vector<LaunchNode>> launch_nodes(const std::vector<NodeEntry>& entries,
                                              const std::vector<InstalledPackage>& installed,
                                              const ParameterFiles& parameter_files,
                                              const LeftOutChains& left_out) {
  Diagnostics errors;
  std::vector<LaunchNode> nodes;
  for (const NodeEntry& entry : entries) {
    std::string id = entry.executable.value + "-" + std::to_string(nodes.size() + 1);
    if (entry.is_command) {
      nodes.push_back({.id = std::move(id),
                       .package = {},
                       .executable = entry.executable.value,
                       .label = node_label(entry),
                       .program = {},
                       .kind = ProgramKind::kCommand,
                       .compiled_modules = {},
                       .arguments = entry.arguments,
                       .output = entry.output,
                       .respawn = entry.respawn,
                       .source = entry.span});
      continue;
    }
    const InstalledPackage* package = find_package(installed, entry.package.value);
    if (package == nullptr) {
      auto error = left_out_package(entry, left_out);
      errors.push_back(error ? std::move(*error) : no_such_package(entry, installed));
      continue;
    }
    const auto program = std::find_if(
        package->programs.begin(), package->programs.end(),
        [&](const InstalledProgram& one) { return one.executable == entry.executable.value; });
    if (program == package->programs.end()) {
      errors.push_back(no_such_executable(entry, *package));
      continue;
    }
    if (program->kind == ProgramKind::kNone) {
      errors.push_back(not_a_program(entry, *program));
      continue;
    }
    if (Diagnostics more = other_containers(entry, installed, parameter_files, left_out);
        !more.empty()) {
      append(errors, more);
      continue;
    }
    std::vector<std::string> linked_with;
    for (const auto& other : entry.linked_with) linked_with.push_back(other.value);
    const auto files = file_rules(entry, parameter_files);
    if (!files) {
      errors.insert(errors.end(), files.errors().begin(), files.errors().end());
      continue;
    }
    nodes.push_back({.id = std::move(id),
                     .package = entry.package.value,
                     .executable = entry.executable.value,
                     .linked_with = std::move(linked_with),
                     .label = node_label(entry),
                     .program = entry.linked_with.empty()
                                    ? program->file
                                    : program->file.parent_path() / (program_name(entry) + ".wasm"),
                     .kind = program->kind,
                     .compiled_modules = {},
                     .arguments = node_arguments(entry, *files),
                     .output = entry.output,
                     .respawn = entry.respawn,
                     .source = entry.executable.span});
  }
  if (!errors.empty()) return errors;
  return nodes;
}

}  // namespace ros2wasm
