// JointTrajectoryController of Gazebo Sim: joints follow the points of a trajectory by force.
#include <std_msgs/msg/float32.hpp>
#include <trajectory_msgs/msg/joint_trajectory.hpp>

#include <utility>

#include "plugins/gz_joints.hpp"
#include "plugins/trajectory_player.hpp"

namespace ros2wasm_sim {
namespace {

using trajectory_msgs::msg::JointTrajectory;

std::int64_t nanoseconds_of(const builtin_interfaces::msg::Time& time) {
  return time.sec * 1'000'000'000LL + time.nanosec;
}

class JointTrajectoryController final : public System {
 public:
  explicit JointTrajectoryController(const PluginContext& context)
      : physics_(context.physics()), logger_(context.host.node()->get_logger()) {
    const Parameters given(context.plugin.xml);
    std::vector<std::string> names = given.all("joint_name");
    if (names.empty()) names = single_axis_joints(*context.model, context.plugin.model_scope);
    const auto initial = given.each("initial_position");
    for (std::size_t i = 0; i < names.size(); ++i) {
      Follower one;
      one.name = names[i];
      one.joint = gz_joint(context, names[i]);
      one.position_pid = Pid(pid_of(given, "position_", i));
      one.velocity_pid = Pid(pid_of(given, "velocity_", i));
      if (i < initial.size()) one.initial = initial[i].own_number(0);
      one.position = one.initial;
      followers_.push_back(one);
    }
    if (followers_.empty())
      throw PluginError("Failed to initialize JointTrajectoryController plugin, model [" +
                        context.model->name + "] has no joint with one axis");
    uses_header_time_ = given.flag("use_header_start_time", false);
    const std::string topic =
        topic_of(given, "topic", "/model/" + context.model->name + "/joint_trajectory");
    subscription_ = subscribe_gz<JointTrajectory>(
        context.host, topic, [this](const JointTrajectory& message) { accept(message); });
    progress_ = publish_gz<std_msgs::msg::Float32>(context.host, topic + "_progress");
    RCLCPP_INFO(logger_,
                "[JointTrajectoryController] Subscribed to joint trajectory messages on [%s]",
                topic.c_str());
  }

  void before_step(const Now& now) override {
    if (is_new_) {
      is_new_ = false;
      std::vector<std::int64_t> times;
      for (const auto& point : trajectory_.points)
        times.push_back(point.time_from_start.sec * 1'000'000'000LL +
                        point.time_from_start.nanosec);
      player_.begin(std::move(times),
                    uses_header_time_ ? nanoseconds_of(trajectory_.header.stamp) : now.time_ns);
    }
    if (player_.advance(now.time_ns)) {
      if (!player_.is_over()) aim_at(trajectory_.points[player_.point()]);
      std_msgs::msg::Float32 message;
      message.data = static_cast<float>(player_.progress());
      progress_->publish(message);
    }
    for (Follower& one : followers_) {
      const double force =
          one.effort +
          one.position_pid.update(physics_.position(one.joint) - one.position, now.step) +
          one.velocity_pid.update(physics_.velocity(one.joint) - one.velocity, now.step);
      physics_.add_effort(one.joint, force);
    }
  }

  void on_reset() override {
    trajectory_ = JointTrajectory();
    player_ = {};
    is_new_ = false;
    for (Follower& one : followers_) {
      one.position = one.initial;
      one.velocity = one.effort = 0;
      one.position_pid.reset();
      one.velocity_pid.reset();
    }
  }

 private:
  struct Follower {
    std::string name;
    JointHandle joint;
    Pid position_pid, velocity_pid;
    double initial = 0, position = 0;  ///< rad or m
    double velocity = 0, effort = 0;
  };

  /// Those of the nested model that has the plugin, without its scope.
  static std::vector<std::string> single_axis_joints(const Model& model, const std::string& scope) {
    std::vector<std::string> names;
    for (const Joint& joint : model.joints)
      if ((joint.type == JointType::kRevolute || joint.type == JointType::kPrismatic) &&
          joint.name.compare(0, scope.size(), scope) == 0)
        names.push_back(joint.name.substr(scope.size()));
    return names;
  }

  /// The elements stand in the order of the joints.
  static PidSettings pid_of(const Parameters& given, const std::string& kind, std::size_t index) {
    const auto read = [&](const char* name, double otherwise) {
      const auto values = given.each(kind + name);
      return index < values.size() ? values[index].own_number(otherwise) : otherwise;
    };
    PidSettings settings;
    settings.p = read("p_gain", 0);
    settings.i = read("i_gain", 0);
    settings.d = read("d_gain", 0);
    settings.i_max = read("i_max", settings.i_max);
    settings.i_min = read("i_min", settings.i_min);
    settings.command_max = read("cmd_max", settings.command_max);
    settings.command_min = read("cmd_min", settings.command_min);
    settings.offset = read("cmd_offset", 0);
    return settings;
  }

  void accept(const JointTrajectory& message) {
    for (const auto& point : message.points)
      for (const auto* values : {&point.positions, &point.velocities, &point.effort})
        if (!values->empty() && values->size() != message.joint_names.size()) {
          RCLCPP_WARN(logger_,
                      "[JointTrajectoryController] a trajectory is ignored: it names %zu joints, "
                      "and a point has %zu values",
                      message.joint_names.size(), values->size());
          return;
        }
    trajectory_ = message;
    is_new_ = !message.points.empty();
  }

  void aim_at(const trajectory_msgs::msg::JointTrajectoryPoint& point) {
    for (Follower& one : followers_)
      for (std::size_t i = 0; i < trajectory_.joint_names.size(); ++i) {
        if (trajectory_.joint_names[i] != one.name) continue;
        if (!point.positions.empty()) one.position = point.positions[i];
        if (!point.velocities.empty()) one.velocity = point.velocities[i];
        if (!point.effort.empty()) one.effort = point.effort[i];
      }
  }

  Physics& physics_;
  rclcpp::Logger logger_;
  std::vector<Follower> followers_;
  bool uses_header_time_ = false, is_new_ = false;
  JointTrajectory trajectory_;
  TrajectoryPlayer player_;
  rclcpp::Subscription<JointTrajectory>::SharedPtr subscription_;
  rclcpp::Publisher<std_msgs::msg::Float32>::SharedPtr progress_;
};

}  // namespace

std::unique_ptr<System> make_joint_trajectory_controller(const PluginContext& context) {
  return std::make_unique<JointTrajectoryController>(context);
}

}  // namespace ros2wasm_sim
