// See voxel_grid.hpp.
#include "nav2_voxel_grid/voxel_grid.hpp"

#include <cstdio>

namespace nav2_voxel_grid {
namespace {

constexpr unsigned int kMostVoxels = 16;
/// A column of voxels that are unknown.
constexpr uint32_t kUnknownColumn = 0xFFFF;

}  // namespace

VoxelGrid::VoxelGrid(unsigned int size_x, unsigned int size_y, unsigned int size_z)
    : size_x_(0), size_y_(0), size_z_(0), logger(rclcpp::get_logger("voxel_grid")) {
  resize(size_x, size_y, size_z);
}

VoxelGrid::~VoxelGrid() = default;

void VoxelGrid::resize(unsigned int size_x, unsigned int size_y, unsigned int size_z) {
  if (size_z > kMostVoxels) {
    RCLCPP_INFO(logger, "Error, this implementation can only support up to 16 z values (%d)",
                size_z);
    size_z = kMostVoxels;
  }
  size_x_ = size_x;
  size_y_ = size_y;
  size_z_ = size_z;
  reset();
}

void VoxelGrid::reset() {
  data_.assign(static_cast<size_t>(size_x_) * size_y_, kUnknownColumn);
}

void VoxelGrid::markVoxelLine(double x0, double y0, double z0, double x1, double y1, double z1,
                              unsigned int max_length) {
  raytraceLine([this](unsigned int index, uint32_t mask) { data_[index] |= mask; }, x0, y0, z0, x1,
               y1, z1, max_length, 0);
}

void VoxelGrid::clearVoxelLine(double x0, double y0, double z0, double x1, double y1, double z1,
                               unsigned int max_length, unsigned int min_length) {
  raytraceLine([this](unsigned int index, uint32_t mask) { data_[index] &= ~mask; }, x0, y0, z0, x1,
               y1, z1, max_length, min_length);
}

void VoxelGrid::clearVoxelLineInMap(double x0, double y0, double z0, double x1, double y1,
                                    double z1, unsigned char* map_2d,
                                    unsigned int unknown_threshold, unsigned int mark_threshold,
                                    unsigned char free_cost, unsigned char unknown_cost,
                                    unsigned int max_length, unsigned int min_length) {
  if (map_2d == nullptr) {
    clearVoxelLine(x0, y0, z0, x1, y1, z1, max_length, min_length);
    return;
  }
  const auto clear = [=](unsigned int index, uint32_t mask) {
    uint32_t& column = data_[index];
    column &= ~mask;
    const uint32_t marked = column >> 16;
    const uint32_t unknown = marked ^ (column & 0xFFFF);
    if (!bitsBelowThreshold(marked, mark_threshold)) return;
    map_2d[index] = bitsBelowThreshold(unknown, unknown_threshold) ? free_cost : unknown_cost;
  };
  raytraceLine(clear, x0, y0, z0, x1, y1, z1, max_length, min_length);
}

VoxelStatus VoxelGrid::getVoxel(unsigned int x, unsigned int y, unsigned int z) {
  return getVoxel(x, y, z, size_x_, size_y_, size_z_, data_.data());
}

VoxelStatus VoxelGrid::getVoxelColumn(unsigned int x, unsigned int y,
                                      unsigned int unknown_threshold,
                                      unsigned int marked_threshold) {
  if (x >= size_x_ || y >= size_y_) return UNKNOWN;
  const uint32_t column = data_[index_of(x, y)];
  const uint32_t marked = column >> 16;
  const uint32_t unknown = marked ^ (column & 0xFFFF);
  if (!bitsBelowThreshold(marked, marked_threshold)) return MARKED;
  return bitsBelowThreshold(unknown, unknown_threshold) ? FREE : UNKNOWN;
}

void VoxelGrid::printVoxelGrid() {
  for (unsigned int z = 0; z < size_z_; ++z) {
    std::printf("Layer z = %u:\n", z);
    for (unsigned int y = 0; y < size_y_; ++y) {
      for (unsigned int x = 0; x < size_x_; ++x) {
        std::printf("%s", getVoxel(x, y, z) == MARKED ? "# " : ". ");
      }
      std::printf("\n");
    }
  }
}

void VoxelGrid::printColumnGrid() {
  std::printf("Column view:\n");
  for (unsigned int y = 0; y < size_y_; ++y) {
    for (unsigned int x = 0; x < size_x_; ++x) {
      std::printf("%s", getVoxelColumn(x, y, 16, 0) == MARKED ? "# " : ". ");
    }
    std::printf("\n");
  }
}

unsigned int VoxelGrid::sizeX() {
  return size_x_;
}

unsigned int VoxelGrid::sizeY() {
  return size_y_;
}

unsigned int VoxelGrid::sizeZ() {
  return size_z_;
}

}  // namespace nav2_voxel_grid
