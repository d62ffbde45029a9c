// See pose_bins.hpp.
#include "nav2_amcl/pf/pose_bins.hpp"

#include <algorithm>
#include <cmath>

namespace nav2_amcl {
namespace {

constexpr double kBinLength = 0.5;  // m
constexpr int kYawBins = 36;        // of 10 degrees
// 28 bits for x and y each, 8 for yaw. What is outside shares the outermost bins.
constexpr std::int32_t kMostBins = (1 << 27) - 2;
constexpr int kUnlabelled = -1;

std::int32_t bin_of(double length) {
  const double bin = std::floor(length / kBinLength);
  if (std::isnan(bin)) return 0;
  return static_cast<std::int32_t>(
      std::clamp(bin, -static_cast<double>(kMostBins), static_cast<double>(kMostBins)));
}

/// The bins of yaw are a ring, whatever number of turns the angle has.
std::int32_t yaw_bin_of(double yaw) {
  const double turns = yaw / (2 * M_PI);
  const double share = turns - std::floor(turns);
  if (!(share >= 0.0)) return 0;
  return static_cast<std::int32_t>(share * kYawBins) % kYawBins;
}

}  // namespace

void PoseBins::clear() {
  index_of_.clear();
  keys_.clear();
  clusters_.clear();
}

PoseBins::Key PoseBins::key_of(const pf_vector_t& pose) {
  return {bin_of(pose.v[0]), bin_of(pose.v[1]), yaw_bin_of(pose.v[2])};
}

std::uint64_t PoseBins::packed(const Key& key) {
  const auto x = static_cast<std::uint64_t>(key[0] + kMostBins + 1);
  const auto y = static_cast<std::uint64_t>(key[1] + kMostBins + 1);
  return x << 36U | y << 8U | static_cast<std::uint64_t>(key[2]);
}

void PoseBins::insert(const pf_vector_t& pose) {
  const Key key = key_of(pose);
  if (index_of_.emplace(packed(key), static_cast<std::uint32_t>(keys_.size())).second) {
    keys_.push_back(key);
  }
}

int PoseBins::find_clusters() {
  clusters_.assign(keys_.size(), kUnlabelled);
  int count = 0;
  for (size_t i = 0; i < keys_.size(); ++i) {
    if (clusters_[i] == kUnlabelled) label_from(i, count++);
  }
  return count;
}

void PoseBins::label_from(size_t first, int cluster) {
  std::vector<size_t> pending{first};
  clusters_[first] = cluster;
  while (!pending.empty()) {
    const Key key = keys_[pending.back()];
    pending.pop_back();
    for (int i = 0; i < 27; ++i) {
      const Key neighbour{key[0] + i / 9 - 1, key[1] + i / 3 % 3 - 1,
                          (key[2] + i % 3 - 1 + kYawBins) % kYawBins};
      const auto found = index_of_.find(packed(neighbour));
      if (found == index_of_.end() || clusters_[found->second] != kUnlabelled) continue;
      clusters_[found->second] = cluster;
      pending.push_back(found->second);
    }
  }
}

int PoseBins::cluster_of(const pf_vector_t& pose) const {
  return clusters_[index_of_.at(packed(key_of(pose)))];
}

}  // namespace nav2_amcl
