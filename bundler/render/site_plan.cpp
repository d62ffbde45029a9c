// See site_plan.hpp.
#include "bundler/render/site_plan.hpp"

#include <algorithm>

namespace ros2wasm {

std::vector<PlannedFile> placed_files(const SitePlan& plan) {
  std::vector<PlannedFile> placed;
  for (const PlannedFile& file : plan.files) {
    const std::vector<std::string> places = places_of(file, plan);
    for (std::size_t i = 0; i < places.size(); ++i) {
      placed.push_back({.path = places[i],
                        .reason = {},
                        .bytes = {},
                        .sha256 = file.parts.empty() ? file.sha256 : file.parts[i].sha256});
    }
  }
  std::sort(placed.begin(), placed.end(),
            [](const PlannedFile& a, const PlannedFile& b) { return a.path < b.path; });
  return placed;
}

std::vector<std::string> places_of(const PlannedFile& file, const SitePlan& plan) {
  return site_places(file.path, file.sha256, file.kept, file.parts, plan.store);
}

std::uint64_t total_size(const SitePlan& plan) {
  std::uint64_t sum = 0;
  for (const PlannedFile& file : plan.files) sum += file.bytes.size();
  return sum;
}

std::uint64_t channel_size(const SitePlan& plan) {
  std::uint64_t sum = 0;
  for (const ChannelFile& file : plan.channel) sum += file.size;
  return sum;
}

std::uint64_t names_size(const SitePlan& plan) {
  std::uint64_t sum = 0;
  for (const PlannedFile& file : plan.files) {
    if (file.path.ends_with(".names")) sum += file.bytes.size();
  }
  return sum;
}

}  // namespace ros2wasm
