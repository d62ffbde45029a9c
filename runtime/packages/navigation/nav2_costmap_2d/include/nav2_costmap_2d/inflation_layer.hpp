// Costs around obstacles that fall with the distance, so that paths keep away from them.
#pragma once

#include <cmath>
#include <limits>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "nav2_costmap_2d/costmap_2d_ros.hpp"
#include "nav2_costmap_2d/layer.hpp"
#include "nav2_costmap_2d/layered_costmap.hpp"
#include "rclcpp/rclcpp.hpp"

namespace nav2_costmap_2d {

/// A cell, and the obstacle from which its cost comes.
class CellData {
 public:
  CellData(unsigned int x, unsigned int y, unsigned int sx, unsigned int sy)
      : x_(x), y_(y), src_x_(sx), src_y_(sy) {}
  unsigned int x_;
  unsigned int y_;
  unsigned int src_x_;
  unsigned int src_y_;
};

class InflationLayer : public Layer {
 public:
  typedef std::recursive_mutex mutex_t;

  InflationLayer();
  ~InflationLayer();

  void onInitialize() override;
  void updateBounds(double robot_x, double robot_y, double robot_yaw, double* min_x, double* min_y,
                    double* max_x, double* max_y) override;
  void updateCosts(Costmap2D& master_grid, int min_i, int min_j, int max_i, int max_j) override;
  void matchSize() override;
  bool isClearable() override { return false; }
  void reset() override {
    matchSize();
    current_ = false;
    need_reinflation_ = true;
  }

  /// `distance` in cells.
  inline unsigned char computeCost(double distance) const {
    if (distance == 0) return LETHAL_OBSTACLE;
    const double beyond = distance * resolution_ - inscribed_radius_;
    if (beyond <= 0) return INSCRIBED_INFLATED_OBSTACLE;
    return static_cast<unsigned char>(MAX_NON_OBSTACLE * std::exp(-cost_scaling_factor_ * beyond));
  }

  /// The layer of a costmap with this name, or the first one; null when there is none.
  static std::shared_ptr<InflationLayer> getInflationLayer(
      std::shared_ptr<Costmap2DROS>& costmap_ros, const std::string layer_name = "") {
    for (const auto& layer : *costmap_ros->getLayeredCostmap()->getPlugins()) {
      auto inflation = std::dynamic_pointer_cast<InflationLayer>(layer);
      if (inflation && (layer_name.empty() || inflation->getName() == layer_name)) {
        return inflation;
      }
    }
    return nullptr;
  }

  mutex_t* getMutex() { return access_.get(); }
  double getCostScalingFactor() { return cost_scaling_factor_; }
  double getInflationRadius() { return inflation_radius_; }

 protected:
  void onFootprintChanged() override;
  rcl_interfaces::msg::SetParametersResult dynamicParametersCallback(
      std::vector<rclcpp::Parameter> parameters);

 private:
  void computeCaches();
  unsigned int cellDistance(double world_dist) {
    return layered_costmap_->getCostmap()->cellDistance(world_dist);
  }
  void collectObstacles(const Costmap2D& master_grid, int min_i, int min_j, int max_i, int max_j);
  void enqueue(const Costmap2D& master_grid, unsigned int mx, unsigned int my, unsigned int src_x,
               unsigned int src_y);

  double inflation_radius_ = 0.0;
  double inscribed_radius_ = 0.0;
  double cost_scaling_factor_ = 0.0;
  bool inflate_unknown_ = false;
  bool inflate_around_unknown_ = false;
  unsigned int cell_inflation_radius_ = 0;
  double resolution_ = 0.0;
  // Cells to visit, by the square of their distance from the obstacle, in cells.
  std::vector<std::vector<CellData>> inflation_cells_;
  std::vector<bool> seen_;
  // By the square of the distance in cells.
  std::vector<unsigned char> cached_costs_;
  double last_min_x_ = std::numeric_limits<double>::lowest();
  double last_min_y_ = std::numeric_limits<double>::lowest();
  double last_max_x_ = std::numeric_limits<double>::max();
  double last_max_y_ = std::numeric_limits<double>::max();
  bool need_reinflation_ = false;
  std::unique_ptr<mutex_t> access_;
  rclcpp::node_interfaces::OnSetParametersCallbackHandle::SharedPtr dyn_params_handler_;
};

}  // namespace nav2_costmap_2d
