// A layer with a costmap of its own, and the ways to join it to the one below.
#pragma once

#include "nav2_costmap_2d/layer.hpp"
#include "nav2_costmap_2d/layered_costmap.hpp"
#include "rclcpp/rclcpp.hpp"

namespace nav2_costmap_2d {

class CostmapLayer : public Layer, public Costmap2D {
 public:
  CostmapLayer()
      : has_extra_bounds_(false),
        extra_min_x_(1e6),
        extra_max_x_(-1e6),
        extra_min_y_(1e6),
        extra_max_y_(-1e6) {}

  bool isDiscretized() { return true; }
  virtual void matchSize();
  /// Cells become unknown: those of the rectangle, or with `invert` all others.
  virtual void clearArea(int start_x, int start_y, int end_x, int end_y, bool invert);
  /// The next round changes these too: for what was changed between two rounds.
  void addExtraBounds(double mx0, double my0, double mx1, double my1);

 protected:
  // Unknown cells of this layer leave the ones below, except in updateWithTrueOverwrite.
  void updateWithTrueOverwrite(Costmap2D& master_grid, int min_i, int min_j, int max_i, int max_j);
  void updateWithOverwrite(Costmap2D& master_grid, int min_i, int min_j, int max_i, int max_j);
  void updateWithMax(Costmap2D& master_grid, int min_i, int min_j, int max_i, int max_j);
  void updateWithMaxWithoutUnknownOverwrite(Costmap2D& master_grid, int min_i, int min_j, int max_i,
                                            int max_j);
  /// The sum is at most MAX_NON_OBSTACLE.
  void updateWithAddition(Costmap2D& master_grid, int min_i, int min_j, int max_i, int max_j);

  /// Widens bounds by a point.
  void touch(double x, double y, double* min_x, double* min_y, double* max_x, double* max_y);
  void useExtraBounds(double* min_x, double* min_y, double* max_x, double* max_y);
  /// An unknown number gives Max and a warning.
  CombinationMethod combination_method_from_int(const int value);

  bool has_extra_bounds_;

 private:
  template <typename JoinT>
  void updateEach(Costmap2D& master_grid, int min_i, int min_j, int max_i, int max_j, JoinT join);

  double extra_min_x_;
  double extra_max_x_;
  double extra_min_y_;
  double extra_max_y_;
};

}  // namespace nav2_costmap_2d
