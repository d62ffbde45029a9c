// libgazebo_ros_force.so: the last wrench that was sent acts on a link.
#include <geometry_msgs/msg/wrench.hpp>

#include "plugins/plugin.hpp"

namespace ros2wasm_sim {
namespace {

class ClassicForce final : public System {
 public:
  explicit ClassicForce(const PluginContext& context)
      : physics_(context.physics()), node_(context.host, context.plugin) {
    const Parameters given(context.plugin.xml);
    const std::string link = given.text("link_name", "");
    if (link.empty()) throw PluginError("Force plugin missing <link_name>, cannot proceed");
    link_ = physics_.link(context.model->name, context.plugin.model_scope + link);
    if (!link_.valid()) throw PluginError("Link named: " + link + " does not exist");
    is_local_ = given.text("force_frame", "world") == "link";
    subscription_ = node_->create_subscription<geometry_msgs::msg::Wrench>(
        "gazebo_ros_force", rclcpp::SystemDefaultsQoS(),
        [this](const geometry_msgs::msg::Wrench& message) {
          force_ = {message.force.x, message.force.y, message.force.z};
          torque_ = {message.torque.x, message.torque.y, message.torque.z};
        });
  }

  void before_step(const Now&) override {
    const Quaternion turned = is_local_ ? physics_.pose(link_).orientation : Quaternion{};
    physics_.add_wrench(link_, rotate(turned, force_), rotate(turned, torque_),
                        physics_.centre_of_mass(link_));
  }

  void on_reset() override { force_ = torque_ = {}; }

 private:
  Physics& physics_;
  PluginNode node_;
  LinkHandle link_;
  bool is_local_ = false;  ///< along the axes of the link; else of the world
  Vector3 force_, torque_;
  rclcpp::Subscription<geometry_msgs::msg::Wrench>::SharedPtr subscription_;
};

}  // namespace

std::unique_ptr<System> make_classic_force(const PluginContext& context) {
  return std::make_unique<ClassicForce>(context);
}

}  // namespace ros2wasm_sim
