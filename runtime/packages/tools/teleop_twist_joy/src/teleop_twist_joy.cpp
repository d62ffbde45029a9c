// Drives by a gamepad: sensor_msgs/msg/Joy becomes a velocity.
#include <map>
#include <memory>
#include <optional>
#include <rclcpp/rclcpp.hpp>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "geometry_msgs/msg/twist.hpp"
#include "geometry_msgs/msg/twist_stamped.hpp"
#include "joy_mapping.hpp"
#include "rclcpp_components/register_node_macro.hpp"
#include "sensor_msgs/msg/joy.hpp"

namespace teleop_twist_joy {

class TeleopTwistJoy : public rclcpp::Node {
 public:
  explicit TeleopTwistJoy(const rclcpp::NodeOptions& options)
      : Node("teleop_twist_joy_node", options) {
    is_stamped_ = declare_parameter("publish_stamped_twist", false);
    frame_ = declare_parameter("frame", "teleop_twist_joy");
    if (is_stamped_) {
      stamped_ = create_publisher<geometry_msgs::msg::TwistStamped>("cmd_vel", 10);
    } else {
      plain_ = create_publisher<geometry_msgs::msg::Twist>("cmd_vel", 10);
    }
    declare("require_enable_button", mapping_.require_enable_button);
    declare("enable_button", mapping_.enable_button);
    declare("enable_turbo_button", mapping_.enable_turbo_button);
    declare("inverted_reverse", mapping_.inverted_reverse);
    for (auto& [kind, name, axis] : axes()) {
      declare("axis_" + kind + "." + name, axis->index);
      declare("scale_" + kind + "." + name, axis->scale);
      declare("scale_" + kind + "_turbo." + name, axis->turbo);
    }
    say();
    on_set_ = add_on_set_parameters_callback(
        [this](const std::vector<rclcpp::Parameter>& parameters) { return set(parameters); });
    joy_ = create_subscription<sensor_msgs::msg::Joy>(
        "joy", rclcpp::QoS(10), [this](const sensor_msgs::msg::Joy& joy) { drive(joy); });
  }

 private:
  /// A direction with the two parts of its parameters' names.
  struct NamedAxis {
    std::string kind;
    std::string name;
    Axis* axis;
  };
  using Place = std::variant<bool*, int64_t*, double*>;

  std::vector<NamedAxis> axes() {
    return {{"linear", "x", &mapping_.x},        {"linear", "y", &mapping_.y},
            {"linear", "z", &mapping_.z},        {"angular", "pitch", &mapping_.pitch},
            {"angular", "roll", &mapping_.roll}, {"angular", "yaw", &mapping_.yaw}};
  }

  template <typename T>
  void declare(const std::string& name, T& place) {
    place = declare_parameter(name, place);
    places_.emplace(name, &place);
  }

  void say() {
    const rclcpp::Logger logger = rclcpp::get_logger("TeleopTwistJoy");
    const bool has_turbo = mapping_.enable_turbo_button >= 0;
    const auto button = [](int64_t index) { return static_cast<int>(index); };
    if (mapping_.require_enable_button) {
      RCLCPP_INFO(logger, "Teleop enable button %d.", button(mapping_.enable_button));
    }
    if (has_turbo) RCLCPP_INFO(logger, "Turbo on button %d.", button(mapping_.enable_turbo_button));
    if (mapping_.inverted_reverse) RCLCPP_INFO(logger, "Teleop enable inverted reverse.");
    for (const auto& [kind, name, axis] : axes()) {
      if (axis->index == -1) continue;
      const char* title = kind == "linear" ? "Linear" : "Angular";
      RCLCPP_INFO(logger, "%s axis %s on %d at scale %f.", title, name.c_str(), button(axis->index),
                  axis->scale);
      if (!has_turbo) continue;
      RCLCPP_INFO(logger, "Turbo for %s axis %s is scale %f.", kind.c_str(), name.c_str(),
                  axis->turbo);
    }
  }

  rcl_interfaces::msg::SetParametersResult set(const std::vector<rclcpp::Parameter>& parameters) {
    for (const rclcpp::Parameter& parameter : parameters) {
      const auto found = places_.find(parameter.get_name());
      if (found == places_.end()) continue;
      std::visit(
          [&parameter](auto* place) {
            *place = parameter.get_value<std::decay_t<decltype(*place)>>();
          },
          found->second);
    }
    rcl_interfaces::msg::SetParametersResult result;
    result.successful = true;
    return result;
  }

  void drive(const sensor_msgs::msg::Joy& joy) {
    const std::optional<Velocity> velocity = pilot_.drive(mapping_, joy.axes, joy.buttons);
    if (!velocity) return;
    geometry_msgs::msg::TwistStamped message;
    message.twist.linear.x = velocity->x;
    message.twist.linear.y = velocity->y;
    message.twist.linear.z = velocity->z;
    message.twist.angular.x = velocity->roll;
    message.twist.angular.y = velocity->pitch;
    message.twist.angular.z = velocity->yaw;
    if (!is_stamped_) {
      plain_->publish(message.twist);
      return;
    }
    message.header.stamp = now();
    message.header.frame_id = frame_;
    stamped_->publish(message);
  }

  Mapping mapping_;
  Pilot pilot_;
  /// Parameters that may change, with their places in `mapping_`.
  std::map<std::string, Place> places_;
  bool is_stamped_ = false;
  std::string frame_;
  rclcpp::Publisher<geometry_msgs::msg::Twist>::SharedPtr plain_;
  rclcpp::Publisher<geometry_msgs::msg::TwistStamped>::SharedPtr stamped_;
  rclcpp::Subscription<sensor_msgs::msg::Joy>::SharedPtr joy_;
  OnSetParametersCallbackHandle::SharedPtr on_set_;
};

}  // namespace teleop_twist_joy

RCLCPP_COMPONENTS_REGISTER_NODE(teleop_twist_joy::TeleopTwistJoy)
