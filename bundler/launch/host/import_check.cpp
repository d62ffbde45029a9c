// See import_check.hpp.
#include "bundler/launch/host/import_check.hpp"

#include <algorithm>
#include <array>
#include <optional>

#include "bundler/launch/host/import_hints.hpp"
#include "bundler/workspace/build_order.hpp"
#include "bundler/workspace/python_imports.hpp"
#include "bundler/workspace/python_libraries.hpp"
#include "bundler/workspace/python_modules.hpp"
#include "workspace_schema/base/text_pattern.hpp"

namespace ros2wasm {
namespace {

/// A module of Python, and the one of others without which it knows no time zone.
constexpr std::string_view kZones = "zoneinfo";
constexpr std::string_view kZonesModule = "tzdata";

constexpr std::string_view kInit = "/__init__.py";
constexpr std::array<std::string_view, 3> kKinds = {"msg", "srv", "action"};
constexpr std::string_view kWheel =
    "a wheel of it for `py3-none-any` can be named under `python: wheels:` of workspace.yaml";

std::string modules_folder() {
  return std::string(kPythonModules) + "/";
}

std::string top_level(const std::string& module) {
  return module.substr(0, module.find('.'));
}

bool is_below(const PythonFiles& files, const std::string& prefix) {
  const auto next = files.lower_bound(prefix);
  return next != files.end() && next->first.starts_with(prefix);
}

class Walk {
 public:
  explicit Walk(const PythonWorld& world)
      : world_(world), compiled_(compiled_modules(world.channels)) {}

  ImportReport run(const std::string& script) {
    script_folder_ = script.substr(0, script.rfind('/') + 1);
    if (world_.workspace.contains(script)) {
      visit(script, true);
    } else if (world_.channels.contains(script)) {
      visit_channel(script);
    }
    for (const auto& [path, needed] : visited_)
      if (world_.workspace.contains(path)) report_.own_files.insert(path);
    return std::move(report_);
  }

 private:
  /// `needed`: the program does not start without it.
  void visit(const std::string& path, bool needed) {
    const auto [seen, is_new] = visited_.emplace(path, needed);
    if (!is_new && (seen->second || !needed)) return;
    seen->second = needed;
    const bool is_own = world_.workspace.contains(path);
    const PythonFiles& files = is_own ? world_.workspace : world_.wheels;
    const auto file = files.find(path);
    if (file == files.end()) return;
    for (const PythonImport& one : python_imports(file->second, path)) {
      // Do not warn about imports that a library of a third party can do without.
      quiet_ = !is_own && !(needed && one.needed);
      follow(one, path, needed && one.needed);
    }
  }

  /// Follows only the imports that a module of a channel cannot do without, to find compiled
  /// modules.
  void visit_channel(const std::string& path) {
    if (!visited_.emplace(path, true).second) return;
    for (const PythonImport& one : python_imports(world_.channels.at(path), path)) {
      const std::string module = absolute(one.module, path);
      const std::string top = top_level(module);
      if (!one.needed || is_python_module(top) || take_library(module, one)) continue;
      if (compiled_.contains(top)) {
        report_.compiled.insert(top);
        continue;
      }
      std::vector<std::string> inner = with_parents(module);
      for (const std::string& name : one.names) inner.push_back(module + "." + name);
      for (const std::string& name : inner) {
        if (const auto file = find_file(world_.channels, name)) visit_channel(*file);
      }
    }
  }

  void follow(const PythonImport& one, const std::string& path, bool needed) {
    const std::string module = absolute(one.module, path);
    if (module.empty() || module.starts_with('.'))
      return add(one, "`" + one.module + "` leads out of the package", {}, needed);
    const std::string top = top_level(module);
    if (take_library(module, one)) return;
    if (compiled_.contains(top)) report_.compiled.insert(top);
    if (is_python_module(top) && !is_lacking_python_module(top))
      return tell_of_failing(one, module, path);
    for (const std::string& part : with_parents(module))
      if (!import_module(part, needed)) return missing(one, module, part, needed);
    for (const std::string& name : one.names) {
      const std::string inner = module + "." + name;
      if (find_file(world_.workspace, inner) || find_file(world_.wheels, inner) ||
          find_file(world_.channels, inner))
        import_module(inner, needed);
      if (is_interface_module(module) && name != "*" && !has_interface(module, name))
        missing_interface(one, module, name, needed);
    }
  }

  /// True for what comes from a library, and from nowhere else.
  bool take_library(const std::string& module, const PythonImport& one) {
    const std::string top = top_level(module);
    const auto library = world_.libraries.find(top);
    if (library == world_.libraries.end()) return false;
    const auto is_in = [&](const PythonFiles& files) {
      return find_file(files, top) || is_below(files, modules_ + top + "/");
    };
    if (is_in(world_.workspace) || is_in(world_.wheels)) return false;
    if (is_in(world_.channels) && stand_in_has(module, one.names, one.attributes).value_or(true))
      return false;
    report_.libraries.insert(library->second);
    return true;
  }

  /// Is there such a module? One of the workspace is read.
  bool import_module(const std::string& module, bool needed) {
    for (const PythonFiles* files : {&world_.workspace, &world_.wheels}) {
      if (const auto file = find_file(*files, module)) {
        const bool quiet = quiet_;
        visit(*file, needed);
        quiet_ = quiet;
        return true;
      }
    }
    if (const auto file = find_file(world_.channels, module)) visit_channel(*file);
    const std::string base = modules_ + slashed(module);
    return is_below(world_.workspace, base + "/") || is_below(world_.channels, base + "/") ||
           is_below(world_.wheels, base + "/") || is_below(world_.channels, base + ".") ||
           is_interface_module(module) ||
           is_below(world_.workspace, script_folder_ + slashed(module) + "/");
  }

  /// Modules beside the script come first, as with native ROS.
  [[nodiscard]] std::optional<std::string> find_file(const PythonFiles& files,
                                                     const std::string& module) const {
    for (const std::string& folder : {script_folder_, modules_}) {
      for (const std::string_view ending : {kInit, std::string_view(".py")}) {
        std::string path = folder + slashed(module) + std::string(ending);
        if (files.contains(path)) return path;
      }
    }
    return std::nullopt;
  }

  static std::string slashed(std::string module) {
    std::replace(module.begin(), module.end(), '.', '/');
    return module;
  }

  /// `a`, `a.b` and `a.b.c` of the last.
  static std::vector<std::string> with_parents(const std::string& module) {
    std::vector<std::string> result;
    for (auto dot = module.find('.'); dot != std::string::npos; dot = module.find('.', dot + 1))
      result.push_back(module.substr(0, dot));
    result.push_back(module);
    return result;
  }

  /// The package that a relative name begins at is that of the file.
  [[nodiscard]] std::string absolute(const std::string& module, const std::string& path) const {
    if (!module.starts_with('.')) return module;
    const std::string root = path.starts_with(modules_) ? modules_ : script_folder_;
    if (!path.starts_with(root)) return module;
    const auto dots = module.find_first_not_of('.');
    std::string folder = path.substr(root.size());
    for (std::size_t i = 0; i < std::min(dots, module.size()); ++i)
      folder.erase(folder.rfind('/') == std::string::npos ? 0 : folder.rfind('/'));
    std::replace(folder.begin(), folder.end(), '/', '.');
    if (dots == std::string::npos) return folder;
    return folder + "." + module.substr(dots);
  }

  /// `pkg`, `pkg.msg` or `pkg.msg._string`, of packages with definitions.
  [[nodiscard]] bool is_interface_module(const std::string& module) const {
    std::string path = module;
    std::replace(path.begin(), path.end(), '.', '/');
    const auto first = path.find('/');
    if (first == std::string::npos) return has_type(path + "/");
    const auto second = path.find('/', first + 1);
    const std::string kind = path.substr(first + 1, second - first - 1);
    return std::find(kKinds.begin(), kKinds.end(), kind) != kKinds.end() &&
           has_type(path.substr(0, second) + "/");
  }

  [[nodiscard]] bool has_type(const std::string& prefix) const {
    const auto next = world_.interfaces.lower_bound(prefix);
    return next != world_.interfaces.end() && next->first.starts_with(prefix);
  }

  /// `module`: `pkg.msg`, or `pkg.msg._string` of one definition. `name`: also a part of a type,
  /// such as `Trigger_Request`, or a submodule.
  [[nodiscard]] bool has_interface(const std::string& module, const std::string& name) const {
    const auto dot = module.find('.');
    if (name.starts_with('_') || dot == std::string::npos) return true;
    const std::string kind = module.substr(0, module.find('.', dot + 1));
    return world_.interfaces.contains(slashed(kind) + "/" + name.substr(0, name.find('_')));
  }

  void add(const PythonImport& one, std::string message, std::vector<std::string> why,
           bool needed) {
    if (quiet_) return;
    report_.missing.push_back(Diagnostic{.code = "R2W0518",
                                         .severity = needed ? Severity::kError : Severity::kWarning,
                                         .message = std::move(message),
                                         .span = one.span,
                                         .label = "imported here",
                                         .why = std::move(why)});
  }

  /// Python has it, and what it is for does not work.
  void tell_of_failing(const PythonImport& one, const std::string& module,
                       const std::string& path) {
    // Report only uses in files of the workspace, not in libraries of third parties.
    if (!world_.workspace.contains(path)) return;
    std::optional<FailingModule> found = failing_module(module);
    for (const std::string& name : one.names) {
      if (!found) found = failing_module(module + "." + name);
    }
    if (!found) return;
    if (found->name == kZones && import_module(std::string(kZonesModule), false)) return;
    add(one, "`" + std::string(found->name) + "` can be imported, but does not work in a site",
        {std::string(found->fails), std::string(found->instead)}, false);
    report_.missing.back().code = "R2W0526";
  }

  void missing_interface(const PythonImport& one, const std::string& module,
                         const std::string& name, bool needed) {
    add(one, "`" + module + "` has no `" + name + "`",
        {"share/" + top_level(module) + " has no definition of it"}, needed);
  }

  void missing(const PythonImport& one, const std::string& module, const std::string& part,
               bool needed) {
    const std::string top = top_level(module);
    if (is_lacking_python_module(top)) {
      return add(one, "`" + module + "` is not there in a site",
                 {"it is a part of Python that Python in a browser lacks", hint_for_module(top)},
                 needed);
    }
    if (part != top) {
      return add(one, "`" + part + "` is not there",
                 {"`" + top + "` is there, but has no such module in this version"}, needed);
    }
    std::vector<std::string> why;
    std::vector<std::string> wanted = {conda_name(package_of_module(top), world_.distro),
                                       ascii_lower(top)};
    wanted.erase(std::unique(wanted.begin(), wanted.end()), wanted.end());
    std::string tried;
    for (const std::string& name : wanted) {
      tried += (tried.empty() ? "`" : " or `") + name + "`";
      if (!std::binary_search(world_.channel_names.begin(), world_.channel_names.end(), name))
        continue;
      why.push_back("a channel has `" + name + "`, but what is installed of it has no such module");
    }
    if (why.empty())
      why.push_back("no channel has " + tried + ", nor has the workspace a module of that name");
    const std::string hint = hint_for_module(top);
    const auto offered = world_.offered.find(top);
    if (!hint.empty()) {
      why.push_back(hint);
    } else if (offered != world_.offered.end()) {
      const std::string where = "Pyodide's distribution has it, in `" + offered->second + "`";
      why.push_back(world_.takes_offered
                        ? where + "; `python: packages: [" + offered->second +
                              "]` of workspace.yaml asks for it"
                        : where + ", which `python: index: none` of workspace.yaml leaves out");
    } else {
      why.emplace_back(kWheel);
    }
    add(one, "no package of the site has the module `" + top + "`", std::move(why), needed);
  }

  const PythonWorld& world_;
  const std::set<std::string> compiled_;
  const std::string modules_ = modules_folder();
  std::string script_folder_;
  std::map<std::string, bool> visited_;  ///< file -> whether it is needed
  bool quiet_ = false;                   ///< what is missing is not told
  ImportReport report_;
};

}  // namespace

std::set<std::string> compiled_modules(const PythonFiles& channels) {
  std::set<std::string> result;
  const std::string root = modules_folder();
  for (auto it = channels.lower_bound(root); it != channels.end() && it->first.starts_with(root);
       ++it) {
    if (!it->first.ends_with(".so") && !it->first.ends_with(".wasm")) continue;
    const std::string below = it->first.substr(root.size());
    result.insert(below.substr(0, below.find_first_of("/.")));
  }
  return result;
}

ImportReport check_imports(const std::string& script, const PythonWorld& world) {
  ImportReport report = Walk(world).run(script);
  for (Diagnostic& one : report.missing) std::erase(one.why, std::string());
  return report;
}

}  // namespace ros2wasm
