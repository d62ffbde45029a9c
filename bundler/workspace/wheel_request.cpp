// See wheel_request.hpp.
#include "bundler/workspace/wheel_request.hpp"

#include <algorithm>
#include <set>

#include "workspace_schema/conda/match_spec.hpp"
#include "workspace_schema/conda/wheel_requirement.hpp"

namespace ros2wasm {
namespace {

bool has(const std::vector<std::string>& sorted, std::string_view name) {
  return std::binary_search(sorted.begin(), sorted.end(), name, std::less<>());
}

/// Top-level modules and packages.
std::set<std::string> modules_of(const Wheel& wheel) {
  std::set<std::string> modules;
  for (const auto& [path, bytes] : wheel.files) {
    if (path.ends_with(".py") || wheel.side_modules.contains(path))
      modules.insert(path.substr(0, path.find_first_of("/.")));
  }
  return modules;
}

std::string asked(const WheelRequirement& need) {
  return need.versions.empty() ? need.project : need.project + " " + need.versions;
}

Diagnostic unmet(const NamedWheel& wheel, const std::string& what, std::string why) {
  return {.code = "R2W0520",
          .severity = Severity::kWarning,
          .message = "the wheel of `" + wheel.locked.project + "` asks for `" + what +
                     "`, which the site has not",
          .span = wheel.span,
          .label = "asks for it",
          .why = {std::move(why),
                  "name a wheel of it under `python: wheels:`, or a channel that has it; a program "
                  "that imports what is missing is refused (R2W0518)"}};
}

/// In its place among the others, which are sorted by text.
void add_spec(std::vector<RequestedSpec>& specs, RequestedSpec spec) {
  const auto place = std::lower_bound(
      specs.begin(), specs.end(), spec,
      [](const RequestedSpec& a, const RequestedSpec& b) { return a.text < b.text; });
  if (place == specs.end() || place->text != spec.text) specs.insert(place, std::move(spec));
}

}  // namespace

void add_wheel_request(const std::vector<NamedWheel>& wheels, const KnownNames& known,
                       std::string_view distro, const std::vector<LockedLibrary>& libraries,
                       ChannelRequest& request) {
  for (const NamedWheel& wheel : wheels) {
    for (const std::string& text : wheel.wheel.requirements) {
      const auto need = wheel_requirement(text);
      if (!need || !need->applies) continue;
      const auto other = std::find_if(wheels.begin(), wheels.end(), [&](const NamedWheel& one) {
        return one.locked.project == need->project;
      });
      if (other != wheels.end()) {
        if (!fits_versions(other->locked.version, need->versions)) {
          request.warnings.push_back(
              unmet(wheel, asked(*need), "the manifest names a wheel of " + other->locked.version));
        }
        continue;
      }
      const auto library =
          std::find_if(libraries.begin(), libraries.end(),
                       [&](const LockedLibrary& one) { return one.project == need->project; });
      if (library != libraries.end()) {
        if (!fits_versions(library->version, need->versions)) {
          request.warnings.push_back(
              unmet(wheel, asked(*need), "Pyodide's distribution has it as " + library->version));
        }
        continue;
      }
      const std::string name = python_package_name(need->project, known.names, distro);
      if (name.empty()) {
        request.warnings.push_back(unmet(
            wheel, asked(*need),
            "no other wheel of the manifest is of `" + need->project + "`, and no channel has it"));
        continue;
      }
      const std::string spec = name + " " + need->versions;
      add_spec(request.specs,
               {.text = !need->versions.empty() && MatchSpec::parse(spec) ? spec : name,
                .origin = wheel.file_name,
                .span = wheel.span});
    }
  }
}

std::string python_package_name(std::string_view project, const std::vector<std::string>& names,
                                std::string_view distro) {
  std::string underscored(project);
  std::replace(underscored.begin(), underscored.end(), '-', '_');
  for (const std::string& name :
       {conda_name("python3-" + std::string(project), distro), std::string(project), underscored,
        conda_name(underscored, distro)}) {
    if (has(names, name)) return name;
  }
  return {};
}

void drop_met_by_wheels(const std::vector<NamedWheel>& wheels, std::string_view distro,
                        std::vector<LocalPackage>& packages) {
  std::set<std::string> projects;
  std::set<std::string> modules;
  for (const NamedWheel& wheel : wheels) {
    projects.insert(wheel.locked.project);
    modules.merge(modules_of(wheel.wheel));
  }
  const auto is_met = [&](const std::string& name) {
    return projects.contains(normal_project_name(name)) ||
           projects.contains(normal_project_name(conda_name(name, distro)));
  };
  for (LocalPackage& package : packages) {
    std::erase_if(package.xml.dependencies,
                  [&](const PackageDependency& one) { return is_met(one.name.value); });
    std::erase_if(package.python_modules,
                  [&](const Spanned<std::string>& one) { return modules.contains(one.value); });
    std::erase_if(package.python_uses, [&](const PythonImport& one) {
      return modules.contains(one.module.substr(0, one.module.find('.')));
    });
  }
}

}  // namespace ros2wasm
