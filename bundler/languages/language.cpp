// The table of build types.
#include "bundler/languages/language.hpp"

#include <algorithm>
#include <array>

namespace ros2wasm {
namespace {

struct Language {
  std::string_view build_type;
  PackageBuilder* build;
};

constexpr auto kLanguages = std::to_array<Language>({
    {.build_type = "ament_cmake", .build = build_with_cmake},
    {.build_type = "ament_python", .build = build_with_setup_py},
    {.build_type = "cmake", .build = build_with_cmake},
});

}  // namespace

PackageBuilder* builder_of(std::string_view build_type) {
  const auto found = std::find_if(kLanguages.begin(), kLanguages.end(), [&](const Language& row) {
    return row.build_type == build_type;
  });
  return found == kLanguages.end() ? nullptr : found->build;
}

std::vector<std::string> known_build_types() {
  std::vector<std::string> names;
  for (const Language& row : kLanguages) names.emplace_back(row.build_type);
  return names;
}

}  // namespace ros2wasm
