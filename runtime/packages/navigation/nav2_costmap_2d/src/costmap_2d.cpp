// See costmap_2d.hpp.
#include "nav2_costmap_2d/costmap_2d.hpp"

#include <fstream>

#include "nav2_costmap_2d/cost_values.hpp"
#include "nav2_util/occ_grid_values.hpp"

namespace nav2_costmap_2d {
namespace {

using Lock = std::unique_lock<Costmap2D::mutex_t>;

unsigned char cost_of(int8_t occupancy) {
  if (occupancy == nav2_util::OCC_GRID_UNKNOWN) return NO_INFORMATION;
  const double share = static_cast<double>(occupancy) / nav2_util::OCC_GRID_OCCUPIED;
  return static_cast<unsigned char>(std::round(share * LETHAL_OBSTACLE));
}

}  // namespace

Costmap2D::Costmap2D(unsigned int cells_size_x, unsigned int cells_size_y, double resolution,
                     double origin_x, double origin_y, unsigned char default_value)
    : access_(new mutex_t()),
      size_x_(cells_size_x),
      size_y_(cells_size_y),
      resolution_(resolution),
      origin_x_(origin_x),
      origin_y_(origin_y),
      costmap_(nullptr),
      default_value_(default_value) {
  Costmap2D::initMaps(size_x_, size_y_);
  Costmap2D::resetMaps();
}

Costmap2D::Costmap2D(const Costmap2D& map) : Costmap2D() {
  *this = map;
}

Costmap2D::Costmap2D(const nav_msgs::msg::OccupancyGrid& map)
    : Costmap2D(map.info.width, map.info.height, map.info.resolution, map.info.origin.position.x,
                map.info.origin.position.y, FREE_SPACE) {
  const size_t cells = std::min<size_t>(map.data.size(), static_cast<size_t>(size_x_) * size_y_);
  std::transform(map.data.begin(), map.data.begin() + static_cast<ptrdiff_t>(cells), costmap_,
                 cost_of);
}

Costmap2D& Costmap2D::operator=(const Costmap2D& map) {
  if (this == &map) return *this;
  deleteMaps();
  size_x_ = map.size_x_;
  size_y_ = map.size_y_;
  resolution_ = map.resolution_;
  origin_x_ = map.origin_x_;
  origin_y_ = map.origin_y_;
  default_value_ = map.default_value_;
  initMaps(size_x_, size_y_);
  std::copy_n(map.costmap_, static_cast<size_t>(size_x_) * size_y_, costmap_);
  return *this;
}

Costmap2D::Costmap2D() : Costmap2D(0, 0, 0.0, 0.0, 0.0) {}

Costmap2D::~Costmap2D() {
  Costmap2D::deleteMaps();
  delete access_;
}

void Costmap2D::deleteMaps() {
  const Lock lock(*access_);
  delete[] costmap_;
  costmap_ = nullptr;
}

void Costmap2D::initMaps(unsigned int size_x, unsigned int size_y) {
  const Lock lock(*access_);
  delete[] costmap_;
  size_x_ = size_x;
  size_y_ = size_y;
  costmap_ = new unsigned char[static_cast<size_t>(size_x) * size_y];
}

void Costmap2D::resetMaps() {
  const Lock lock(*access_);
  std::fill_n(costmap_, static_cast<size_t>(size_x_) * size_y_, default_value_);
}

void Costmap2D::resizeMap(unsigned int size_x, unsigned int size_y, double resolution,
                          double origin_x, double origin_y) {
  resolution_ = resolution;
  origin_x_ = origin_x;
  origin_y_ = origin_y;
  initMaps(size_x, size_y);
  resetMaps();
}

void Costmap2D::resetMap(unsigned int x0, unsigned int y0, unsigned int xn, unsigned int yn) {
  resetMapToValue(x0, y0, xn, yn, default_value_);
}

void Costmap2D::resetMapToValue(unsigned int x0, unsigned int y0, unsigned int xn, unsigned int yn,
                                unsigned char value) {
  const Lock lock(*access_);
  for (unsigned int y = y0; y < yn && x0 < xn; ++y) {
    std::fill_n(costmap_ + getIndex(x0, y), xn - x0, value);
  }
}

bool Costmap2D::copyCostmapWindow(const Costmap2D& map, double win_origin_x, double win_origin_y,
                                  double win_size_x, double win_size_y) {
  if (this == &map) return false;
  unsigned int x0;
  unsigned int y0;
  unsigned int xn;
  unsigned int yn;
  if (!map.worldToMap(win_origin_x, win_origin_y, x0, y0) ||
      !map.worldToMap(win_origin_x + win_size_x, win_origin_y + win_size_y, xn, yn)) {
    return false;
  }
  resizeMap(xn - x0, yn - y0, map.resolution_, win_origin_x, win_origin_y);
  copyMapRegion(map.costmap_, x0, y0, map.size_x_, costmap_, 0, 0, size_x_, size_x_, size_y_);
  return true;
}

bool Costmap2D::copyWindow(const Costmap2D& source, unsigned int sx0, unsigned int sy0,
                           unsigned int sxn, unsigned int syn, unsigned int dx0, unsigned int dy0) {
  const unsigned int width = sxn - sx0;
  const unsigned int height = syn - sy0;
  if (sxn > source.size_x_ || syn > source.size_y_ || sx0 > sxn || sy0 > syn ||
      dx0 + width > size_x_ || dy0 + height > size_y_) {
    return false;
  }
  copyMapRegion(source.costmap_, sx0, sy0, source.size_x_, costmap_, dx0, dy0, size_x_, width,
                height);
  return true;
}

unsigned char Costmap2D::getCost(unsigned int mx, unsigned int my) const {
  return costmap_[getIndex(mx, my)];
}

unsigned char Costmap2D::getCost(unsigned int index) const {
  return costmap_[index];
}

void Costmap2D::setCost(unsigned int mx, unsigned int my, unsigned char cost) {
  costmap_[getIndex(mx, my)] = cost;
}

void Costmap2D::mapToWorld(unsigned int mx, unsigned int my, double& wx, double& wy) const {
  wx = origin_x_ + (mx + 0.5) * resolution_;
  wy = origin_y_ + (my + 0.5) * resolution_;
}

bool Costmap2D::worldToMap(double wx, double wy, unsigned int& mx, unsigned int& my) const {
  const double x = (wx - origin_x_) / resolution_;
  const double y = (wy - origin_y_) / resolution_;
  // False for numbers that are not finite, too.
  if (!(x >= 0 && y >= 0 && x < size_x_ && y < size_y_)) return false;
  mx = static_cast<unsigned int>(x);
  my = static_cast<unsigned int>(y);
  return true;
}

bool Costmap2D::worldToMapContinuous(double wx, double wy, float& mx, float& my) const {
  const double x = (wx - origin_x_) / resolution_;
  const double y = (wy - origin_y_) / resolution_;
  if (!(x >= 0 && y >= 0 && x < size_x_ && y < size_y_)) return false;
  mx = static_cast<float>(x);
  my = static_cast<float>(y);
  return true;
}

void Costmap2D::worldToMapNoBounds(double wx, double wy, int& mx, int& my) const {
  mx = static_cast<int>((wx - origin_x_) / resolution_);
  my = static_cast<int>((wy - origin_y_) / resolution_);
}

void Costmap2D::worldToMapEnforceBounds(double wx, double wy, int& mx, int& my) const {
  const auto cell = [this](double offset, unsigned int size) {
    const double at = offset / resolution_;
    if (!(at > 0)) return 0;
    return static_cast<int>(std::min(at, static_cast<double>(size) - 1));
  };
  mx = cell(wx - origin_x_, size_x_);
  my = cell(wy - origin_y_, size_y_);
}

unsigned char* Costmap2D::getCharMap() const {
  return costmap_;
}

unsigned int Costmap2D::getSizeInCellsX() const {
  return size_x_;
}

unsigned int Costmap2D::getSizeInCellsY() const {
  return size_y_;
}

double Costmap2D::getSizeInMetersX() const {
  return (size_x_ - 1 + 0.5) * resolution_;
}

double Costmap2D::getSizeInMetersY() const {
  return (size_y_ - 1 + 0.5) * resolution_;
}

double Costmap2D::getOriginX() const {
  return origin_x_;
}

double Costmap2D::getOriginY() const {
  return origin_y_;
}

double Costmap2D::getResolution() const {
  return resolution_;
}

void Costmap2D::updateOrigin(double new_origin_x, double new_origin_y) {
  const int dx = static_cast<int>((new_origin_x - origin_x_) / resolution_);
  const int dy = static_cast<int>((new_origin_y - origin_y_) / resolution_);
  const int width = static_cast<int>(size_x_);
  const int height = static_cast<int>(size_y_);
  const Lock lock(*access_);
  const int left = std::clamp(dx, 0, width);
  const int bottom = std::clamp(dy, 0, height);
  const unsigned int common_x = static_cast<unsigned int>(std::clamp(dx + width, 0, width) - left);
  const unsigned int common_y =
      static_cast<unsigned int>(std::clamp(dy + height, 0, height) - bottom);
  std::vector<unsigned char> common(static_cast<size_t>(common_x) * common_y);
  copyMapRegion(costmap_, static_cast<unsigned int>(left), static_cast<unsigned int>(bottom),
                size_x_, common.data(), 0, 0, common_x, common_x, common_y);
  resetMaps();
  // The new origin is on the grid of the old one.
  origin_x_ += dx * resolution_;
  origin_y_ += dy * resolution_;
  copyMapRegion(common.data(), 0, 0, common_x, costmap_, static_cast<unsigned int>(left - dx),
                static_cast<unsigned int>(bottom - dy), size_x_, common_x, common_y);
}

bool Costmap2D::cellsOf(const std::vector<geometry_msgs::msg::Point>& polygon,
                        std::vector<MapLocation>& cells) const {
  for (const auto& corner : polygon) {
    MapLocation cell;
    if (!worldToMap(corner.x, corner.y, cell.x, cell.y)) return false;
    cells.push_back(cell);
  }
  return true;
}

bool Costmap2D::getMapRegionOccupiedByPolygon(const std::vector<geometry_msgs::msg::Point>& polygon,
                                              std::vector<MapLocation>& polygon_map_region) {
  std::vector<MapLocation> corners;
  if (!cellsOf(polygon, corners)) return false;
  convexFillCells(corners, polygon_map_region);
  return true;
}

bool Costmap2D::setConvexPolygonCost(const std::vector<geometry_msgs::msg::Point>& polygon,
                                     unsigned char cost_value) {
  std::vector<MapLocation> cells;
  if (!getMapRegionOccupiedByPolygon(polygon, cells)) return false;
  for (const MapLocation& cell : cells) setCost(cell.x, cell.y, cost_value);
  return true;
}

void Costmap2D::polygonOutlineCells(const std::vector<MapLocation>& polygon,
                                    std::vector<MapLocation>& polygon_cells) {
  PolygonOutlineCells add(*this, costmap_, polygon_cells);
  for (size_t i = 0; i < polygon.size(); ++i) {
    const MapLocation& from = polygon[i];
    const MapLocation& to = polygon[(i + 1) % polygon.size()];
    raytraceLine(add, from.x, from.y, to.x, to.y);
  }
}

void Costmap2D::convexFillCells(const std::vector<MapLocation>& polygon,
                                std::vector<MapLocation>& polygon_cells) {
  if (polygon.size() < 3) return;
  std::vector<MapLocation> outline;
  polygonOutlineCells(polygon, outline);
  std::sort(outline.begin(), outline.end(), [](const MapLocation& a, const MapLocation& b) {
    return a.x != b.x ? a.x < b.x : a.y < b.y;
  });
  // Each column from its lowest to its highest cell of the outline.
  for (auto first = outline.begin(); first != outline.end();) {
    const auto next = std::find_if(first, outline.end(),
                                   [first](const MapLocation& cell) { return cell.x != first->x; });
    for (unsigned int y = first->y; y <= std::prev(next)->y; ++y) {
      polygon_cells.push_back(MapLocation{first->x, y});
    }
    first = next;
  }
}

unsigned int Costmap2D::cellDistance(double world_dist) {
  return static_cast<unsigned int>(std::max(0.0, std::ceil(world_dist / resolution_)));
}

bool Costmap2D::saveMap(std::string file_name) {
  std::ofstream file(file_name, std::ios::binary);
  file << "P2\n" << size_x_ << '\n' << size_y_ << "\n255\n";
  for (unsigned int y = 0; y < size_y_; ++y) {
    for (unsigned int x = 0; x < size_x_; ++x) file << static_cast<int>(getCost(x, y)) << ' ';
    file << '\n';
  }
  return file.good();
}

}  // namespace nav2_costmap_2d
