// Adds all scans for which the robot has moved, in their order, however long it takes.
#pragma once

#include <deque>

#include "node/slam_toolbox_common.hpp"
#include "slam_toolbox/srv/clear_queue.hpp"

namespace slam_toolbox {

class SynchronousSlamToolbox : public SlamToolbox {
 public:
  explicit SynchronousSlamToolbox(const rclcpp::NodeOptions& options = rclcpp::NodeOptions());

 private:
  CallbackReturn on_activate(const rclcpp_lifecycle::State& state) override;
  CallbackReturn on_deactivate(const rclcpp_lifecycle::State& state) override;
  void take(Scan scan) override;
  void drop_taken() override;
  void add_next();

  std::deque<Scan> queue_;
  rclcpp::TimerBase::SharedPtr queue_timer_;  ///< runs while the queue has scans
  rclcpp::Service<srv::ClearQueue>::SharedPtr clear_service_;
};

}  // namespace slam_toolbox
