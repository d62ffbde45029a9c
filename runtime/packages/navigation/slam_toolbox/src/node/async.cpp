// See async.hpp.
#include "node/async.hpp"

#include <utility>

#include "rclcpp_components/register_node_macro.hpp"

namespace slam_toolbox {

AsynchronousSlamToolbox::AsynchronousSlamToolbox(const rclcpp::NodeOptions& options)
    : SlamToolbox(options) {}

void AsynchronousSlamToolbox::take(Scan scan) {
  if (!is_paused()) add(std::move(scan));
}

}  // namespace slam_toolbox

RCLCPP_COMPONENTS_REGISTER_NODE(slam_toolbox::AsynchronousSlamToolbox)
