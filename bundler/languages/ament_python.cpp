// Python packages: their setup.py is read in Pyodide, which sees a copy of the package, the modules
// of what it depends on and nothing else of this machine, and what it would install is installed
// here. No Python of this machine has a part in it.
#include <chrono>

#include "bundler/build/compiler_warnings.hpp"
#include "bundler/build/setup_plan.hpp"
#include "bundler/build/source_tree.hpp"
#include "bundler/io/files.hpp"
#include "bundler/io/process.hpp"
#include "bundler/io/python_sandbox.hpp"
#include "bundler/languages/language.hpp"
#include "bundler/workspace/python_tree.hpp"

namespace ros2wasm {
namespace fs = std::filesystem;
namespace {

constexpr const char* kIndex = "share/ament_index/resource_index/packages";
constexpr std::chrono::seconds kTimeLimit{60};        // of one setup.py, of its processor
constexpr std::uintmax_t kLargestCopied = 4'000'000;  // what is bigger is data: its name is enough
// Where a link of the copy leads when the real one leads out of the workspace.
constexpr const char* kElsewhere = "out of the workspace";

/// Links of a package may lead to its own files and to others of the workspace.
bool is_in_workspace(const PackageBuild& request, const fs::path& file) {
  return path_within(request.place.source, file) ||
         (!request.workspace.empty() && path_within(request.workspace, file));
}

Outcome<Done> put(const fs::path& file, std::string_view bytes, bool is_program = false) {
  if (auto written = write_file(file, bytes); !written) return written;
  if (!is_program) return Done{};
  std::error_code error;
  fs::permissions(file, fs::perms::owner_exec | fs::perms::group_exec | fs::perms::others_exec,
                  fs::perm_options::add, error);
  if (error) return cannot_write(file, error.value());
  return Done{};
}

Diagnostic setup_failed(const PackageBuild& request, std::string why) {
  return Diagnostic{
      .code = "R2W0516",
      .message = "setup.py of package `" + request.place.package + "` cannot be read",
      .span = SourceSpan{.file = (fs::path(request.place.display) / "setup.py").string(),
                         .line = 0,
                         .line_text = {}},
      .why = {std::move(why)}};
}

Outcome<Done> put_all(const std::vector<SetupFile>& files, const PackageBuild& request,
                      const fs::path& to, bool are_programs = false) {
  for (const SetupFile& file : files) {
    const fs::path from = request.place.source / file.from;
    std::error_code error;
    if (fs::exists(from, error) && !is_in_workspace(request, from)) {
      return Diagnostic{.code = "R2W0516",
                        .message = "`" + file.from + "` of package `" + request.place.package +
                                   "` leads out of the workspace",
                        .why = {"what is installed comes into the site, which others read"}};
    }
    const auto bytes = read_file(from, kMostOfData);
    if (!bytes) return bytes.errors();
    if (auto done = put(to / file.to, *bytes, are_programs); !done) return done;
  }
  return Done{};
}

Outcome<Done> make_link(const fs::path& target, const fs::path& link) {
  std::error_code error;
  fs::create_symlink(target, link, error);
  if (error) return cannot_write(link, error.value());
  return Done{};
}

/// The package as its setup.py sees it: what its hash counts, large files empty, links that lead
/// out of the workspace leading nowhere.
Outcome<Done> copy_package(const PackageBuild& request, const fs::path& to) {
  const fs::path& source = request.place.source;
  const auto tree = source_tree(source, request.workspace);
  if (!tree) return tree.errors();
  std::string left_out;  // a folder with what is in it, which follows it
  for (const SourceEntry& entry : *tree) {
    if (!left_out.empty() && entry.path.starts_with(left_out)) continue;
    const fs::path copy = to / entry.path;
    Outcome<Done> made = Done{};
    if (!is_in_workspace(request, source / entry.path)) {
      left_out = entry.path + "/";
      made = make_link(kElsewhere, copy);
    } else if (!entry.same_as.empty()) {
      made = make_link((to / entry.same_as).lexically_relative(copy.parent_path()), copy);
    } else if (entry.is_folder) {
      made = make_directories(copy);
    } else {
      std::error_code error;
      const bool is_large = fs::file_size(source / entry.path, error) > kLargestCopied;
      const auto bytes = is_large ? Outcome<std::string>(std::string())
                                  : read_file(source / entry.path, kMostOfData);
      if (!bytes) return bytes.errors();
      made = write_file(copy, *bytes);
    }
    if (!made) return made;
  }
  return Done{};
}

/// The folders of modules that setup.py may import, nearest first.
std::vector<fs::path> module_folders(const PackageBuild& request) {
  std::vector<fs::path> result;
  for (const fs::path& prefix : request.prefixes) {
    std::error_code error;
    fs::path folder = fs::canonical(prefix / kPythonModules, error);
    if (!error && fs::is_directory(folder, error)) result.push_back(std::move(folder));
  }
  return result;
}

/// Runs setup.py; the JSON that read_setup.mjs prints.
Outcome<std::string> run_setup(const PackageBuild& request, const BuildTools& tools,
                               const fs::path& pyodide, const Cancellation& cancellation) {
  const auto folder = TemporaryDirectory::make(request.work, "setup-");
  if (!folder) return folder.errors();
  std::error_code error;
  const fs::path copy = fs::canonical(folder->path(), error);
  if (auto copied = copy_package(request, copy); !copied) return std::move(copied).errors();
  const fs::path program = tools.python_templates / "read_setup.mjs";
  std::vector<fs::path> readable = module_folders(request);
  std::vector<std::string> arguments{program.string(), pyodide.string(), copy.string(),
                                     request.place.package};
  for (const fs::path& modules : readable) arguments.push_back(modules.string());
  readable.insert(readable.end(), {pyodide, tools.python_templates, copy});
  ProcessRequest run = python_sandbox(tools.node_js, readable, arguments);
  run.directory = request.work;
  run.time_limit = kTimeLimit;
  const auto result = run_process(run, cancellation);
  if (!result) return result.errors();
  if (result->is_out_of_time)
    return setup_failed(request, "it did not end within " + std::to_string(kTimeLimit.count()) +
                                     " seconds of a processor, or ten times as many by the clock");
  if (result->exit_code == 0) return result->output;
  Diagnostic failed =
      setup_failed(request, "Node.js ended with " + std::to_string(result->exit_code));
  failed.detail = result->error;
  return failed;
}

Outcome<Done> install(const SetupPlan& plan, const PackageBuild& request) {
  const fs::path& source = request.place.source;
  const fs::path& prefix = request.install;
  const fs::path modules = prefix / kPythonModules;
  for (const WrittenFile& file : plan.written) {
    if (auto done = put(prefix / file.to, file.text); !done) return done;
  }
  if (auto done = put_all(plan.modules, request, modules); !done) return done;
  if (auto done = put_all(plan.data, request, prefix); !done) return done;
  if (auto done = put_all(plan.scripts, request, prefix, true); !done) return done;
  for (const EntryPoint& entry : plan.programs) {
    const fs::path file = prefix / plan.script_folder / entry.name;
    if (auto done = put(file, entry_point_script(entry, request.place.package), true); !done)
      return done;
  }
  const fs::path facts = modules / (plan.name + "-" + plan.version + ".dist-info");
  const std::string metadata =
      "Metadata-Version: 2.1\nName: " + plan.name + "\nVersion: " + plan.version + "\n";
  if (auto done = put(facts / "METADATA", metadata); !done) return done;
  if (!plan.entry_points.empty()) {
    if (auto done = put(facts / "entry_points.txt", entry_points_text(plan)); !done) return done;
  }
  // As colcon does for packages that forget them.
  const fs::path index = prefix / kIndex / request.place.package;
  const fs::path manifest = prefix / "share" / request.place.package / "package.xml";
  std::error_code error;
  if (!fs::exists(index, error)) {
    if (auto done = put(index, ""); !done) return done;
  }
  if (!fs::exists(manifest, error)) {
    const auto xml = read_file(source / "package.xml", kMostOfText);
    if (!xml) return xml.errors();
    return put(manifest, *xml);
  }
  return Done{};
}

}  // namespace

Outcome<Done> build_with_setup_py(const PackageBuild& request, const BuildTools& tools,
                                  const Cancellation& cancellation,
                                  const ProgressSink& /*progress*/) {
  std::error_code error;
  if (!fs::is_regular_file(request.place.source / "setup.py", error)) {
    return Diagnostic{.code = "R2W0516",
                      .message = "package `" + request.place.package + "` has no setup.py",
                      .why = {"its build type is ament_python, and nothing else says what it "
                              "installs"}};
  }
  const fs::path pyodide =
      request.prefixes.empty() ? fs::path() : request.prefixes.back() / kPyodideFolder;
  if (!fs::is_directory(pyodide, error)) {
    return no_pyodide("package `" + request.place.package + "` is of build type ament_python");
  }
  const auto json = run_setup(request, tools, fs::canonical(pyodide, error), cancellation);
  if (!json) return json.errors();
  const auto plan = read_setup_plan(*json, request.place);
  if (!plan) return plan.errors();
  if (auto installed = install(*plan, request); !installed) return installed;
  return keep_findings(request.install, plan->warnings);
}

}  // namespace ros2wasm
