// PosePublisher of Gazebo Sim: poses of links in their model, and of the model in the world.
#include <tf2_msgs/msg/tf_message.hpp>

#include "plugins/gz_topics.hpp"
#include "plugins/messages.hpp"

namespace ros2wasm_sim {
namespace {

class PosePublisher final : public System {
 public:
  explicit PosePublisher(const PluginContext& context)
      : simulation_(context.simulation),
        model_(context.model->name),
        rate_(std::max(0.0, Parameters(context.plugin.xml).number("update_frequency", -1))) {
    const Parameters given(context.plugin.xml);
    const bool nested = given.flag("publish_nested_model_pose", false);
    publishes_links_ = given.flag("publish_link_pose", true);
    publishes_model_ = given.flag("publish_model_pose", nested);
    publisher_ = publish_gz<tf2_msgs::msg::TFMessage>(
        context.host, topic_of(given, "topic", "/model/" + model_ + "/pose"));
  }

  void after_step(const Now& now) override {
    if (!rate_.due(now.time_ns) || publisher_->get_subscription_count() == 0) return;
    const Model* model = simulation_.model(model_);
    if (model == nullptr) return;
    const auto stamp = stamp_of(now.time_ns);
    const Pose pose = simulation_.model_pose(*model);
    tf2_msgs::msg::TFMessage message;
    if (publishes_model_)
      message.transforms.push_back(
          transform_message(stamp, simulation_.world().name, model_, pose));
    if (publishes_links_)
      for (const Link& link : model->links)
        message.transforms.push_back(transform_message(
            stamp, model_, model_ + "/" + link.name,
            inverse(pose) *
                simulation_.physics().pose(simulation_.physics().link(model_, link.name))));
    publisher_->publish(message);
  }

  void on_reset() override { rate_.reset(); }

 private:
  Simulation& simulation_;
  std::string model_;
  Rate rate_;
  bool publishes_links_ = true, publishes_model_ = false;
  rclcpp::Publisher<tf2_msgs::msg::TFMessage>::SharedPtr publisher_;
};

}  // namespace

std::unique_ptr<System> make_pose_publisher(const PluginContext& context) {
  return std::make_unique<PosePublisher>(context);
}

}  // namespace ros2wasm_sim
