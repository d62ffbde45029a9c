// Adds each scan when it arrives; scans that arrive meanwhile may be missed.
#pragma once

#include "node/slam_toolbox_common.hpp"

namespace slam_toolbox {

class AsynchronousSlamToolbox : public SlamToolbox {
 public:
  explicit AsynchronousSlamToolbox(const rclcpp::NodeOptions& options = rclcpp::NodeOptions());

 private:
  void take(Scan scan) override;
};

}  // namespace slam_toolbox
