// See sync.hpp.
#include "node/sync.hpp"

#include <chrono>
#include <utility>

#include "rclcpp_components/register_node_macro.hpp"

namespace slam_toolbox {

SynchronousSlamToolbox::SynchronousSlamToolbox(const rclcpp::NodeOptions& options)
    : SlamToolbox(options) {}

SlamToolbox::CallbackReturn SynchronousSlamToolbox::on_activate(
    const rclcpp_lifecycle::State& state) {
  queue_timer_ = create_wall_timer(std::chrono::milliseconds(1), [this] { add_next(); });
  queue_timer_->cancel();
  using Clear = srv::ClearQueue;
  clear_service_ = create_service<Clear>(
      "slam_toolbox/clear_queue",
      [this](const Clear::Request::SharedPtr, Clear::Response::SharedPtr response) {
        RCLCPP_INFO(get_logger(),
                    "SynchronousSlamToolbox: Clearing all queued scans to add to map.");
        drop_taken();
        response->status = true;
      });
  return SlamToolbox::on_activate(state);
}

SlamToolbox::CallbackReturn SynchronousSlamToolbox::on_deactivate(
    const rclcpp_lifecycle::State& state) {
  queue_timer_.reset();
  clear_service_.reset();
  return SlamToolbox::on_deactivate(state);
}

void SynchronousSlamToolbox::take(Scan scan) {
  if (!should_process(scan)) return;
  queue_.push_back(std::move(scan));
  queue_timer_->reset();
}

void SynchronousSlamToolbox::drop_taken() {
  const std::lock_guard<std::recursive_mutex> lock(mutex_);
  queue_.clear();
}

void SynchronousSlamToolbox::add_next() {
  const std::lock_guard<std::recursive_mutex> lock(mutex_);
  if (!queue_.empty()) {
    Scan scan = std::move(queue_.front());
    queue_.pop_front();
    if (queue_.size() > 10) {
      RCLCPP_WARN(get_logger(),
                  "Queue size has grown to: %zu. Recommend stopping until message is gone if "
                  "online mapping.",
                  queue_.size());
    }
    add(std::move(scan));
  }
  if (queue_.empty()) queue_timer_->cancel();
}

}  // namespace slam_toolbox

RCLCPP_COMPONENTS_REGISTER_NODE(slam_toolbox::SynchronousSlamToolbox)
