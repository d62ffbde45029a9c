// The table of build types.
#include "bundler/languages/language.hpp"

#include <algorithm>
#include <array>

#include "workspace_schema/suggestion.hpp"

namespace ros2wasm {
namespace {

constexpr auto kLanguages = std::to_array<Language>({
    {.build_type = "ament_cmake", .build = build_with_cmake},
    {.build_type = "ament_python", .build = build_with_setup_py},
    {.build_type = "cmake", .build = build_with_cmake},
});

}  // namespace

const Language* find_language(std::string_view build_type) {
  const auto found = std::find_if(kLanguages.begin(), kLanguages.end(), [&](const Language& row) {
    return row.build_type == build_type;
  });
  return found == kLanguages.end() ? nullptr : found;
}

std::vector<std::string> known_build_types() {
  std::vector<std::string> names;
  for (const Language& row : kLanguages) names.emplace_back(row.build_type);
  return names;
}

std::map<std::size_t, std::size_t> left_out_packages(const std::vector<LocalPackage>& packages,
                                                     const BuildOrder& order) {
  std::map<std::size_t, std::size_t> causes;
  for (const std::size_t index : order.order) {
    const auto& needs = order.needs[index];
    const auto lacking = std::find_if(needs.begin(), needs.end(),
                                      [&](std::size_t needed) { return causes.contains(needed); });
    if (lacking != needs.end()) {
      causes.emplace(index, *lacking);
    } else if (find_language(packages[index].xml.build_type) == nullptr) {
      causes.emplace(index, index);
    }
  }
  return causes;
}

Diagnostic left_out_warning(const LocalPackage& package, const LocalPackage& cause) {
  if (&package != &cause) {
    return Diagnostic{.code = "R2W0514",
                      .severity = Severity::kWarning,
                      .message = "package `" + package.xml.name.value +
                                 "` is left out: it needs `" + cause.xml.name.value +
                                 "`, which is left out",
                      .span = package.xml.name.span};
  }
  const std::string& type = package.xml.build_type;
  const std::string why = type.empty()
                              ? "its package.xml names no build type"
                              : "packages of build type `" + type + "` are not built for sites";
  return Diagnostic{.code = "R2W0514",
                    .severity = Severity::kWarning,
                    .message = "package `" + package.xml.name.value + "` is left out: " + why,
                    .span = package.xml.name.span,
                    .why = {"build types that are: " + name_list(known_build_types())}};
}

}  // namespace ros2wasm
