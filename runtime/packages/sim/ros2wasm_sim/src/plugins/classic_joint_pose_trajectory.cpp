// libgazebo_ros_joint_pose_trajectory.so: joints jump to the positions of a trajectory's points.
#include <trajectory_msgs/msg/joint_trajectory.hpp>

#include <optional>

#include "plugins/plugin.hpp"

namespace ros2wasm_sim {
namespace {

class ClassicJointPoseTrajectory final : public System {
 public:
  explicit ClassicJointPoseTrajectory(const PluginContext& context)
      : physics_(context.physics()),
        node_(context.host, context.plugin),
        model_(context.model->name),
        scope_(context.plugin.model_scope),
        rate_(Parameters(context.plugin.xml).number("update_rate", 100)) {
    subscription_ = node_->create_subscription<trajectory_msgs::msg::JointTrajectory>(
        "set_joint_trajectory", rclcpp::QoS(10),
        [this](const trajectory_msgs::msg::JointTrajectory& message) { accept_poses(message); });
  }

  void before_step(const Now& now) override {
    if (!rate_.due(now.time_ns) || next_ >= points_.size()) return;
    if (!begins_ns_) begins_ns_ = now.time_ns;
    if (now.time_ns < *begins_ns_) return;
    const auto& point = points_[next_++];
    for (std::size_t i = 0; i < joints_.size() && i < point.positions.size(); ++i)
      physics_.set_position(joints_[i], point.positions[i]);
    *begins_ns_ += point.time_from_start.sec * 1'000'000'000LL + point.time_from_start.nanosec;
  }

  void on_reset() override {
    rate_.reset();
    points_.clear();
    next_ = 0;
  }

 private:
  void accept_poses(const trajectory_msgs::msg::JointTrajectory& message) {
    std::vector<JointHandle> joints;
    for (const std::string& name : message.joint_names) {
      joints.push_back(physics_.joint(model_, scope_ + name));
      if (joints.back().valid()) continue;
      RCLCPP_ERROR(node_->get_logger(), "Joint [%s] not found. Trajectory not set.", name.c_str());
      return;
    }
    for (const auto& point : message.points)
      if (point.positions.size() != joints.size()) {
        RCLCPP_ERROR(node_->get_logger(),
                     "a point has %zu positions for %zu joints. Trajectory not set.",
                     point.positions.size(), joints.size());
        return;
      }
    joints_ = std::move(joints);
    points_ = message.points;
    next_ = 0;
    begins_ns_.reset();
  }

  Physics& physics_;
  PluginNode node_;
  std::string model_, scope_;
  Rate rate_;
  std::vector<JointHandle> joints_;
  std::vector<trajectory_msgs::msg::JointTrajectoryPoint> points_;
  std::size_t next_ = 0;
  std::optional<std::int64_t> begins_ns_;  ///< when the next point is set
  rclcpp::Subscription<trajectory_msgs::msg::JointTrajectory>::SharedPtr subscription_;
};

}  // namespace

std::unique_ptr<System> make_classic_joint_pose_trajectory(const PluginContext& context) {
  return std::make_unique<ClassicJointPoseTrajectory>(context);
}

}  // namespace ros2wasm_sim
