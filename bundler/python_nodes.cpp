// See python_nodes.hpp.
#include "bundler/python_nodes.hpp"

#include <algorithm>
#include <array>
#include <set>
#include <tuple>

#include "bundler/io/files.hpp"
#include "bundler/io/installation.hpp"
#include "bundler/launch/host/import_check.hpp"
#include "bundler/launch/host/python_syntax.hpp"
#include "bundler/launch_tools.hpp"
#include "bundler/python_libraries_of_site.hpp"
#include "bundler/run/node_js.hpp"
#include "bundler/store/build_place.hpp"
#include "bundler/store/cache_place.hpp"
#include "bundler/workspace/discovery.hpp"
#include "bundler/workspace/python_imports.hpp"
#include "bundler/workspace/python_sources.hpp"

namespace ros2wasm {
namespace fs = std::filesystem;
namespace {

constexpr std::string_view kCellFolder = "cells of the notebook/";
/// Modules that the kernel of a notebook provides itself, so that no package has to
/// (runtime/packages/client/rclpy/ros2wasm/notebook.py).
constexpr std::array<std::string_view, 2> kKernelModules = {"IPython/__init__.py",
                                                            "IPython/display.py"};

/// The file of the workspace that was installed as `path`, as people name it; else `path` itself.
std::string source_of(const BuiltWorkspace& workspace, const PythonInput& python,
                      const std::string& path) {
  const auto found = python.sources.find(path);
  if (found == python.sources.end()) return path;
  const fs::path file = (workspace.read.folder / found->second).lexically_normal();
  return shown_path(file, workspace.read.folder, workspace.read.shown_folder);
}

std::string installed(const std::string& path) {
  return std::string(kPythonModules) + "/" + path;
}

/// "parts-1.2-py3-none-any.whl/parts/arm.py".
std::string place_in_wheel(const std::vector<NamedWheel>& wheels, const std::string& path) {
  for (const NamedWheel& one : wheels) {
    for (const auto& [file, bytes] : one.wheel.files) {
      if (installed(file) == path) return one.file_name + "/" + file;
    }
  }
  return path;
}

Outcome<PythonInput> read_python(const BuiltWorkspace& workspace, PackNotes& notes) {
  PythonInput input;
  std::vector<Outcome<LeftOut>> parts;
  const fs::path& environment = workspace.fetched.prefix;
  parts.push_back(collect_python_modules(environment, input.channels));
  for (const InstalledPackage& package : workspace.built.installed) {
    const bool is_local = package.prefix != environment;
    PythonFiles& part = is_local ? input.workspace : input.channels;
    if (is_local) parts.push_back(collect_python_modules(package.prefix, part));
    parts.push_back(collect_python_scripts(package.prefix, package.name, part));
  }
  for (const auto& part : parts) {
    if (!part) return part.errors();
    for (const std::string& one : *part) notes.remarks.push_back("skipped " + one);
  }
  for (const NamedWheel& one : workspace.supplies.wheels) {
    if (!one.wheel.side_modules.empty()) continue;  // see add_libraries()
    for (const auto& [file, bytes] : one.wheel.files) input.wheels.emplace(installed(file), bytes);
  }
  input.sources = python_sources(input.workspace, notes.watched, workspace.read.folder);
  const fs::path pyodide = environment / kPyodideFolder;
  std::error_code error;
  if (!fs::is_directory(pyodide, error)) return no_pyodide("nodes of the site are Python programs");
  for (const char* name : {"pyodide.asm.js", "pyodide.asm.wasm", "pyodide-lock.json", "pyodide.js",
                           "python_stdlib.zip"}) {
    auto bytes = read_file(pyodide / name, kMostOfData);
    if (!bytes) return std::move(bytes).errors();
    input.pyodide.emplace(name, std::move(bytes).value());
  }
  return input;
}

bool is_python(const std::string& path, const std::string& text) {
  return path.ends_with(".py") || is_python_script(text);
}

/// Files of the workspace that are not valid Python.
struct InvalidFiles {
  std::map<std::string, Diagnostic> by_path;  ///< R2W0528, by installed path
  std::set<std::string> reached;              ///< those that a node imports
};

Outcome<InvalidFiles> invalid_files(const PackRequest& request, const BuiltWorkspace& workspace,
                                    const PythonInput& python, const Cancellation& cancellation) {
  std::vector<std::string> paths;
  std::vector<std::string> texts;
  for (const auto& [path, text] : python.workspace) {
    if (!is_python(path, text)) continue;
    paths.push_back(path);
    texts.push_back(text);
  }
  const auto cache = cache_directory(request.variables);
  if (!cache) return cache.errors();
  const auto mistakes = python_mistakes(
      texts, kept_python_place(*cache),
      [&] {
        return find_launch_tools(request.executable, request.variables, workspace.fetched.prefix,
                                 cancellation);
      },
      cancellation);
  if (!mistakes) return mistakes.errors();
  InvalidFiles result;
  for (const PythonMistake& one : *mistakes) {
    const std::string& path = paths[one.text];
    Diagnostic found = invalid_python(one, source_of(workspace, python, path), texts[one.text]);
    found.span->file = path;
    result.by_path.emplace(path, std::move(found));
  }
  return result;
}

PythonWorld world_of(const BuiltWorkspace& workspace, const PythonInput& python,
                     const InterfaceTexts& interfaces) {
  return {.workspace = python.workspace,
          .channels = python.channels,
          .wheels = python.wheels,
          .interfaces = interfaces,
          .channel_names = workspace.supplies.channel_names,
          .distro = workspace.read.manifest.distro,
          .libraries = site_libraries(workspace.supplies).project_of,
          .offered = workspace.supplies.python.offered.project_of,
          .takes_offered = takes_libraries(workspace.read.manifest)};
}

/// The libraries that a program imports, with what these need, which may be a channel's.
void take_libraries(const ImportReport& report, const PythonInput& python,
                    std::vector<std::string>& libraries, std::vector<std::string>& compiled) {
  std::set<std::string> wanted = report.libraries;
  wanted.insert(python.for_all.begin(), python.for_all.end());
  libraries = libraries_in_order(wanted, python.library_needs);
  std::set<std::string> modules = report.compiled;
  const std::set<std::string> of_channels = compiled_modules(python.channels);
  for (const std::string& project : libraries) {
    for (std::string need : python.library_needs.at(project)) {
      std::replace(need.begin(), need.end(), '-', '_');
      if (of_channels.contains(need)) modules.insert(std::move(need));
    }
  }
  // A pure wheel is unpacked for all programs.
  std::erase_if(libraries, [&](const std::string& one) { return !python.libraries.contains(one); });
  compiled.assign(modules.begin(), modules.end());
}

/// `because`: why a node is skipped for what it misses; empty: it is not, which is an error.
Outcome<Done> check_python_imports(const BuiltWorkspace& workspace, const PythonInput& python,
                                   const InterfaceTexts& interfaces, InvalidFiles& invalid,
                                   const std::string& because, std::vector<LaunchNode>& nodes,
                                   PackNotes& notes) {
  const PythonWorld world = world_of(workspace, python, interfaces);
  Diagnostics errors;
  std::set<std::tuple<std::string, std::uint32_t, std::string>> told;
  std::vector<LaunchNode> kept;
  for (LaunchNode& node : nodes) {
    if (node.kind != ProgramKind::kPython) {
      kept.push_back(std::move(node));
      continue;
    }
    ImportReport report = check_imports(python_script(node), world);
    take_libraries(report, python, node.libraries, node.compiled_modules);
    bool can_run = true;
    for (const std::string& file : report.own_files) {
      const auto found = invalid.by_path.find(file);
      if (found == invalid.by_path.end()) continue;
      invalid.reached.insert(file);
      report.missing.push_back(found->second);
    }
    for (Diagnostic& one : report.missing) {
      can_run = can_run && one.severity != Severity::kError;
      if (!told.emplace(one.span->file, one.span->line, one.message).second) continue;
      one.span->file = python.workspace.contains(one.span->file)
                           ? source_of(workspace, python, one.span->file)
                           : place_in_wheel(workspace.supplies.wheels, one.span->file);
      const bool is_warning = one.severity != Severity::kError || !because.empty();
      if (is_warning && one.severity == Severity::kError)
        one.why.push_back("`" + node.executable + "` of package `" + node.package +
                          "` is skipped for that, " + because);
      one.severity = is_warning ? Severity::kWarning : Severity::kError;
      (is_warning ? notes.warnings : errors).push_back(std::move(one));
    }
    if (can_run || because.empty()) kept.push_back(std::move(node));
  }
  if (!errors.empty()) return errors;
  nodes = std::move(kept);
  return Done{};
}

/// The same for the cells of the page's notebook: each is looked at as a program of its own, and
/// what one imports stays imported for the next.
Outcome<ImportReport> check_notebook_imports(const BuiltWorkspace& workspace, PythonInput& python,
                                             const InterfaceTexts& interfaces, PackNotes& notes) {
  const ReadWorkspace& read = workspace.read;
  const std::string file =
      shown_path(read.folder / read.manifest.ui_notebook->value, read.folder, read.shown_folder);
  ImportReport all;
  Diagnostics errors;
  std::vector<PythonFiles::iterator> added;
  for (const std::string_view module : kKernelModules) {
    const auto [place, is_new] =
        python.workspace.emplace(std::string(kPythonModules) + "/" + std::string(module), "");
    if (is_new) added.push_back(place);
  }
  for (const NotebookCell& cell : read.notebook->code) {
    const std::string name = cell_name(file, cell);
    // No file of an installation has this name.
    const std::string script = std::string(kCellFolder) + name;
    python.workspace.emplace(script, cell.source);
    ImportReport report = check_imports(script, world_of(workspace, python, interfaces));
    all.compiled.merge(report.compiled);
    all.libraries.merge(report.libraries);
    for (Diagnostic& one : report.missing) {
      const std::string& where = one.span->file;
      const auto own = python.workspace.find(where);
      one.span->file = where == script ? name
                       : own == python.workspace.end()
                           ? place_in_wheel(workspace.supplies.wheels, where)
                           : source_of(workspace, python, where);
      (one.severity == Severity::kError ? errors : notes.warnings).push_back(std::move(one));
    }
    python.workspace.erase(script);
  }
  for (const PythonFiles::iterator place : added) python.workspace.erase(place);
  if (!errors.empty()) return errors;
  return all;
}

/// The projects of libraries that these programs import; not of one that cannot run anyway.
void collect_libraries(const PythonWorld& world, const std::vector<LaunchNode>& nodes,
                       std::set<std::string>& reached) {
  for (const LaunchNode& node : nodes) {
    if (node.kind != ProgramKind::kPython) continue;
    ImportReport report = check_imports(python_script(node), world);
    const bool can_run =
        std::none_of(report.missing.begin(), report.missing.end(),
                     [](const Diagnostic& one) { return one.severity == Severity::kError; });
    if (can_run) reached.merge(report.libraries);
  }
}

/// All projects of libraries that some program or cell imports. What the manifest names and no
/// program imports is there for all.
Outcome<std::set<std::string>> reached_libraries(const BuiltWorkspace& workspace,
                                                 PythonInput& python, const PlanInput& input) {
  std::set<std::string> reached;
  const Manifest& manifest = workspace.read.manifest;
  const Supplies& supplies = workspace.supplies;
  const SiteLibraries libraries = site_libraries(supplies);
  if (libraries.depends.empty()) return reached;
  hide_replaced(manifest, supplies, {}, python.channels);
  do {
    const PythonWorld world = world_of(workspace, python, input.interfaces);
    collect_libraries(world, input.nodes, reached);
    collect_libraries(world, input.more_nodes, reached);
    if (input.notebook) {
      PackNotes ignored;  // these are reported when the rest is checked
      auto report = check_notebook_imports(workspace, python, input.interfaces, ignored);
      if (report) reached.merge(report->libraries);
    }
  } while (hide_replaced(manifest, supplies, reached, python.channels));
  std::set<std::string> there;
  for (std::string& one : libraries_in_order(reached, libraries.depends))
    there.insert(std::move(one));
  for (const std::string& one : named_libraries(manifest, supplies))
    if (!there.contains(one)) python.for_all.insert(one);
  reached.insert(python.for_all.begin(), python.for_all.end());
  return reached;
}

bool has_python(const std::vector<LaunchNode>& nodes) {
  return std::any_of(nodes.begin(), nodes.end(),
                     [](const LaunchNode& node) { return node.kind == ProgramKind::kPython; });
}

}  // namespace

Outcome<Done> add_python(const PackRequest& request, const BuiltWorkspace& workspace,
                         bool nodes_by_default, PlanInput& input, PackNotes& notes,
                         const Cancellation& cancellation) {
  const bool is_needed = has_python(input.nodes) || input.notebook;
  if (!is_needed && !has_python(input.more_nodes)) return Done{};
  auto python = read_python(workspace, notes);
  if (!python && is_needed) return std::move(python).errors();
  if (!python) {
    std::erase_if(input.more_nodes,
                  [](const LaunchNode& node) { return node.kind == ProgramKind::kPython; });
    for (Diagnostic& one : std::move(python).errors()) {
      one.severity = Severity::kWarning;
      notes.warnings.push_back(std::move(one));
    }
    return Done{};
  }
  auto invalid = invalid_files(request, workspace, *python, cancellation);
  if (!invalid) return std::move(invalid).errors();
  const auto reached = reached_libraries(workspace, *python, input);
  if (!reached) return reached.errors();
  if (auto added =
          add_libraries(workspace, *reached, *python, input.components, notes, cancellation);
      !added)
    return added;
  const auto check = [&](const char* because, std::vector<LaunchNode>& nodes) {
    return check_python_imports(workspace, *python, input.interfaces, *invalid, because, nodes,
                                notes);
  };
  const char* by_default = nodes_by_default ? "as the manifest names no nodes" : "";
  if (auto met = check(by_default, input.nodes); !met) return met;
  if (auto met = check("as it does not run from the start", input.more_nodes); !met) return met;
  for (auto& [path, one] : invalid->by_path) {
    if (invalid->reached.contains(path)) continue;
    one.severity = Severity::kWarning;
    one.span->file = source_of(workspace, *python, path);
    one.why.emplace_back("no node of the site imports it");
    notes.warnings.push_back(std::move(one));
  }
  if (input.notebook) {
    const auto report = check_notebook_imports(workspace, *python, input.interfaces, notes);
    if (!report) return report.errors();
    take_libraries(*report, *python, input.notebook->libraries, input.notebook->compiled);
  }
  input.python = std::move(*python);
  for (const InstalledPackage& package : workspace.built.installed)
    input.python_index.push_back(package.name);
  return Done{};
}

Outcome<Done> add_python_tools(const PackRequest& request, BuildTools& tools,
                               const Cancellation& cancellation) {
  const auto path = request.variables.find("PATH");
  auto node = find_node_js(request.executable, path == request.variables.end() ? "" : path->second,
                           cancellation);
  if (!node) return std::move(node).errors();
  const auto templates =
      find_own_data(request.executable, "templates/python", "the reader of setup.py files");
  if (!templates) return templates.errors();
  auto real = real_path(*templates);
  if (!real) return std::move(real).errors();
  tools.node_js = std::move(*node);
  tools.python_templates = std::move(*real);
  return Done{};
}

}  // namespace ros2wasm
