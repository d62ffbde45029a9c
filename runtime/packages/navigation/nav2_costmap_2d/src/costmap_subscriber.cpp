// See costmap_subscriber.hpp.
#include "nav2_costmap_2d/costmap_subscriber.hpp"

#include <algorithm>
#include <stdexcept>

namespace nav2_costmap_2d {

using nav2_msgs::msg::Costmap;
using nav2_msgs::msg::CostmapUpdate;

namespace {

constexpr size_t kUpdateDepth = 10;

}  // namespace

CostmapSubscriber::CostmapSubscriber(const nav2_util::LifecycleNode::WeakPtr& parent,
                                     const std::string& topic_name)
    : topic_name_(topic_name) {
  subscribe(parent.lock());
}

CostmapSubscriber::CostmapSubscriber(const rclcpp::Node::WeakPtr& parent,
                                     const std::string& topic_name)
    : topic_name_(topic_name) {
  subscribe(parent.lock());
}

template <typename NodeT>
void CostmapSubscriber::subscribe(const NodeT& node) {
  logger_ = node->get_logger();
  costmap_sub_ = node->template create_subscription<Costmap>(
      topic_name_, rclcpp::QoS(rclcpp::KeepLast(1)).transient_local().reliable(),
      [this](const Costmap::SharedPtr message) { costmapCallback(message); });
  costmap_update_sub_ = node->template create_subscription<CostmapUpdate>(
      // Changes build on each other: none may be lost.
      topic_name_ + "_updates", rclcpp::QoS(kUpdateDepth).transient_local().reliable(),
      [this](const CostmapUpdate::SharedPtr message) { costmapUpdateCallback(message); });
}

bool CostmapSubscriber::isCostmapReceived() {
  const std::lock_guard<std::mutex> lock(costmap_msg_mutex_);
  return costmap_ != nullptr || costmap_msg_ != nullptr;
}

std::shared_ptr<Costmap2D> CostmapSubscriber::getCostmap() {
  if (!isCostmapReceived()) throw std::runtime_error("Costmap is not available");
  {
    const std::lock_guard<std::mutex> lock(costmap_msg_mutex_);
    if (!costmap_) costmap_ = std::make_shared<Costmap2D>();
  }
  // Both at once: the caller may hold the mutex of the cells.
  const std::scoped_lock lock(costmap_msg_mutex_, *costmap_->getMutex());
  if (!costmap_msg_) return costmap_;
  const auto& data = costmap_msg_->metadata;
  const auto& origin = data.origin.position;
  if (costmap_->getSizeInCellsX() != data.size_x || costmap_->getSizeInCellsY() != data.size_y ||
      costmap_->getResolution() != data.resolution || costmap_->getOriginX() != origin.x ||
      costmap_->getOriginY() != origin.y) {
    costmap_->resizeMap(data.size_x, data.size_y, data.resolution, origin.x, origin.y);
  }
  std::copy(costmap_msg_->data.begin(), costmap_msg_->data.end(), costmap_->getCharMap());
  costmap_msg_.reset();
  return costmap_;
}

void CostmapSubscriber::costmapCallback(const Costmap::SharedPtr msg) {
  const auto& data = msg->metadata;
  if (msg->data.size() != static_cast<size_t>(data.size_x) * data.size_y ||
      !(data.resolution > 0)) {
    RCLCPP_WARN(logger_, "A costmap of the wrong size on %s is ignored.", topic_name_.c_str());
    return;
  }
  const std::lock_guard<std::mutex> lock(costmap_msg_mutex_);
  costmap_msg_ = msg;
}

void CostmapSubscriber::costmapUpdateCallback(const CostmapUpdate::SharedPtr update_msg) {
  if (!isCostmapReceived()) {
    RCLCPP_WARN(logger_, "No costmap received.");
    return;
  }
  const std::shared_ptr<Costmap2D> costmap = getCostmap();
  const std::lock_guard<Costmap2D::mutex_t> lock(*costmap->getMutex());
  const auto& update = *update_msg;
  if (static_cast<uint64_t>(update.x) + update.size_x > costmap->getSizeInCellsX() ||
      static_cast<uint64_t>(update.y) + update.size_y > costmap->getSizeInCellsY() ||
      update.data.size() < static_cast<size_t>(update.size_x) * update.size_y) {
    RCLCPP_WARN(logger_, "Update area outside of original map area. Costmap bounds: %d X %d",
                costmap->getSizeInCellsX(), costmap->getSizeInCellsY());
    return;
  }
  for (uint32_t y = 0; y < update.size_y; ++y) {
    const auto row = update.data.begin() + static_cast<ptrdiff_t>(y) * update.size_x;
    std::copy_n(row, update.size_x,
                costmap->getCharMap() + costmap->getIndex(update.x, update.y + y));
  }
}

}  // namespace nav2_costmap_2d
