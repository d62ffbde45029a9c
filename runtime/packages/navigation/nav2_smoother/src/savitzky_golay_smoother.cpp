// See savitzky_golay_smoother.hpp.
#include "nav2_smoother/savitzky_golay_smoother.hpp"

#include <chrono>

#include "nav2_util/node_utils.hpp"
#include "path_messages.hpp"
#include "pluginlib/class_list_macros.hpp"

namespace nav2_smoother {

using Clock = std::chrono::steady_clock;

void SavitzkyGolaySmoother::configure(const rclcpp_lifecycle::LifecycleNode::WeakPtr& parent,
                                      std::string name, std::shared_ptr<tf2_ros::Buffer>,
                                      std::shared_ptr<nav2_costmap_2d::CostmapSubscriber>,
                                      std::shared_ptr<nav2_costmap_2d::FootprintSubscriber>) {
  const auto node = parent.lock();
  logger_ = node->get_logger();
  nav2_util::declare_parameter_if_not_declared(node, name + ".do_refinement",
                                               rclcpp::ParameterValue(true));
  nav2_util::declare_parameter_if_not_declared(node, name + ".refinement_num",
                                               rclcpp::ParameterValue(2));
  node->get_parameter(name + ".do_refinement", do_refinement_);
  node->get_parameter(name + ".refinement_num", refinement_num_);
}

bool SavitzkyGolaySmoother::smooth(nav_msgs::msg::Path& path, const rclcpp::Duration& max_time) {
  const Clock::time_point start = Clock::now();
  const std::chrono::nanoseconds most(max_time.nanoseconds());
  const int64_t passes = do_refinement_ && refinement_num_ > 0 ? int64_t{1} + refinement_num_ : 1;
  smooth_parts(path, 9, [&](PathPoints& points) {
    for (int64_t pass = 0; pass < passes; ++pass) {
      if (Clock::now() - start >= most) {
        RCLCPP_WARN(logger_, "Smoothing time exceeded allowed duration of %0.2f.",
                    max_time.seconds());
        throw nav2_core::SmootherTimedOut("Smoothing time exceed allowed duration");
      }
      filter_savitzky_golay(points);
    }
  });
  return true;
}

}  // namespace nav2_smoother

PLUGINLIB_EXPORT_CLASS(nav2_smoother::SavitzkyGolaySmoother, nav2_core::Smoother)
