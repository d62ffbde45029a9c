// Columns of up to 16 voxels over a grid of cells. A column is 32 bits: the lower half has a bit
// for each voxel that is not known to be free, the upper half for each that is marked.
#pragma once

#include <algorithm>
#include <climits>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <vector>

#include "rclcpp/rclcpp.hpp"

namespace nav2_voxel_grid {

enum VoxelStatus {
  FREE = 0,
  UNKNOWN = 1,
  MARKED = 2,
};

class VoxelGrid {
 public:
  /// All voxels are unknown. `size_z` above 16 is an error, and 16 is taken.
  VoxelGrid(unsigned int size_x, unsigned int size_y, unsigned int size_z);
  ~VoxelGrid();

  void resize(unsigned int size_x, unsigned int size_y, unsigned int size_z);
  void reset();
  uint32_t* getData() { return data_.data(); }

  inline void markVoxel(unsigned int x, unsigned int y, unsigned int z) {
    if (contains(x, y, z)) data_[index_of(x, y)] |= mask_of(z);
  }
  /// Whether the column has more than `marked_threshold` marked voxels then.
  inline bool markVoxelInMap(unsigned int x, unsigned int y, unsigned int z,
                             unsigned int marked_threshold) {
    if (!contains(x, y, z)) return false;
    uint32_t& column = data_[index_of(x, y)];
    column |= mask_of(z);
    return !bitsBelowThreshold(column >> 16, marked_threshold);
  }
  inline void clearVoxel(unsigned int x, unsigned int y, unsigned int z) {
    if (contains(x, y, z)) data_[index_of(x, y)] &= ~mask_of(z);
  }
  inline void clearVoxelColumn(unsigned int index) {
    if (index < data_.size()) data_[index] = 0;
  }
  /// Whether at most so many bits are set.
  inline bool bitsBelowThreshold(unsigned int n, unsigned int bit_threshold) {
    return numBits(n) <= bit_threshold;
  }
  static inline unsigned int numBits(unsigned int n) {
    unsigned int count = 0;
    for (; n != 0; n &= n - 1) ++count;
    return count;
  }
  static VoxelStatus getVoxel(unsigned int x, unsigned int y, unsigned int z, unsigned int size_x,
                              unsigned int size_y, unsigned int size_z, const uint32_t* data) {
    if (x >= size_x || y >= size_y || z >= size_z) return UNKNOWN;
    const unsigned int bits = numBits(data[y * size_x + x] & mask_of(z));
    return bits == 0 ? FREE : bits == 1 ? UNKNOWN : MARKED;
  }

  // Lines in units of voxels. `max_length` and `min_length` as in Costmap2D::raytraceLine.
  void markVoxelLine(double x0, double y0, double z0, double x1, double y1, double z1,
                     unsigned int max_length = UINT_MAX);
  void clearVoxelLine(double x0, double y0, double z0, double x1, double y1, double z1,
                      unsigned int max_length = UINT_MAX, unsigned int min_length = 0);
  /// Cells of the map whose column has few marked and few unknown voxels then are free; those with
  /// few marked but many unknown ones are unknown.
  void clearVoxelLineInMap(double x0, double y0, double z0, double x1, double y1, double z1,
                           unsigned char* map_2d, unsigned int unknown_threshold,
                           unsigned int mark_threshold, unsigned char free_cost = 0,
                           unsigned char unknown_cost = 255, unsigned int max_length = UINT_MAX,
                           unsigned int min_length = 0);
  VoxelStatus getVoxel(unsigned int x, unsigned int y, unsigned int z);
  VoxelStatus getVoxelColumn(unsigned int x, unsigned int y, unsigned int unknown_threshold = 0,
                             unsigned int marked_threshold = 0);
  void printVoxelGrid();
  void printColumnGrid();
  unsigned int sizeX();
  unsigned int sizeY();
  unsigned int sizeZ();

 private:
  static uint32_t mask_of(unsigned int z) { return (1U << z << 16) | (1U << z); }
  bool contains(unsigned int x, unsigned int y, unsigned int z) const {
    return x < size_x_ && y < size_y_ && z < size_z_;
  }
  unsigned int index_of(unsigned int x, unsigned int y) const { return y * size_x_ + x; }

  /// Calls `at` with the index of the column and the mask of each voxel of a line.
  template <class ActionT>
  void raytraceLine(ActionT at, double x0, double y0, double z0, double x1, double y1, double z1,
                    unsigned int max_length, unsigned int min_length) {
    const double dx = x1 - x0;
    const double dy = y1 - y0;
    const double dz = z1 - z0;
    const double length = std::sqrt(dx * dx + dy * dy + dz * dz);
    if (!std::isfinite(length) || length < min_length) return;
    const double first = length > 0.0 ? min_length / length : 0.0;
    const double last = length > 0.0 ? std::min(1.0, max_length / length) : 1.0;
    if (last < first) return;
    // The longest axis advances by a voxel in each step.
    const double longest = std::max({std::abs(dx), std::abs(dy), std::abs(dz)});
    const auto steps = static_cast<unsigned int>(std::ceil((last - first) * longest));
    for (unsigned int i = 0; i <= steps; ++i) {
      const double share = steps == 0 ? first : first + (last - first) * i / steps;
      const double x = x0 + dx * share;
      const double y = y0 + dy * share;
      const double z = z0 + dz * share;
      if (x < 0 || y < 0 || z < 0) continue;
      const auto cx = static_cast<unsigned int>(x);
      const auto cy = static_cast<unsigned int>(y);
      const auto cz = static_cast<unsigned int>(z);
      if (contains(cx, cy, cz)) at(index_of(cx, cy), mask_of(cz));
    }
  }

  unsigned int size_x_;
  unsigned int size_y_;
  unsigned int size_z_;
  std::vector<uint32_t> data_;
  rclcpp::Logger logger;
};

}  // namespace nav2_voxel_grid
