// VelocityControl of Gazebo Sim: a model moves with a velocity along its own axes.
#include <geometry_msgs/msg/twist.hpp>

#include <optional>

#include "plugins/gz_topics.hpp"

namespace ros2wasm_sim {
namespace {

Motion motion_of(const geometry_msgs::msg::Twist& twist) {
  return {{twist.linear.x, twist.linear.y, twist.linear.z},
          {twist.angular.x, twist.angular.y, twist.angular.z}};
}

class VelocityControl final : public System {
 public:
  explicit VelocityControl(const PluginContext& context)
      : simulation_(context.simulation), model_(context.model->name) {
    const Parameters given(context.plugin.xml);
    if (given.has("initial_linear") || given.has("initial_angular"))
      initial_ = Motion{given.vector("initial_linear"), given.vector("initial_angular")};
    command_ = initial_;
    subscription_ = subscribe_gz<geometry_msgs::msg::Twist>(
        context.host, topic_of(given, "topic", "/model/" + model_ + "/cmd_vel"),
        [this](const geometry_msgs::msg::Twist& message) { command_ = motion_of(message); });
    for (const std::string& link : given.all("link_name"))
      RCLCPP_WARN(context.host.node()->get_logger(),
                  "VelocityControl of model [%s]: commands for the link [%s] are not supported; "
                  "those for the model are",
                  model_.c_str(), link.c_str());
  }

  void before_step(const Now&) override {
    const Model* model = simulation_.model(model_);
    if (model == nullptr || !command_) return;
    const Quaternion turned = simulation_.model_pose(*model).orientation;
    simulation_.physics().set_model_velocity(
        model_, {rotate(turned, command_->linear), rotate(turned, command_->angular)});
  }

  void on_reset() override { command_ = initial_; }

 private:
  Simulation& simulation_;
  std::string model_;
  std::optional<Motion> initial_, command_;  ///< along the axes of the model
  rclcpp::Subscription<geometry_msgs::msg::Twist>::SharedPtr subscription_;
};

}  // namespace

std::unique_ptr<System> make_velocity_control(const PluginContext& context) {
  return std::make_unique<VelocityControl>(context);
}

}  // namespace ros2wasm_sim
