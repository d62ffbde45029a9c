// Python packages: their setup.py is read in Pyodide, which sees nothing of this machine, and what
// it would install is installed here. No Python of this machine has a part in it.
#include "bundler/build/setup_plan.hpp"
#include "bundler/io/files.hpp"
#include "bundler/io/process.hpp"
#include "bundler/languages/language.hpp"
#include "bundler/launch/python_tree.hpp"

namespace ros2wasm {
namespace fs = std::filesystem;
namespace {

constexpr const char* kIndex = "share/ament_index/resource_index/packages";

Outcome<Done> put(const fs::path& file, std::string_view bytes, bool is_program = false) {
  if (auto written = write_file(file, bytes); !written) return written;
  if (!is_program) return Done{};
  std::error_code error;
  fs::permissions(file, fs::perms::owner_exec | fs::perms::group_exec | fs::perms::others_exec,
                  fs::perm_options::add, error);
  if (error) return cannot_write(file, error.value());
  return Done{};
}

Outcome<Done> put_all(const std::vector<SetupFile>& files, const fs::path& from, const fs::path& to,
                      bool are_programs = false) {
  for (const SetupFile& file : files) {
    const auto bytes = read_file(from / file.from);
    if (!bytes) return bytes.errors();
    if (auto done = put(to / file.to, *bytes, are_programs); !done) return done;
  }
  return Done{};
}

/// Runs setup.py; the JSON that read_setup.mjs prints.
Outcome<std::string> run_setup(const PackageBuild& request, const BuildTools& tools,
                               const fs::path& pyodide, const Cancellation& cancellation) {
  const std::string read = "--allow-fs-read=";
  const fs::path program = tools.python_templates / "read_setup.mjs";
  const auto result = run_process(
      {.arguments = {tools.node_js.string(), "--permission", read + pyodide.string(),
                     read + tools.python_templates.string(), read + request.place.source.string(),
                     program.string(), pyodide.string(), request.place.source.string()},
       .environment = {{"NODE_OPTIONS", ""}},
       .directory = request.work,
       .output_mode = OutputMode::kCapture,
       .on_output = {}},
      cancellation);
  if (!result) return result.errors();
  if (result->exit_code == 0) return result->output;
  return Diagnostic{.code = "R2W0516",
                    .message = "setup.py of package `" + request.place.package + "` cannot be read",
                    .why = {"Node.js ended with " + std::to_string(result->exit_code)},
                    .detail = result->error};
}

Outcome<Done> install(const SetupPlan& plan, const PackageBuild& request) {
  const fs::path& source = request.place.source;
  const fs::path& prefix = request.install;
  const fs::path modules = prefix / kPythonModules;
  if (auto done = put_all(plan.modules, source, modules); !done) return done;
  if (auto done = put_all(plan.data, source, prefix); !done) return done;
  if (auto done = put_all(plan.scripts, source, prefix, true); !done) return done;
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
    const auto xml = read_file(source / "package.xml");
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
  return install(*plan, request);
}

}  // namespace ros2wasm
