// See site_budget.hpp.
#include "bundler/site_budget.hpp"

#include "bundler/io/files.hpp"
#include "bundler/plan/size_budget.hpp"

namespace ros2wasm {

Outcome<Done> keep_budget(const Manifest& manifest, const SitePlan& plan,
                          const std::filesystem::path& folder, bool write) {
  if (!manifest.site_budget.total && !manifest.site_budget.compressed) return Done{};
  const std::filesystem::path file = folder / kSizesFileName;
  std::optional<std::string> old_text;
  if (!is_absent(file)) {
    auto text = read_file(file, kMostOfText);
    if (!text) return std::move(text).errors();
    old_text = std::move(*text);
  }
  const auto before =
      old_text ? std::optional<PartSizes>(read_sizes(*old_text)) : std::optional<PartSizes>();
  if (auto over = over_budget(manifest.site_budget, plan, before)) return *std::move(over);
  std::string text = sizes_text(part_sizes(plan));
  if (!write || old_text == text) return Done{};
  return write_file(file, text);
}

}  // namespace ros2wasm
