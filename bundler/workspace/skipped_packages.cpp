// See skipped_packages.hpp.
#include "bundler/workspace/skipped_packages.hpp"

#include <algorithm>
#include <set>

#include "bundler/workspace/host_packages.hpp"
#include "workspace_schema/base/suggestion.hpp"

namespace ros2wasm {
namespace {

using Dependencies = std::vector<const PackageDependency*>;

/// A cause with its place, for those who read of it elsewhere.
std::string with_place(const std::string& cause, const SourceSpan& span) {
  if (span.file.empty()) return cause;
  return cause + " (" + span.file + (span.line == 0 ? "" : ":" + std::to_string(span.line)) + ")";
}

LeftOutReason left_out_for(const LocalPackage& package, const Dependencies& lacks,
                           const KnownNames& known, std::string_view distro) {
  std::vector<std::string> names;
  std::vector<std::string> why;
  for (const PackageDependency* one : lacks) {
    names.push_back("`" + one->name.value + "`");
    if (const auto similar = similar_name(one->name.value, known, distro))
      why.push_back("a channel has `" + *similar + "`");
  }
  const std::string cause = "no channel has " + name_list(names) + ", which it needs";
  why.emplace_back(
      "it is packed when what it lacks is in the workspace, `sources:` names a git repository that "
      "has it or a distribution file that has released it, or `channels:` a channel that has it");
  return {.chain = {with_place(cause, lacks.front()->name.span)},
          .warning = {.code = "R2W0519",
                      .severity = Severity::kWarning,
                      .message = "package `" + package.xml.name.value + "` is skipped: " + cause,
                      .span = lacks.front()->name.span,
                      .label = "asked for here",
                      .why = std::move(why)}};
}

LeftOutReason left_out_for_type(const LocalPackage& package,
                                const std::vector<std::string>& build_types) {
  const std::string& type = package.xml.build_type;
  std::string cause = type.empty()
                          ? "its package.xml names no build type"
                          : "packages of build type `" + type + "` are not built for sites";
  return {.chain = {with_place(cause, package.xml.name.span)},
          .warning = {.code = "R2W0514",
                      .severity = Severity::kWarning,
                      .message = "package `" + package.xml.name.value + "` is skipped: " + cause,
                      .span = package.xml.name.span,
                      .why = {"build types that are: " + name_list(build_types)}}};
}

}  // namespace

Dependencies lacking_dependencies(const LocalPackage& package,
                                  const std::vector<LocalPackage>& packages,
                                  const KnownNames& known, std::string_view distro) {
  const auto is_local = [&](const std::string& name) {
    return std::any_of(packages.begin(), packages.end(),
                       [&](const LocalPackage& one) { return one.xml.name.value == name; });
  };
  const bool is_python = package.xml.build_type == "ament_python";
  Dependencies result;
  std::set<std::string> names;
  for (const PackageDependency& one : package.xml.dependencies) {
    const std::string& name = one.name.value;
    const bool there = is_python || !matters_for_building(one.kind) ||
                       !is_absent(name, known, distro) || is_local(name) ||
                       !host_package_reason(name).empty();
    if (!there && names.insert(name).second) result.push_back(&one);
  }
  return result;
}

Lacks packages_with_lacks(const std::vector<LocalPackage>& packages,
                          const LeftOutPackages& left_out, const KnownNames& known,
                          std::string_view distro) {
  Lacks result;
  for (std::size_t i = 0; i < packages.size(); ++i) {
    if (left_out.contains(i) || !packages[i].has_cmake_lists) continue;
    const auto lacks = lacking_dependencies(packages[i], packages, known, distro);
    if (lacks.empty()) continue;
    Lack lack{.reason = left_out_for(packages[i], lacks, known, distro), .missing = {}};
    auto external = external_dependencies({packages[i]}, {}, distro);
    std::erase_if(external, [&](const ExternalDependency& one) {
      return std::none_of(lacks.begin(), lacks.end(),
                          [&](const auto* lacked) { return lacked->name.value == one.name; });
    });
    for (ExternalDependency& one : external) one.can_be_missing = false;
    lack.missing = missing_dependencies(external, known, distro);
    result.emplace(i, std::move(lack));
  }
  return result;
}

LeftOutPackages left_out_packages(const std::vector<LocalPackage>& packages,
                                  const BuildOrder& order, const KnownNames& known,
                                  std::string_view distro,
                                  const std::vector<std::string>& build_types) {
  const auto look = [&](bool for_lacking) {
    LeftOutPackages result;
    for (const std::size_t index : order.order) {
      const LocalPackage& package = packages[index];
      const auto& types = build_types;
      if (std::find(types.begin(), types.end(), package.xml.build_type) == types.end()) {
        result.emplace(index, left_out_for_type(package, types));
        continue;
      }
      const auto lacks =
          for_lacking ? lacking_dependencies(package, packages, known, distro) : Dependencies();
      const bool cannot_be_built = std::any_of(lacks.begin(), lacks.end(), [&](const auto* one) {
        return cannot_be_missing(package, *one);
      });
      if (cannot_be_built) {
        result.emplace(index, left_out_for(package, lacks, known, distro));
      } else if (const auto needed = nearest_left_out(order.needs[index], result)) {
        result.emplace(index, left_out_with(package, packages[*needed], result.at(*needed)));
      }
    }
    return result;
  };
  LeftOutPackages all = look(true);
  return all.size() == packages.size() ? look(false) : all;
}

std::optional<std::size_t> nearest_left_out(const std::vector<std::size_t>& needs,
                                            const LeftOutPackages& left_out) {
  // The last: each stands behind what it needs.
  const auto found = std::find_if(needs.rbegin(), needs.rend(),
                                  [&](std::size_t one) { return left_out.contains(one); });
  if (found == needs.rend()) return std::nullopt;
  return *found;
}

LeftOutReason left_out_with(const LocalPackage& package, const LocalPackage& needed,
                            const LeftOutReason& reason) {
  const std::string& name = needed.xml.name.value;
  const std::string cause = "it needs `" + name + "`, which is skipped";
  LeftOutReason result{
      .chain = {cause},
      .warning = {.code = "R2W0514",
                  .severity = Severity::kWarning,
                  .message = "package `" + package.xml.name.value + "` is skipped: " + cause,
                  .span = package.xml.name.span}};
  // The causes further away speak of "it" too: whose they are is said.
  result.chain.push_back("`" + name + "` is skipped: " + reason.chain.front());
  result.chain.insert(result.chain.end(), reason.chain.begin() + 1, reason.chain.end());
  result.warning.why.assign(result.chain.begin() + 1, result.chain.end());
  return result;
}

LeftOutReason left_out_by_cmake(const LocalPackage& package, const Diagnostic& error) {
  const std::string subject = "package `" + package.xml.name.value + "` ";
  const std::string cause = error.message.starts_with(subject)
                                ? "it " + error.message.substr(subject.size())
                                : error.message;
  return {.chain = {error.span ? with_place(cause, *error.span) : cause},
          .warning = {.code = "R2W0519",
                      .severity = Severity::kWarning,
                      .message = subject + "is skipped: " + cause,
                      .span = error.span,
                      .why = error.why}};
}

LeftOutChains chains_by_name(const std::vector<LocalPackage>& packages,
                             const LeftOutPackages& left_out) {
  LeftOutChains result;
  for (const auto& [index, reason] : left_out)
    result.emplace(packages[index].xml.name.value, reason.chain);
  return result;
}

}  // namespace ros2wasm
