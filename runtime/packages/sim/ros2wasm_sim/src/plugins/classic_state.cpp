// libgazebo_ros_state.so, of a world: states of models and links as topics and services.
#include <gazebo_msgs/msg/link_states.hpp>
#include <gazebo_msgs/msg/model_states.hpp>
#include <gazebo_msgs/srv/get_entity_state.hpp>
#include <gazebo_msgs/srv/set_entity_state.hpp>

#include "plugins/messages.hpp"
#include "plugins/plugin.hpp"
#include "ros/classic_entities.hpp"

namespace ros2wasm_sim {
namespace {

using gazebo_msgs::srv::GetEntityState;
using gazebo_msgs::srv::SetEntityState;

geometry_msgs::msg::Twist twist_message(const Motion& motion) {
  geometry_msgs::msg::Twist message;
  message.linear = vector_message(motion.linear);
  message.angular = vector_message(motion.angular);
  return message;
}

class ClassicState final : public System {
 public:
  explicit ClassicState(const PluginContext& context)
      : simulation_(context.simulation),
        node_(context.host, context.plugin),
        rate_(Parameters(context.plugin.xml).number("update_rate", 100)) {
    models_ =
        node_->create_publisher<gazebo_msgs::msg::ModelStates>("model_states", rclcpp::QoS(10));
    links_ = node_->create_publisher<gazebo_msgs::msg::LinkStates>("link_states", rclcpp::QoS(10));
    get_ = node_->create_service<GetEntityState>(
        "get_entity_state",
        [this](const GetEntityState::Request::SharedPtr& request,
               const GetEntityState::Response::SharedPtr& response) { get(*request, *response); });
    set_ = node_->create_service<SetEntityState>(
        "set_entity_state", [this](const SetEntityState::Request::SharedPtr& request,
                                   const SetEntityState::Response::SharedPtr& response) {
          response->success = set(request->state);
        });
  }

  void after_step(const Now& now) override {
    if (!rate_.due(now.time_ns)) return;
    const bool wants_models = models_->get_subscription_count() > 0;
    const bool wants_links = links_->get_subscription_count() > 0;
    if (!wants_models && !wants_links) return;
    gazebo_msgs::msg::ModelStates models;
    gazebo_msgs::msg::LinkStates links;
    const auto add = [&](auto& message, const std::string& name) {
      Pose pose;
      Motion motion;
      find_entity(simulation_, name, pose, motion);
      message.name.push_back(name);
      message.pose.push_back(pose_message(pose));
      message.twist.push_back(twist_message(motion));
    };
    for (const Model& model : simulation_.world().models) {
      if (wants_models) add(models, model.name);
      if (wants_links)
        for (const Link& link : model.links) add(links, model.name + "::" + link.name);
    }
    if (wants_models) models_->publish(models);
    if (wants_links) links_->publish(links);
  }

  void on_reset() override { rate_.reset(); }

 private:
  void get(const GetEntityState::Request& request, GetEntityState::Response& response) {
    Pose pose, frame;
    Motion motion, frame_motion;
    if (!find_entity(simulation_, request.name, pose, motion) || is_world(request.name)) {
      RCLCPP_ERROR(node_->get_logger(), "GetEntityState: entity [%s] does not exist",
                   request.name.c_str());
      return;
    }
    if (!find_entity(simulation_, request.reference_frame, frame, frame_motion)) {
      RCLCPP_ERROR(node_->get_logger(), "GetEntityState: reference entity [%s] not found",
                   request.reference_frame.c_str());
      return;
    }
    const Quaternion back = inverse(frame.orientation);
    response.header.stamp = stamp_of(simulation_.time_ns());
    response.header.frame_id = request.reference_frame;
    response.state.name = request.name;
    response.state.reference_frame = request.reference_frame;
    response.state.pose = pose_message(inverse(frame) * pose);
    response.state.twist = twist_message({rotate(back, motion.linear - frame_motion.linear),
                                          rotate(back, motion.angular - frame_motion.angular)});
    response.success = true;
  }

  bool set(const gazebo_msgs::msg::EntityState& state) {
    Pose frame;
    Motion frame_motion;
    if (!find_entity(simulation_, state.reference_frame, frame, frame_motion)) {
      RCLCPP_ERROR(node_->get_logger(), "SetEntityState: reference entity [%s] not found",
                   state.reference_frame.c_str());
      return false;
    }
    if (scoped_link(simulation_, state.name).valid()) {
      RCLCPP_ERROR(node_->get_logger(),
                   "SetEntityState: [%s] is a link; the state of its model can be set",
                   state.name.c_str());
      return false;
    }
    Physics& physics = simulation_.physics();
    if (!physics.set_model_pose(state.name, frame * pose_of(state.pose), true)) {
      RCLCPP_ERROR(node_->get_logger(), "SetEntityState: entity [%s] does not exist",
                   state.name.c_str());
      return false;
    }
    const auto& linear = state.twist.linear;
    const auto& angular = state.twist.angular;
    physics.set_model_velocity(state.name,
                               {rotate(frame.orientation, {linear.x, linear.y, linear.z}),
                                rotate(frame.orientation, {angular.x, angular.y, angular.z})});
    return true;
  }

  Simulation& simulation_;
  PluginNode node_;
  Rate rate_;
  rclcpp::Publisher<gazebo_msgs::msg::ModelStates>::SharedPtr models_;
  rclcpp::Publisher<gazebo_msgs::msg::LinkStates>::SharedPtr links_;
  rclcpp::Service<GetEntityState>::SharedPtr get_;
  rclcpp::Service<SetEntityState>::SharedPtr set_;
};

}  // namespace

std::unique_ptr<System> make_classic_state(const PluginContext& context) {
  return std::make_unique<ClassicState>(context);
}

}  // namespace ros2wasm_sim
