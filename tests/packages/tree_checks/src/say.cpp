// A node that speaks by way of a node of ROS, which it finds on the blackboard.
#include <string>

#include "behaviortree_cpp_v3/behavior_tree.h"
#include "behaviortree_cpp_v3/bt_factory.h"
#include "rclcpp/rclcpp.hpp"

namespace {

class Say : public BT::ActionNodeBase {
 public:
  Say(const std::string& xml_tag_name, const BT::NodeConfiguration& conf)
      : BT::ActionNodeBase(xml_tag_name, conf) {
    config().blackboard->get("node", node_);
  }
  static BT::PortsList providedPorts() {
    return {BT::InputPort<std::string>("text"), BT::InputPort<int>("times", 1, "how often")};
  }
  void halt() override {}
  BT::NodeStatus tick() override {
    std::string text;
    int times = 0;
    getInput("text", text);
    getInput("times", times);
    RCLCPP_INFO(node_->get_logger(), "%s %d", text.c_str(), times);
    return BT::NodeStatus::SUCCESS;
  }

 private:
  rclcpp::Node::SharedPtr node_;
};

}  // namespace

BT_REGISTER_NODES(factory) {
  const BT::NodeBuilder builder = [](const std::string& name, const BT::NodeConfiguration& config) {
    return std::make_unique<Say>(name, config);
  };
  factory.registerBuilder<Say>("Say", builder);
}
