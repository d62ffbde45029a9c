// A costmap made of layers, from the first to the last, and of filters that follow them.
#pragma once

#include <atomic>
#include <memory>
#include <string>
#include <vector>

#include "nav2_costmap_2d/cost_values.hpp"
#include "nav2_costmap_2d/costmap_2d.hpp"
#include "nav2_costmap_2d/layer.hpp"

namespace nav2_costmap_2d {

class Layer;

class LayeredCostmap {
 public:
  /// `rolling_window`: the map moves with the robot. `track_unknown`: cells are unknown at first,
  /// not free.
  LayeredCostmap(std::string global_frame, bool rolling_window, bool track_unknown);
  ~LayeredCostmap();

  /// One round of all layers, for a pose of the robot in the global frame.
  void updateMap(double robot_x, double robot_y, double robot_yaw);
  std::string getGlobalFrameID() const { return global_frame_; }
  /// `size_locked`: a layer gave this size.
  void resizeMap(unsigned int size_x, unsigned int size_y, double resolution, double origin_x,
                 double origin_y, bool size_locked = false);
  /// The part that the last round changed, in the world.
  void getUpdatedBounds(double& minx, double& miny, double& maxx, double& maxy) {
    minx = minx_;
    miny = miny_;
    maxx = maxx_;
    maxy = maxy_;
  }
  bool isCurrent();
  Costmap2D* getCostmap() { return &combined_costmap_; }
  bool isRolling() { return rolling_window_; }
  bool isTrackingUnknown() { return combined_costmap_.getDefaultValue() == NO_INFORMATION; }
  std::vector<std::shared_ptr<Layer>>* getPlugins() { return &plugins_; }
  std::vector<std::shared_ptr<Layer>>* getFilters() { return &filters_; }
  void addPlugin(std::shared_ptr<Layer> plugin);
  void addFilter(std::shared_ptr<Layer> filter);
  bool isSizeLocked() { return size_locked_; }
  /// The part that the last round changed: columns from x0 to before xn, rows from y0 to before yn.
  void getBounds(unsigned int* x0, unsigned int* xn, unsigned int* y0, unsigned int* yn) {
    *x0 = bx0_;
    *xn = bxn_;
    *y0 = by0_;
    *yn = byn_;
  }
  bool isInitialized() { return initialized_; }
  void setFootprint(const std::vector<geometry_msgs::msg::Point>& footprint_spec);
  const std::vector<geometry_msgs::msg::Point>& getFootprint() {
    return *std::atomic_load(&footprint_);
  }
  /// The radii of the footprint around the centre of the robot.
  double getCircumscribedRadius() { return circumscribed_radius_.load(); }
  double getInscribedRadius() { return inscribed_radius_.load(); }
  bool isOutofBounds(double robot_x, double robot_y);

 private:
  using Layers = std::vector<std::shared_ptr<Layer>>;

  void widenBounds(const Layers& layers, const char* kind, double x, double y, double yaw);
  void writeCells(int x0, int y0, int xn, int yn);

  // The layers alone, where there are filters; and the result.
  Costmap2D primary_costmap_;
  Costmap2D combined_costmap_;
  std::string global_frame_;
  bool rolling_window_;
  bool current_ = false;
  double minx_ = 0.0;
  double miny_ = 0.0;
  double maxx_ = 0.0;
  double maxy_ = 0.0;
  unsigned int bx0_ = 0;
  unsigned int bxn_ = 0;
  unsigned int by0_ = 0;
  unsigned int byn_ = 0;
  Layers plugins_;
  Layers filters_;
  bool initialized_ = false;
  bool size_locked_ = false;
  std::atomic<double> circumscribed_radius_{1.0};
  std::atomic<double> inscribed_radius_{0.1};
  std::shared_ptr<std::vector<geometry_msgs::msg::Point>> footprint_;
};

}  // namespace nav2_costmap_2d
