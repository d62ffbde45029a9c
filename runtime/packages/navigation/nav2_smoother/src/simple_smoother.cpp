// See simple_smoother.hpp.
#include "nav2_smoother/simple_smoother.hpp"

#include <chrono>
#include <mutex>
#include <stdexcept>

#include "nav2_costmap_2d/cost_values.hpp"
#include "nav2_util/node_utils.hpp"
#include "path_messages.hpp"
#include "pluginlib/class_list_macros.hpp"

namespace nav2_smoother {
namespace {

using nav2_costmap_2d::Costmap2D;
using Clock = std::chrono::steady_clock;

bool is_free(const Costmap2D& costmap, const PathPoint& point) {
  unsigned int mx = 0;
  unsigned int my = 0;
  if (!costmap.worldToMap(point.x, point.y, mx, my)) return true;
  const unsigned char cost = costmap.getCost(mx, my);
  return cost <= nav2_costmap_2d::MAX_NON_OBSTACLE || cost == nav2_costmap_2d::NO_INFORMATION;
}

}  // namespace

void SimpleSmoother::configure(const rclcpp_lifecycle::LifecycleNode::WeakPtr& parent,
                               std::string name, std::shared_ptr<tf2_ros::Buffer>,
                               std::shared_ptr<nav2_costmap_2d::CostmapSubscriber> costmap_sub,
                               std::shared_ptr<nav2_costmap_2d::FootprintSubscriber>) {
  costmap_sub_ = costmap_sub;
  const auto node = parent.lock();
  logger_ = node->get_logger();
  const auto read = [&](const char* parameter, auto& value) {
    const std::string full = name + "." + parameter;
    nav2_util::declare_parameter_if_not_declared(node, full, rclcpp::ParameterValue(value));
    node->get_parameter(full, value);
  };
  tolerance_ = 1e-10;
  max_its_ = 1000;
  data_w_ = 0.2;
  smooth_w_ = 0.3;
  do_refinement_ = true;
  refinement_num_ = 2;
  read("tolerance", tolerance_);
  read("max_its", max_its_);
  read("w_data", data_w_);
  read("w_smooth", smooth_w_);
  read("do_refinement", do_refinement_);
  read("refinement_num", refinement_num_);
  // Otherwise each round moves the points further than the one before.
  if (!(data_w_ >= 0.0 && smooth_w_ >= 0.0 && data_w_ + 2 * smooth_w_ < 2.0)) {
    throw std::invalid_argument(
        name +
        ": w_data and w_smooth must not be negative, and w_data + 2 * w_smooth must be below 2");
  }
}

bool SimpleSmoother::smooth(nav_msgs::msg::Path& path, const rclcpp::Duration& max_time) {
  const std::shared_ptr<Costmap2D> costmap = costmap_sub_->getCostmap();
  const Clock::time_point start = Clock::now();
  const std::chrono::nanoseconds most(max_time.nanoseconds());
  const std::lock_guard<Costmap2D::mutex_t> lock(*costmap->getMutex());
  const RelaxationSettings settings{tolerance_, max_its_, data_w_, smooth_w_};
  // Each further pass starts from the result of the one before.
  const int64_t passes = do_refinement_ && refinement_num_ > 0 ? int64_t{1} + refinement_num_ : 1;
  smooth_parts(path, 3, [&](PathPoints& points) {
    Relaxation how = Relaxation::done;
    for (int64_t pass = 0; pass < passes && how == Relaxation::done; ++pass) {
      how = relax(
          points, settings, [&costmap](const PathPoint& point) { return is_free(*costmap, point); },
          [&] { return Clock::now() - start >= most; });
    }
    if (how == Relaxation::too_many_rounds) {
      RCLCPP_WARN(logger_, "Number of iterations has exceeded limit of %i.", max_its_);
    } else if (how == Relaxation::late) {
      RCLCPP_WARN(logger_, "Smoothing time exceeded allowed duration of %0.2f.",
                  max_time.seconds());
      throw nav2_core::SmootherTimedOut("Smoothing time exceed allowed duration");
    }
  });
  return true;
}

}  // namespace nav2_smoother

PLUGINLIB_EXPORT_CLASS(nav2_smoother::SimpleSmoother, nav2_core::Smoother)
