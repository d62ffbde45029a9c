// See inflation_layer.hpp.
#include "nav2_costmap_2d/inflation_layer.hpp"

#include <algorithm>
#include <stdexcept>

#include "pluginlib/class_list_macros.hpp"

PLUGINLIB_EXPORT_CLASS(nav2_costmap_2d::InflationLayer, nav2_costmap_2d::Layer)

namespace nav2_costmap_2d {

using Lock = std::lock_guard<Costmap2D::mutex_t>;

InflationLayer::InflationLayer() : access_(std::make_unique<mutex_t>()) {}

InflationLayer::~InflationLayer() {
  dyn_params_handler_.reset();
}

void InflationLayer::onInitialize() {
  declareParameter("enabled", rclcpp::ParameterValue(true));
  declareParameter("inflation_radius", rclcpp::ParameterValue(0.55));
  declareParameter("cost_scaling_factor", rclcpp::ParameterValue(10.0));
  declareParameter("inflate_unknown", rclcpp::ParameterValue(false));
  declareParameter("inflate_around_unknown", rclcpp::ParameterValue(false));
  {
    const auto node = node_.lock();
    if (!node) throw std::runtime_error{"Failed to lock node"};
    node->get_parameter(getFullName("enabled"), enabled_);
    node->get_parameter(getFullName("inflation_radius"), inflation_radius_);
    node->get_parameter(getFullName("cost_scaling_factor"), cost_scaling_factor_);
    node->get_parameter(getFullName("inflate_unknown"), inflate_unknown_);
    node->get_parameter(getFullName("inflate_around_unknown"), inflate_around_unknown_);
    dyn_params_handler_ =
        node->add_on_set_parameters_callback([this](std::vector<rclcpp::Parameter> parameters) {
          return dynamicParametersCallback(parameters);
        });
  }
  current_ = true;
  need_reinflation_ = false;
  InflationLayer::matchSize();
}

void InflationLayer::matchSize() {
  const Lock lock(*getMutex());
  const Costmap2D* costmap = layered_costmap_->getCostmap();
  resolution_ = costmap->getResolution();
  cell_inflation_radius_ = cellDistance(inflation_radius_);
  computeCaches();
  seen_.assign(static_cast<size_t>(costmap->getSizeInCellsX()) * costmap->getSizeInCellsY(), false);
}

void InflationLayer::computeCaches() {
  const size_t radius = cell_inflation_radius_;
  cached_costs_.clear();
  for (size_t square = 0; square <= radius * radius; ++square) {
    cached_costs_.push_back(computeCost(std::sqrt(static_cast<double>(square))));
  }
  inflation_cells_.assign(cached_costs_.size(), {});
}

void InflationLayer::onFootprintChanged() {
  const Lock lock(*getMutex());
  inscribed_radius_ = layered_costmap_->getInscribedRadius();
  cell_inflation_radius_ = cellDistance(inflation_radius_);
  computeCaches();
  need_reinflation_ = true;
  if (inflation_radius_ < inscribed_radius_) {
    RCLCPP_ERROR(logger_,
                 "The configured inflation radius (%.3f) is smaller than the computed inscribed "
                 "radius (%.3f) of your footprint, it is highly recommended to set inflation "
                 "radius to be at least as big as the inscribed radius to avoid collisions",
                 inflation_radius_, inscribed_radius_);
  }
}

void InflationLayer::updateBounds(double, double, double, double* min_x, double* min_y,
                                  double* max_x, double* max_y) {
  const Lock lock(*getMutex());
  if (need_reinflation_) {
    last_min_x_ = *min_x;
    last_min_y_ = *min_y;
    last_max_x_ = *max_x;
    last_max_y_ = *max_y;
    *min_x = *min_y = std::numeric_limits<double>::lowest();
    *max_x = *max_y = std::numeric_limits<double>::max();
    need_reinflation_ = false;
    return;
  }
  // Costs that the last round gave around its changes may go.
  const double minx = std::min(last_min_x_, *min_x);
  const double miny = std::min(last_min_y_, *min_y);
  const double maxx = std::max(last_max_x_, *max_x);
  const double maxy = std::max(last_max_y_, *max_y);
  last_min_x_ = *min_x;
  last_min_y_ = *min_y;
  last_max_x_ = *max_x;
  last_max_y_ = *max_y;
  *min_x = minx - inflation_radius_;
  *min_y = miny - inflation_radius_;
  *max_x = maxx + inflation_radius_;
  *max_y = maxy + inflation_radius_;
}

void InflationLayer::collectObstacles(const Costmap2D& master_grid, int min_i, int min_j, int max_i,
                                      int max_j) {
  for (auto& cells : inflation_cells_) cells.clear();
  // Obstacles outside of the part count as far as their costs reach into it.
  const int radius = static_cast<int>(cell_inflation_radius_);
  const int left = std::max(0, min_i - radius);
  const int bottom = std::max(0, min_j - radius);
  const int right = std::min(static_cast<int>(master_grid.getSizeInCellsX()), max_i + radius);
  const int top = std::min(static_cast<int>(master_grid.getSizeInCellsY()), max_j + radius);
  for (int j = bottom; j < top; ++j) {
    for (int i = left; i < right; ++i) {
      const auto x = static_cast<unsigned int>(i);
      const auto y = static_cast<unsigned int>(j);
      const unsigned char cost = master_grid.getCost(x, y);
      if (cost == LETHAL_OBSTACLE || (inflate_around_unknown_ && cost == NO_INFORMATION)) {
        inflation_cells_[0].emplace_back(x, y, x, y);
      }
    }
  }
}

void InflationLayer::enqueue(const Costmap2D& master_grid, unsigned int mx, unsigned int my,
                             unsigned int src_x, unsigned int src_y) {
  if (seen_[master_grid.getIndex(mx, my)]) return;
  const size_t dx = mx > src_x ? mx - src_x : src_x - mx;
  const size_t dy = my > src_y ? my - src_y : src_y - my;
  const size_t square = dx * dx + dy * dy;
  if (square < inflation_cells_.size()) inflation_cells_[square].emplace_back(mx, my, src_x, src_y);
}

void InflationLayer::updateCosts(Costmap2D& master_grid, int min_i, int min_j, int max_i,
                                 int max_j) {
  const Lock lock(*getMutex());
  if (!enabled_ || cell_inflation_radius_ == 0) return;
  const unsigned int size_x = master_grid.getSizeInCellsX();
  const unsigned int size_y = master_grid.getSizeInCellsY();
  seen_.assign(static_cast<size_t>(size_x) * size_y, false);
  collectObstacles(master_grid, min_i, min_j, max_i, max_j);

  unsigned char* costs = master_grid.getCharMap();
  // Cells in the order of their distance: the first obstacle that reaches one is its nearest.
  for (size_t square = 0; square < inflation_cells_.size(); ++square) {
    // A cell only adds cells that are farther away.
    const std::vector<CellData> cells = std::move(inflation_cells_[square]);
    for (const CellData& cell : cells) {
      const unsigned int index = master_grid.getIndex(cell.x_, cell.y_);
      if (seen_[index]) continue;
      seen_[index] = true;
      const int i = static_cast<int>(cell.x_);
      const int j = static_cast<int>(cell.y_);
      if (i >= min_i && i < max_i && j >= min_j && j < max_j) {
        const unsigned char cost = cached_costs_[square];
        const bool replaces_unknown =
            inflate_unknown_ ? cost > FREE_SPACE : cost >= INSCRIBED_INFLATED_OBSTACLE;
        if (costs[index] == NO_INFORMATION) {
          if (replaces_unknown) costs[index] = cost;
        } else {
          costs[index] = std::max(costs[index], cost);
        }
      }
      if (cell.x_ > 0) enqueue(master_grid, cell.x_ - 1, cell.y_, cell.src_x_, cell.src_y_);
      if (cell.y_ > 0) enqueue(master_grid, cell.x_, cell.y_ - 1, cell.src_x_, cell.src_y_);
      if (cell.x_ + 1 < size_x) {
        enqueue(master_grid, cell.x_ + 1, cell.y_, cell.src_x_, cell.src_y_);
      }
      if (cell.y_ + 1 < size_y) {
        enqueue(master_grid, cell.x_, cell.y_ + 1, cell.src_x_, cell.src_y_);
      }
    }
  }
  current_ = true;
}

rcl_interfaces::msg::SetParametersResult InflationLayer::dynamicParametersCallback(
    std::vector<rclcpp::Parameter> parameters) {
  const Lock lock(*getMutex());
  rcl_interfaces::msg::SetParametersResult result;
  result.successful = true;
  const auto change = [this](auto& value, const auto& wanted) {
    if (value == wanted) return;
    value = wanted;
    need_reinflation_ = true;
  };
  for (const rclcpp::Parameter& parameter : parameters) {
    const std::string& name = parameter.get_name();
    if (parameter.get_type() == rclcpp::ParameterType::PARAMETER_DOUBLE) {
      if (name == getFullName("inflation_radius")) change(inflation_radius_, parameter.as_double());
      if (name == getFullName("cost_scaling_factor")) {
        change(cost_scaling_factor_, parameter.as_double());
      }
    } else if (parameter.get_type() == rclcpp::ParameterType::PARAMETER_BOOL) {
      if (name == getFullName("enabled") && enabled_ != parameter.as_bool()) {
        change(enabled_, parameter.as_bool());
        current_ = false;
      }
      if (name == getFullName("inflate_unknown")) change(inflate_unknown_, parameter.as_bool());
      if (name == getFullName("inflate_around_unknown")) {
        change(inflate_around_unknown_, parameter.as_bool());
      }
    }
  }
  if (need_reinflation_) matchSize();
  return result;
}

}  // namespace nav2_costmap_2d
