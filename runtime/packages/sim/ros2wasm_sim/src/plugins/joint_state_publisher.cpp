// JointStatePublisher of Gazebo Sim: all joints of a model, or those that are named.
#include <sensor_msgs/msg/joint_state.hpp>

#include <algorithm>

#include "checks/model_checks.hpp"
#include "plugins/gz_topics.hpp"

namespace ros2wasm_sim {
namespace {

class JointStatePublisher final : public System {
 public:
  explicit JointStatePublisher(const PluginContext& context)
      : physics_(context.physics()),
        rate_(Parameters(context.plugin.xml).number("update_rate", 0)) {
    const Parameters given(context.plugin.xml);
    const std::vector<std::string> wanted = given.all("joint_name");
    const std::string& model = context.model->name;
    for (const std::string& name : wanted)
      if (std::none_of(context.model->joints.begin(), context.model->joints.end(),
                       [&](const Joint& joint) { return joint.name == name; }))
        RCLCPP_ERROR(context.host.node()->get_logger(), "Joint with name[%s] not found.%s",
                     name.c_str(), nearest_joint(*context.model, name).c_str());
    for (const Joint& joint : context.model->joints) {
      if (!wanted.empty() && std::find(wanted.begin(), wanted.end(), joint.name) == wanted.end())
        continue;
      // Fixed joints have no handle: they are at 0, and upstream publishes them too.
      joints_.push_back(physics_.joint(model, joint.name));
      message_.name.push_back(joint.name);
    }
    message_.position.resize(joints_.size());
    message_.velocity.resize(joints_.size());
    message_.effort.resize(joints_.size());
    publisher_ = publish_gz<sensor_msgs::msg::JointState>(
        context.host,
        topic_of(given, "topic",
                 "/world/" + context.simulation.world().name + "/model/" + model + "/joint_state"));
  }

  void after_step(const Now& now) override {
    if (!rate_.due(now.time_ns) || publisher_->get_subscription_count() == 0) return;
    message_.header.stamp = stamp_of(now.time_ns);
    for (std::size_t i = 0; i < joints_.size(); ++i) {
      message_.position[i] = physics_.position(joints_[i]);
      message_.velocity[i] = physics_.velocity(joints_[i]);
      message_.effort[i] = physics_.effort(joints_[i]);
    }
    publisher_->publish(message_);
  }

  void on_reset() override { rate_.reset(); }

 private:
  Physics& physics_;
  Rate rate_;
  std::vector<JointHandle> joints_;
  sensor_msgs::msg::JointState message_;
  rclcpp::Publisher<sensor_msgs::msg::JointState>::SharedPtr publisher_;
};

}  // namespace

std::unique_ptr<System> make_joint_state_publisher(const PluginContext& context) {
  return std::make_unique<JointStatePublisher>(context);
}

}  // namespace ros2wasm_sim
