// See wheel_watch.hpp.
#include "plugins/wheel_watch.hpp"

#include <algorithm>
#include <limits>

#include "checks/shape_extent.hpp"

namespace ros2wasm_sim {
namespace {

constexpr std::int64_t kWait = 2'000'000'000;
/// A wheel on a slope is further from the point straight below it than its radius.
constexpr double kSmallGap = 0.005, kPartOfRadius = 0.1;
constexpr double kRest = 0.02;  // m/s

}  // namespace

WheelWatch::WheelWatch(const PluginContext& context, const DrivenWheels& wheels)
    : physics_(context.physics()),
      logger_(context.host.node()->get_logger()),
      model_(context.model->name) {
  for (const std::string& remark : wheel_remarks(*context.model, wheels))
    RCLCPP_WARN(logger_, "%s", remark.c_str());
  const auto add_side = [&](const char* name, const std::vector<std::string>& joints) {
    Side side{name, {}};
    for (const std::string& joint : joints) {
      const Link* const link = wheel_of(*context.model, joint);
      if (link == nullptr || link->collisions.empty()) return;
      side.wheels.push_back({physics_.link(model_, link->name), link->collisions.front()});
    }
    sides_.push_back(std::move(side));
  };
  add_side("left", wheels.left);
  add_side("right", wheels.right);
}

std::optional<double> WheelWatch::gap_below(const Wheel& wheel) const {
  const Pose pose = physics_.pose(wheel.link) * wheel.shape.pose;
  const Vector3 down{0, 0, -1};
  const auto reach = extent(wheel.shape.geometry, pose.orientation, down);
  if (!reach || std::abs(physics_.velocity(wheel.link).linear.z) > kRest) return std::nullopt;
  std::vector<double> distances;
  physics_.cast({{pose.position, down}}, RaySees::kCollisions, wheel.link, distances);
  const double gap = distances.front() - *reach;
  return gap > kSmallGap + kPartOfRadius * *reach ? gap : 0;
}

void WheelWatch::look_at_world(std::int64_t time_ns) {
  next_ns_ = std::numeric_limits<std::int64_t>::max();
  if (!std::exchange(has_begun_, true)) {
    next_ns_ = time_ns + kWait;
    return;
  }
  for (const Side& side : sides_) {
    double least = kInfinity;
    for (const Wheel& wheel : side.wheels) least = std::min(least, gap_below(wheel).value_or(0));
    // Without anything below, the robot is not one that stands.
    if (side.wheels.empty() || !(least > 0) || least == kInfinity) continue;
    RCLCPP_WARN(logger_,
                "the wheels on the %s of [%s] do not touch the ground: there are %s m below them. "
                "Another collision of the robot is lower and carries it, or it has tipped over",
                side.name, model_.c_str(), shown(least).c_str());
    return;
  }
}

}  // namespace ros2wasm_sim
