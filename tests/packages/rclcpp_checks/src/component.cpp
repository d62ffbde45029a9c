// A node that is made by name, and what makes nodes by name.
#include "checks.hpp"
#include "rclcpp_components/component_manager.hpp"
#include "rclcpp_components/register_node_macro.hpp"

namespace rclcpp_checks {

class Component : public rclcpp::Node {
 public:
  explicit Component(const rclcpp::NodeOptions& options) : Node("component", options) {
    timer_ = create_wall_timer(std::chrono::milliseconds(1), [this] {
      Checks checks("component");
      CHECK(std::string(get_fully_qualified_name()) == "/component");
      rclcpp_components::ComponentManager manager;
      CHECK(manager.get_parameter("thread_num").as_int() >= 1);
      CHECK(!manager.set_parameter({"thread_num", 2}).successful);
      checks.finish();
    });
  }

 private:
  rclcpp::TimerBase::SharedPtr timer_;
};

}  // namespace rclcpp_checks

RCLCPP_COMPONENTS_REGISTER_NODE(rclcpp_checks::Component)
