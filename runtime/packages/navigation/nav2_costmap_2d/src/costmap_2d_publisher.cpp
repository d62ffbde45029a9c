// See costmap_2d_publisher.hpp.
#include "nav2_costmap_2d/costmap_2d_publisher.hpp"

#include <array>
#include <utility>

#include "nav2_costmap_2d/cost_values.hpp"
#include "nav2_costmap_2d/costmap_layer.hpp"

namespace nav2_costmap_2d {
namespace {

/// The occupancy (-1 to 100) of each cost.
std::array<int8_t, 256> occupancies() {
  std::array<int8_t, 256> table{};
  for (int cost = 1; cost <= MAX_NON_OBSTACLE; ++cost) {
    table[static_cast<size_t>(cost)] = static_cast<int8_t>(1 + 97 * (cost - 1) / 251);
  }
  table[INSCRIBED_INFLATED_OBSTACLE] = 99;
  table[LETHAL_OBSTACLE] = 100;
  table[NO_INFORMATION] = -1;
  return table;
}

int8_t occupancy_of(unsigned char cost) {
  static const std::array<int8_t, 256> kTable = occupancies();
  return kTable[cost];
}

}  // namespace

Costmap2DPublisher::Costmap2DPublisher(const nav2_util::LifecycleNode::WeakPtr& parent,
                                       Costmap2D* costmap, std::string global_frame,
                                       std::string topic_name, bool always_send_full_costmap,
                                       double map_vis_z)
    : costmap_(costmap),
      global_frame_(std::move(global_frame)),
      always_send_full_costmap_(always_send_full_costmap),
      map_vis_z_(map_vis_z),
      x0_(costmap->getSizeInCellsX()),
      y0_(costmap->getSizeInCellsY()) {
  const auto node = parent.lock();
  clock_ = node->get_clock();
  const auto latched = rclcpp::QoS(rclcpp::KeepLast(1)).transient_local().reliable();
  costmap_pub_ = node->create_publisher<Grid>(topic_name, latched);
  costmap_raw_pub_ = node->create_publisher<Costs>(topic_name + "_raw", latched);
  costmap_update_pub_ = node->create_publisher<GridUpdate>(topic_name + "_updates", latched);
  costmap_raw_update_pub_ =
      node->create_publisher<CostsUpdate>(topic_name + "_raw_updates", latched);
  using Service = nav2_msgs::srv::GetCostmap;
  costmap_service_ = node->create_service<Service>(
      std::string("get_") + topic_name,
      [this](const std::shared_ptr<rmw_request_id_t>, const std::shared_ptr<Service::Request>,
             const std::shared_ptr<Service::Response> response) {
        const std::unique_lock<Costmap2D::mutex_t> lock(*costmap_->getMutex());
        response->map = *prepareCostmap();
      });
}

Costmap2DPublisher::~Costmap2DPublisher() = default;

void Costmap2DPublisher::on_activate() {
  costmap_pub_->on_activate();
  costmap_update_pub_->on_activate();
  costmap_raw_pub_->on_activate();
  costmap_raw_update_pub_->on_activate();
  active_ = true;
}

void Costmap2DPublisher::on_deactivate() {
  costmap_pub_->on_deactivate();
  costmap_update_pub_->on_deactivate();
  costmap_raw_pub_->on_deactivate();
  costmap_raw_update_pub_->on_deactivate();
  active_ = false;
}

bool Costmap2DPublisher::isMoved() const {
  return grid_resolution_ != costmap_->getResolution() ||
         grid_width_ != costmap_->getSizeInCellsX() ||
         grid_height_ != costmap_->getSizeInCellsY() || saved_origin_x_ != costmap_->getOriginX() ||
         saved_origin_y_ != costmap_->getOriginY();
}

void Costmap2DPublisher::rememberPlace() {
  grid_resolution_ = costmap_->getResolution();
  grid_width_ = costmap_->getSizeInCellsX();
  grid_height_ = costmap_->getSizeInCellsY();
  saved_origin_x_ = costmap_->getOriginX();
  saved_origin_y_ = costmap_->getOriginY();
}

std::unique_ptr<Costmap2DPublisher::Grid> Costmap2DPublisher::prepareGrid() const {
  auto grid = std::make_unique<Grid>();
  grid->header.frame_id = global_frame_;
  grid->header.stamp = clock_->now();
  grid->info.resolution = static_cast<float>(costmap_->getResolution());
  grid->info.width = costmap_->getSizeInCellsX();
  grid->info.height = costmap_->getSizeInCellsY();
  grid->info.origin.position.x = costmap_->getOriginX();
  grid->info.origin.position.y = costmap_->getOriginY();
  grid->info.origin.position.z = map_vis_z_;
  grid->info.origin.orientation.w = 1.0;
  const size_t cells = static_cast<size_t>(grid->info.width) * grid->info.height;
  grid->data.resize(cells);
  std::transform(costmap_->getCharMap(), costmap_->getCharMap() + cells, grid->data.begin(),
                 occupancy_of);
  return grid;
}

std::unique_ptr<Costmap2DPublisher::Costs> Costmap2DPublisher::prepareCostmap() const {
  auto costs = std::make_unique<Costs>();
  costs->header.frame_id = global_frame_;
  costs->header.stamp = clock_->now();
  costs->metadata.layer = "master";
  costs->metadata.update_time = costs->header.stamp;
  costs->metadata.resolution = static_cast<float>(costmap_->getResolution());
  costs->metadata.size_x = costmap_->getSizeInCellsX();
  costs->metadata.size_y = costmap_->getSizeInCellsY();
  costs->metadata.origin.position.x = costmap_->getOriginX();
  costs->metadata.origin.position.y = costmap_->getOriginY();
  costs->metadata.origin.orientation.w = 1.0;
  const size_t cells = static_cast<size_t>(costs->metadata.size_x) * costs->metadata.size_y;
  costs->data.assign(costmap_->getCharMap(), costmap_->getCharMap() + cells);
  return costs;
}

std::unique_ptr<Costmap2DPublisher::GridUpdate> Costmap2DPublisher::createGridUpdateMsg() const {
  auto update = std::make_unique<GridUpdate>();
  update->header.stamp = clock_->now();
  update->header.frame_id = global_frame_;
  update->x = static_cast<int32_t>(x0_);
  update->y = static_cast<int32_t>(y0_);
  update->width = xn_ - x0_;
  update->height = yn_ - y0_;
  update->data.reserve(static_cast<size_t>(update->width) * update->height);
  for (unsigned int y = y0_; y < yn_; ++y) {
    for (unsigned int x = x0_; x < xn_; ++x) {
      update->data.push_back(occupancy_of(costmap_->getCost(x, y)));
    }
  }
  return update;
}

std::unique_ptr<Costmap2DPublisher::CostsUpdate> Costmap2DPublisher::createCostmapUpdateMsg()
    const {
  auto update = std::make_unique<CostsUpdate>();
  update->header.stamp = clock_->now();
  update->header.frame_id = global_frame_;
  update->x = x0_;
  update->y = y0_;
  update->size_x = xn_ - x0_;
  update->size_y = yn_ - y0_;
  update->data.reserve(static_cast<size_t>(update->size_x) * update->size_y);
  for (unsigned int y = y0_; y < yn_; ++y) {
    const unsigned char* row = costmap_->getCharMap() + costmap_->getIndex(x0_, y);
    update->data.insert(update->data.end(), row, row + update->size_x);
  }
  return update;
}

bool Costmap2DPublisher::hasNewListener() {
  const size_t before = listeners_;
  listeners_ = costmap_pub_->get_subscription_count() + costmap_raw_pub_->get_subscription_count();
  return listeners_ > before;
}

void Costmap2DPublisher::publishWhole() {
  rememberPlace();
  const bool is_first = !published_once_;
  published_once_ = true;
  if (is_first || costmap_raw_pub_->get_subscription_count() > 0) {
    costmap_raw_pub_->publish(prepareCostmap());
  }
  if (is_first || costmap_pub_->get_subscription_count() > 0) costmap_pub_->publish(prepareGrid());
}

void Costmap2DPublisher::publishChange() {
  if (costmap_update_pub_->get_subscription_count() > 0) {
    costmap_update_pub_->publish(createGridUpdateMsg());
  }
  if (costmap_raw_update_pub_->get_subscription_count() > 0) {
    costmap_raw_update_pub_->publish(createCostmapUpdateMsg());
  }
}

void Costmap2DPublisher::publishCostmap() {
  const auto* layer = dynamic_cast<CostmapLayer*>(costmap_);
  if (layer != nullptr && !layer->isEnabled()) return;
  const std::unique_lock<Costmap2D::mutex_t> lock(*costmap_->getMutex());
  // Bounds are those of the whole costmap; a layer may have another size.
  xn_ = std::min(xn_, costmap_->getSizeInCellsX());
  yn_ = std::min(yn_, costmap_->getSizeInCellsY());
  // A message that was published before somebody listened may be old.
  const bool has_new_listener = hasNewListener();
  if (always_send_full_costmap_ || !published_once_ || has_new_listener || isMoved()) {
    publishWhole();
  } else if (x0_ < xn_ && y0_ < yn_) {
    publishChange();
  }
  xn_ = yn_ = 0;
  x0_ = costmap_->getSizeInCellsX();
  y0_ = costmap_->getSizeInCellsY();
}

}  // namespace nav2_costmap_2d
