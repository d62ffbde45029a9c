// See build_order.hpp.
#include "bundler/workspace/build_order.hpp"

#include <algorithm>
#include <iterator>
#include <map>
#include <set>

#include "bundler/workspace/host_packages.hpp"
#include "bundler/workspace/library_packages.hpp"
#include "workspace_schema/base/suggestion.hpp"

namespace ros2wasm {
namespace {

using Indices = std::vector<std::size_t>;

bool matters_for_running(DependencyKind kind) {
  return kind == DependencyKind::kExec;
}

/// Is one of these groups among those?
bool has_member(const std::vector<Spanned<std::string>>& groups,
                const std::vector<Spanned<std::string>>& of_member) {
  return std::any_of(groups.begin(), groups.end(), [&](const Spanned<std::string>& group) {
    return std::any_of(of_member.begin(), of_member.end(),
                       [&](const Spanned<std::string>& one) { return one.value == group.value; });
  });
}

/// Adds the limits that are not there yet.
void add_limits(const PackageDependency& dependency, std::vector<std::string>& limits) {
  for (std::string& limit : version_limits(dependency.version_limits)) {
    if (std::find(limits.begin(), limits.end(), limit) == limits.end())
      limits.push_back(std::move(limit));
  }
}

std::string match_spec(const std::string& name, const std::vector<std::string>& limits) {
  std::string spec = name;
  for (const std::string& limit : limits) spec += (&limit == &limits.front() ? " " : ",") + limit;
  return spec;
}

/// The packages among the others that package `index` needs, by name or by group, each once and
/// sorted.
Indices direct_needs(const std::vector<LocalPackage>& packages, std::size_t index) {
  const PackageXml& own = packages[index].xml;
  std::set<std::size_t> result;
  for (std::size_t i = 0; i < packages.size(); ++i) {
    const PackageXml& other = packages[i].xml;
    const bool by_name = std::any_of(
        own.dependencies.begin(), own.dependencies.end(), [&](const PackageDependency& one) {
          return one.name.value == other.name.value && matters_for_building(one.kind);
        });
    const bool by_group = i != index && has_member(own.group_depends, other.member_of_groups);
    if (by_name || by_group) result.insert(i);
  }
  return {result.begin(), result.end()};
}

/// Depth first; `state` 1 is "being visited". Returns a cycle's members when there is one.
class Sorter {
 public:
  explicit Sorter(const std::vector<Indices>& needs) : needs_(needs), state_(needs.size(), 0) {}

  [[nodiscard]] Indices visit(std::size_t index) {
    if (state_[index] == 2) return {};
    path_.push_back(index);
    if (state_[index] == 1) {
      const auto start = std::find(path_.begin(), path_.end(), index);
      return {start, path_.end()};
    }
    state_[index] = 1;
    for (const std::size_t needed : needs_[index]) {
      Indices cycle = visit(needed);
      if (!cycle.empty()) return cycle;
    }
    state_[index] = 2;
    path_.pop_back();
    order_.push_back(index);
    return {};
  }

  [[nodiscard]] const Indices& order() const { return order_; }

 private:
  const std::vector<Indices>& needs_;
  std::vector<int> state_;
  Indices path_;
  Indices order_;
};

Diagnostic cycle_error(const std::vector<LocalPackage>& packages, const Indices& cycle) {
  std::string chain;
  for (const std::size_t index : cycle) {
    chain += (chain.empty() ? "`" : " needs `") + packages[index].xml.name.value + "`";
  }
  return Diagnostic{.code = "R2W0512",
                    .message = "packages need each other, so none can be built first",
                    .span = packages[cycle.front()].xml.name.span,
                    .why = {chain}};
}

/// Everything reachable over `direct`, in the order of `order`.
Indices closure(std::size_t index, const std::vector<Indices>& direct, const Indices& order) {
  std::set<std::size_t> reached;
  Indices pending = direct[index];
  while (!pending.empty()) {
    const std::size_t next = pending.back();
    pending.pop_back();
    if (reached.insert(next).second)
      pending.insert(pending.end(), direct[next].begin(), direct[next].end());
  }
  Indices result;
  for (const std::size_t one : order) {
    if (reached.contains(one)) result.push_back(one);
  }
  return result;
}

}  // namespace

std::vector<std::string> version_limits(const std::map<std::string, std::string>& limits) {
  static const std::map<std::string, std::string> kOperators = {
      {"lt", "<"}, {"lte", "<="}, {"eq", "=="}, {"gte", ">="}, {"gt", ">"}};
  std::vector<std::string> result;
  for (const auto& [key, version] : limits) {
    if (const auto found = kOperators.find(key); found != kOperators.end())
      result.push_back(found->second + version);
  }
  return result;
}

Diagnostics duplicate_names(const std::vector<LocalPackage>& packages) {
  std::map<std::string, const LocalPackage*> first;
  Diagnostics errors;
  for (const LocalPackage& package : packages) {
    const auto [at, is_new] = first.emplace(package.xml.name.value, &package);
    if (is_new) continue;
    errors.push_back(
        Diagnostic{.code = "R2W0511",
                   .message = "two packages are called `" + package.xml.name.value + "`",
                   .span = package.xml.name.span,
                   .label = "the second",
                   .why = {"the first is in " + at->second->xml.file,
                           at->second->base == package.base
                               ? "a file COLCON_IGNORE in a folder keeps that folder out"
                               : "`packages:` of a source names the packages that are taken"}});
  }
  return errors;
}

bool matters_for_building(DependencyKind kind) {
  switch (kind) {
    case DependencyKind::kBuild:
    case DependencyKind::kBuildExport:
    case DependencyKind::kBuildTool:
    case DependencyKind::kBuildToolExport:
      return true;
    case DependencyKind::kExec:
    case DependencyKind::kTest:
    case DependencyKind::kDoc:
      return false;
  }
  return false;
}

bool cannot_be_missing(const LocalPackage& package, const PackageDependency& dependency) {
  if (!matters_for_building(dependency.kind)) return false;
  if (package.xml.build_type == "ament_python") return false;
  const auto& asked = package.cmake_packages;
  return !package.has_cmake_lists || std::any_of(asked.begin(), asked.end(), [&](const auto& one) {
    return one.value == dependency.name.value;
  });
}

bool is_absent(std::string_view package, const KnownNames& known, std::string_view distro) {
  const std::string wanted = conda_name(package, distro);
  const auto& names = known.of_lock ? known.absent : known.names;
  return std::binary_search(names.begin(), names.end(), wanted) == known.of_lock;
}

std::optional<std::string> similar_name(std::string_view package, const KnownNames& known,
                                        std::string_view distro) {
  // Without what all names of a distribution begin with, which would make all of them similar.
  std::vector<std::string> candidates = ros_names(known.names, distro);
  const std::string prefix = "ros-" + std::string(distro) + "-";
  std::copy_if(known.names.begin(), known.names.end(), std::back_inserter(candidates),
               [&](const std::string& name) { return !name.starts_with(prefix); });
  const auto similar = nearest(package, candidates);
  if (!similar) return std::nullopt;
  const bool is_ros =
      std::find(known.names.begin(), known.names.end(), *similar) == known.names.end();
  return is_ros ? conda_name(*similar, distro) : *similar;
}

std::string conda_name(std::string_view package, std::string_view distro) {
  if (const std::string_view library = library_package(package); !library.empty())
    return std::string(library);
  std::string name = "ros-" + std::string(distro) + "-" + std::string(package);
  std::replace(name.begin(), name.end(), '_', '-');
  return name;
}

std::vector<std::string> ros_names(const std::vector<std::string>& conda_names,
                                   std::string_view distro) {
  const std::string prefix = "ros-" + std::string(distro) + "-";
  std::vector<std::string> result;
  for (const std::string& name : conda_names) {
    if (!name.starts_with(prefix)) continue;
    result.push_back(name.substr(prefix.size()));
    std::replace(result.back().begin(), result.back().end(), '-', '_');
  }
  std::sort(result.begin(), result.end());
  return result;
}

Outcome<BuildOrder> order_packages(const std::vector<LocalPackage>& packages,
                                   std::string_view distro) {
  Diagnostics errors = duplicate_names(packages);
  if (!errors.empty()) return errors;
  std::vector<Indices> direct;
  for (std::size_t i = 0; i < packages.size(); ++i) direct.push_back(direct_needs(packages, i));

  Sorter sorter(direct);
  for (std::size_t i = 0; i < packages.size(); ++i) {
    const Indices cycle = sorter.visit(i);
    if (!cycle.empty()) return cycle_error(packages, cycle);
  }
  BuildOrder result{.order = sorter.order()};
  for (std::size_t i = 0; i < packages.size(); ++i) {
    result.needs.push_back(closure(i, direct, result.order));
  }
  result.external = external_dependencies(packages, {}, distro);
  return result;
}

std::vector<ExternalDependency> external_dependencies(const std::vector<LocalPackage>& packages,
                                                      const std::set<std::size_t>& left_out,
                                                      std::string_view distro) {
  std::set<std::string> local;
  for (const LocalPackage& package : packages) local.insert(package.xml.name.value);
  std::map<std::string, ExternalDependency> external;
  std::map<std::string, std::vector<std::string>> limits;
  for (std::size_t i = 0; i < packages.size(); ++i) {
    if (left_out.contains(i)) continue;
    for (const PackageDependency& dependency : packages[i].xml.dependencies) {
      const bool building = matters_for_building(dependency.kind);
      if (!building && !matters_for_running(dependency.kind)) continue;
      const std::string& name = dependency.name.value;
      if (local.contains(name) || !host_package_reason(name).empty()) continue;
      ExternalDependency& entry = external[name];
      entry.name = name;
      add_limits(dependency, limits[name]);
      entry.needed_to_build = entry.needed_to_build || building;
      if (cannot_be_missing(packages[i], dependency)) entry.can_be_missing = false;
      // One <depend> is three dependencies with one place.
      if (entry.places.empty() || !(entry.places.back() == dependency.name.span)) {
        entry.places.push_back(dependency.name.span);
      }
    }
  }
  std::vector<ExternalDependency> result;
  for (auto& [name, entry] : external) {
    entry.match_spec = match_spec(conda_name(name, distro), limits[name]);
    result.push_back(std::move(entry));
  }
  return result;
}

/// The distributions that the channels have the client library of, sorted.
std::vector<std::string> distros_of(const std::vector<std::string>& conda_names) {
  constexpr std::string_view kBegin = "ros-";
  constexpr std::string_view kEnd = "-rclcpp";
  std::vector<std::string> result;
  for (const std::string& name : conda_names) {
    if (!name.starts_with(kBegin) || !name.ends_with(kEnd) ||
        name.size() <= kBegin.size() + kEnd.size())
      continue;
    result.push_back(name.substr(kBegin.size(), name.size() - kBegin.size() - kEnd.size()));
  }
  std::sort(result.begin(), result.end());
  return result;
}

/// All packages lack for one reason: the channels are of another distribution.
std::optional<Diagnostic> other_distro(const std::vector<ExternalDependency>& external,
                                       const KnownNames& known, std::string_view distro) {
  const auto is_needed = [](const ExternalDependency& one) { return !one.can_be_missing; };
  const auto first = std::find_if(external.begin(), external.end(), is_needed);
  if (known.of_lock || first == external.end() || !ros_names(known.names, distro).empty())
    return std::nullopt;
  const std::vector<std::string> distros = distros_of(known.names);
  if (distros.empty()) return std::nullopt;
  Diagnostic result{.code = "R2W0513",
                    .message = "no channel has packages of ROS 2 `" + std::string(distro) + "`",
                    .span = first->places.front(),
                    .label = "the first package that is asked for",
                    .why = {"the channels have those of " + name_list(distros),
                            "workspace.yaml says `distro: " + std::string(distro) + "`"},
                    .fix = {"distro: " + distros.back()}};
  return result;
}

Diagnostics missing_dependencies(const std::vector<ExternalDependency>& external,
                                 const KnownNames& known, std::string_view distro) {
  if (auto reason = other_distro(external, known, distro)) return {std::move(*reason)};
  Diagnostics result;
  for (const ExternalDependency& dependency : external) {
    const std::string wanted = conda_name(dependency.name, distro);
    if (std::binary_search(known.names.begin(), known.names.end(), wanted)) continue;
    if (known.of_lock && dependency.needed_to_build && !is_absent(dependency.name, known, distro))
      continue;
    Diagnostic diagnostic{
        .code = "R2W0513",
        .severity = dependency.can_be_missing ? Severity::kWarning : Severity::kError,
        .message = (known.of_lock ? "the lock has no `" : "no channel has `") + dependency.name +
                   "`, and the workspace has not either",
        .span = dependency.places.front(),
        .label = "asked for here",
        .why = {"in a channel it would be called `" + wanted + "`"}};
    if (dependency.places.size() > 1) {
      diagnostic.why.push_back("it is asked for in " + std::to_string(dependency.places.size()) +
                               " places");
    }
    if (known.of_lock) {
      diagnostic.why.emplace_back("only when the lock is written are the channels asked");
    } else if (const auto similar = similar_name(dependency.name, known, distro)) {
      diagnostic.why.push_back("a channel has `" + *similar + "`");
    }
    if (!dependency.can_be_missing && !known.of_lock)
      diagnostic.why.emplace_back(
          "`sources:` can name a git repository that has it, or a distribution file that has "
          "released it");
    if (dependency.can_be_missing)
      diagnostic.why.emplace_back(
          dependency.needed_to_build
              ? "what names it is built without it: nothing there asks for it"
              : "a node may need it when it runs");
    result.push_back(std::move(diagnostic));
  }
  return result;
}

}  // namespace ros2wasm
