// See layered_costmap.hpp.
#include "nav2_costmap_2d/layered_costmap.hpp"

#include <limits>
#include <stdexcept>
#include <utility>

#include "nav2_costmap_2d/footprint.hpp"
#include "rclcpp/rclcpp.hpp"

namespace nav2_costmap_2d {
namespace {

rclcpp::Logger logger() {
  return rclcpp::get_logger("nav2_costmap_2d");
}

}  // namespace

LayeredCostmap::LayeredCostmap(std::string global_frame, bool rolling_window, bool track_unknown)
    : global_frame_(std::move(global_frame)),
      rolling_window_(rolling_window),
      footprint_(std::make_shared<std::vector<geometry_msgs::msg::Point>>()) {
  const unsigned char value = track_unknown ? NO_INFORMATION : FREE_SPACE;
  primary_costmap_.setDefaultValue(value);
  combined_costmap_.setDefaultValue(value);
}

LayeredCostmap::~LayeredCostmap() {
  plugins_.clear();
  filters_.clear();
}

void LayeredCostmap::addPlugin(std::shared_ptr<Layer> plugin) {
  const std::unique_lock<Costmap2D::mutex_t> lock(*combined_costmap_.getMutex());
  plugins_.push_back(std::move(plugin));
}

void LayeredCostmap::addFilter(std::shared_ptr<Layer> filter) {
  const std::unique_lock<Costmap2D::mutex_t> lock(*combined_costmap_.getMutex());
  filters_.push_back(std::move(filter));
}

void LayeredCostmap::resizeMap(unsigned int size_x, unsigned int size_y, double resolution,
                               double origin_x, double origin_y, bool size_locked) {
  const std::unique_lock<Costmap2D::mutex_t> lock(*combined_costmap_.getMutex());
  size_locked_ = size_locked;
  primary_costmap_.resizeMap(size_x, size_y, resolution, origin_x, origin_y);
  combined_costmap_.resizeMap(size_x, size_y, resolution, origin_x, origin_y);
  for (const auto& plugin : plugins_) plugin->matchSize();
  for (const auto& filter : filters_) filter->matchSize();
}

bool LayeredCostmap::isOutofBounds(double robot_x, double robot_y) {
  unsigned int mx;
  unsigned int my;
  return !combined_costmap_.worldToMap(robot_x, robot_y, mx, my);
}

void LayeredCostmap::updateMap(double robot_x, double robot_y, double robot_yaw) {
  // A layer may resize the map in its own thread.
  const std::unique_lock<Costmap2D::mutex_t> lock(*combined_costmap_.getMutex());
  if (rolling_window_) {
    const double x = robot_x - combined_costmap_.getSizeInMetersX() / 2;
    const double y = robot_y - combined_costmap_.getSizeInMetersY() / 2;
    primary_costmap_.updateOrigin(x, y);
    combined_costmap_.updateOrigin(x, y);
  }
  if (isOutofBounds(robot_x, robot_y)) {
    static rclcpp::Clock clock(RCL_STEADY_TIME);
    RCLCPP_WARN_THROTTLE(logger(), clock, 5000, "Robot is out of bounds of the costmap");
  }
  if (plugins_.empty() && filters_.empty()) return;

  minx_ = miny_ = std::numeric_limits<double>::max();
  maxx_ = maxy_ = std::numeric_limits<double>::lowest();
  widenBounds(plugins_, "layer", robot_x, robot_y, robot_yaw);
  widenBounds(filters_, "filter", robot_x, robot_y, robot_yaw);

  int x0;
  int y0;
  int xn;
  int yn;
  combined_costmap_.worldToMapEnforceBounds(minx_, miny_, x0, y0);
  combined_costmap_.worldToMapEnforceBounds(maxx_, maxy_, xn, yn);
  xn = std::min(static_cast<int>(combined_costmap_.getSizeInCellsX()), xn + 1);
  yn = std::min(static_cast<int>(combined_costmap_.getSizeInCellsY()), yn + 1);
  RCLCPP_DEBUG(logger(), "Updating area x: [%d, %d] y: [%d, %d]", x0, xn, y0, yn);
  if (xn < x0 || yn < y0) return;
  writeCells(x0, y0, xn, yn);
  bx0_ = static_cast<unsigned int>(x0);
  bxn_ = static_cast<unsigned int>(xn);
  by0_ = static_cast<unsigned int>(y0);
  byn_ = static_cast<unsigned int>(yn);
  initialized_ = true;
}

void LayeredCostmap::widenBounds(const Layers& layers, const char* kind, double x, double y,
                                 double yaw) {
  for (const auto& layer : layers) {
    const double minx = minx_;
    const double miny = miny_;
    const double maxx = maxx_;
    const double maxy = maxy_;
    layer->updateBounds(x, y, yaw, &minx_, &miny_, &maxx_, &maxy_);
    if (minx_ <= minx && miny_ <= miny && maxx_ >= maxx && maxy_ >= maxy) continue;
    RCLCPP_WARN(logger(),
                "Illegal bounds change, was [tl: (%f, %f), br: (%f, %f)], but is now "
                "[tl: (%f, %f), br: (%f, %f)]. The offending %s is %s",
                minx, miny, maxx, maxy, minx_, miny_, maxx_, maxy_, kind, layer->getName().c_str());
  }
}

void LayeredCostmap::writeCells(int x0, int y0, int xn, int yn) {
  Costmap2D& costs = filters_.empty() ? combined_costmap_ : primary_costmap_;
  const unsigned int left = static_cast<unsigned int>(x0);
  const unsigned int bottom = static_cast<unsigned int>(y0);
  const unsigned int right = static_cast<unsigned int>(xn);
  const unsigned int top = static_cast<unsigned int>(yn);
  costs.resetMap(left, bottom, right, top);
  for (const auto& plugin : plugins_) plugin->updateCosts(costs, x0, y0, xn, yn);
  if (filters_.empty()) return;
  if (!combined_costmap_.copyWindow(primary_costmap_, left, bottom, right, top, left, bottom)) {
    RCLCPP_ERROR(logger(), "Can not copy costmap (%i,%i)..(%i,%i) window", x0, y0, xn, yn);
    throw std::runtime_error{"Can not copy costmap"};
  }
  for (const auto& filter : filters_) filter->updateCosts(combined_costmap_, x0, y0, xn, yn);
}

bool LayeredCostmap::isCurrent() {
  const auto is_fit = [](const std::shared_ptr<Layer>& layer) {
    return layer->isCurrent() || !layer->isEnabled();
  };
  current_ = std::all_of(plugins_.begin(), plugins_.end(), is_fit) &&
             std::all_of(filters_.begin(), filters_.end(), is_fit);
  return current_;
}

void LayeredCostmap::setFootprint(const std::vector<geometry_msgs::msg::Point>& footprint_spec) {
  const auto [inscribed, circumscribed] = calculateMinAndMaxDistances(footprint_spec);
  std::atomic_store(&footprint_,
                    std::make_shared<std::vector<geometry_msgs::msg::Point>>(footprint_spec));
  inscribed_radius_.store(inscribed);
  circumscribed_radius_.store(circumscribed);
  for (const auto& plugin : plugins_) plugin->onFootprintChanged();
  for (const auto& filter : filters_) filter->onFootprintChanged();
}

}  // namespace nav2_costmap_2d
