// The bins of space that particles occupy, and which bins touch each other. The number of bins sets
// how many particles a filter needs; bins that touch form a cluster.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "nav2_amcl/pf/pf_vector.hpp"

namespace nav2_amcl {

class PoseBins {
 public:
  void clear();
  void insert(const pf_vector_t& pose);
  /// How many bins have a pose.
  size_t count() const { return keys_.size(); }
  /// Numbers the clusters from 0 on, and returns how many there are.
  int find_clusters();
  /// The cluster of a pose that was inserted before find_clusters().
  int cluster_of(const pf_vector_t& pose) const;

 private:
  using Key = std::array<std::int32_t, 3>;

  static Key key_of(const pf_vector_t& pose);
  static std::uint64_t packed(const Key& key);
  void label_from(size_t first, int cluster);

  std::unordered_map<std::uint64_t, std::uint32_t> index_of_;
  std::vector<Key> keys_;  // in the order of insertion, so that runs repeat
  std::vector<int> clusters_;
};

}  // namespace nav2_amcl
