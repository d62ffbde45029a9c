// DetachableJoint of Gazebo Sim: holds a link of another model until a message lets it go.
#include <std_msgs/msg/empty.hpp>
#include <std_msgs/msg/string.hpp>

#include "plugins/gz_topics.hpp"

namespace ros2wasm_sim {
namespace {

class DetachableJoint final : public System {
 public:
  explicit DetachableJoint(const PluginContext& context)
      : simulation_(context.simulation),
        logger_(context.host.node()->get_logger()),
        model_(context.model->name) {
    const Parameters given(context.plugin.xml);
    const auto required = [&](const char* element) {
      std::string value = given.text(element, "");
      if (value.empty())
        throw PluginError("'" + std::string(element) +
                          "' is a required parameter for DetachableJoint. Failed to initialize.");
      return value;
    };
    const std::string parent = required("parent_link");
    child_model_ = required("child_model");
    child_link_ = required("child_link");
    parent_ = context.physics().link(model_, context.plugin.model_scope + parent);
    if (!parent_.valid())
      throw PluginError("Link with name " + parent + " not found in model " + model_ +
                        ". The DetachableJoint may not work as expected");
    is_quiet_ = given.flag("suppress_child_warning", false);
    const std::string prefix = "/model/" + model_ + "/detachable_joint/";
    attach_ = subscribe_gz<std_msgs::msg::Empty>(
        context.host, topic_of(given, "attach_topic", prefix + "attach"),
        [this](const std_msgs::msg::Empty&) { wants_ = true; });
    // `topic` is the older name of `detach_topic`.
    detach_ = subscribe_gz<std_msgs::msg::Empty>(
        context.host, topic_of(given, "detach_topic", topic_of(given, "topic", prefix + "detach")),
        [this](const std_msgs::msg::Empty&) { wants_ = false; });
    output_ = publish_gz<std_msgs::msg::String>(context.host,
                                                topic_of(given, "output_topic", prefix + "state"));
  }

  ~DetachableJoint() override {
    if (holds_) simulation_.physics().detach(parent_, child_);
  }

  void before_step(const Now&) override {
    if (wants_ == holds_) return;
    if (!wants_) {
      simulation_.physics().detach(parent_, child_);
    } else {
      child_ = simulation_.physics().link(child_model_ == "__model__" ? model_ : child_model_,
                                          child_link_);
      if (!child_.valid()) {  // it may be spawned later
        if (!is_quiet_)
          RCLCPP_WARN(logger_, "Child Model %s could not be found.", child_model_.c_str());
        is_quiet_ = true;
        return;
      }
      if (!simulation_.physics().attach(parent_, child_)) {
        RCLCPP_ERROR(logger_,
                     "DetachableJoint of model [%s] is not attached: the world has too "
                     "many attached links",
                     model_.c_str());
        wants_ = false;
        return;
      }
    }
    holds_ = wants_;
    std_msgs::msg::String state;
    state.data = holds_ ? "attached" : "detached";
    output_->publish(state);
  }

  void on_reset() override {
    if (holds_) simulation_.physics().detach(parent_, child_);
    holds_ = false;
    wants_ = true;
  }

 private:
  Simulation& simulation_;
  rclcpp::Logger logger_;
  std::string model_, child_model_, child_link_;
  LinkHandle parent_, child_;
  bool is_quiet_ = false;
  bool wants_ = true, holds_ = false;
  rclcpp::Subscription<std_msgs::msg::Empty>::SharedPtr attach_, detach_;
  rclcpp::Publisher<std_msgs::msg::String>::SharedPtr output_;
};

}  // namespace

std::unique_ptr<System> make_detachable_joint(const PluginContext& context) {
  return std::make_unique<DetachableJoint>(context);
}

}  // namespace ros2wasm_sim
