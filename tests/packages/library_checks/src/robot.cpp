// A robot's description, and its frames as robot_state_publisher, joint_state_publisher and
// static_transform_publisher tell them, which stand beside this program in the site.

// Compatibility, works: urdf (`urdf::Model`); `robot_state_publisher`, program and component, with
// its parameters also when they change; `joint_state_publisher` (in C++) with its parameters,
// sources, mimic joints and limits; `static_transform_publisher`

#include <cmath>
#include <memory>
#include <string>

#include "checks.hpp"
#include "geometry_msgs/msg/transform_stamped.hpp"
#include "rclcpp/rclcpp.hpp"
#include "sensor_msgs/msg/joint_state.hpp"
#include "std_msgs/msg/string.hpp"
#include "tf2/utils.h"
#include "tf2_ros/buffer.h"
#include "tf2_ros/transform_listener.h"
#include "urdf/model.h"

using std::chrono_literals::operator""ms;
using std::chrono_literals::operator""s;

namespace {

void check_model(Checks& checks, const std::string& description) {
  urdf::Model model;
  CHECK(model.initString(description));
  CHECK(model.getName() == "arm" && model.getRoot()->name == "base");
  CHECK(model.links_.size() == 6 && model.joints_.size() == 5);
  const auto elbow = model.getJoint("elbow");
  CHECK(elbow->type == urdf::Joint::REVOLUTE && elbow->limits->upper == 2.0);
  CHECK(elbow->parent_link_name == "upper" && elbow->axis.y == 1);
  CHECK(model.getJoint("wheel")->mimic->multiplier == 2 && !model.getJoint("nothing"));
  const auto base = model.getLink("base");
  CHECK(base->inertial->mass == 2.5 && base->child_links.size() == 1);
  CHECK(base->visual->geometry->type == urdf::Geometry::BOX);
  CHECK(base->visual->material->color.g == 0.5F && base->visual_array.size() == 1);
  CHECK(model.getLink("upper")->getParent()->name == "column");

  urdf::Model none;
  CHECK(!none.initString("<robot name='x'><link name='a'/><link name='b'/></robot>"));
  CHECK(!none.initString("<robot name='x'><link name='a'>") && none.links_.empty());
  CHECK(!none.initFile("/nowhere.urdf"));
}

class Robot : public rclcpp::Node {
 public:
  explicit Robot(Checks& shared) : Node("robot"), checks(shared), buffer_(get_clock()) {
    told_ = create_publisher<sensor_msgs::msg::JointState>("told", 10);
    description_ = create_subscription<std_msgs::msg::String>(
        "robot_description", rclcpp::QoS(1).transient_local(),
        [this](const std_msgs::msg::String& message) { text_ = message.data; });
    states_ = create_subscription<sensor_msgs::msg::JointState>(
        "joint_states", 10,
        [this](const sensor_msgs::msg::JointState::ConstSharedPtr state) { last_ = state; });
  }

  void check() {
    wait_for([this] { return !text_.empty() && last_ != nullptr; });
    check_model(checks, text_);
    CHECK((last_->name == std::vector<std::string>{"shoulder", "elbow", "slide", "wheel"}));
    // zeros.elbow, the middle of limits without zero, a joint that follows.
    CHECK((last_->position == std::vector<double>{0, 0.5, (0.2 + 0.4) / 2, 1.1}));
    CHECK(last_->velocity.size() == 4 && last_->effort.empty());

    wait_for([this] { return buffer_.canTransform("base", "hand", tf2::TimePointZero); });
    auto seen = transform("base", "hand");
    // 0.5 up, 0.1 up, 1 ahead, then 0.3 ahead and down by the elbow.
    CHECK(std::abs(seen.translation.x - 1 - 0.3 * std::cos(0.5)) < 1e-9);
    CHECK(std::abs(seen.translation.z - 0.6 + 0.3 * std::sin(0.5)) < 1e-9);
    CHECK(std::abs(tf2::getYaw(transform("column", "rim").rotation) - 1.1) < 1e-9);

    // What static_transform_publisher tells by its command line.
    wait_for([this] { return buffer_.canTransform("map", "base", tf2::TimePointZero); });
    const auto base = transform("map", "base");
    CHECK(base.translation.x == 2 && std::abs(tf2::getYaw(base.rotation) - M_PI_2) < 1e-9);

    sensor_msgs::msg::JointState bent;
    bent.name = {"elbow"};
    bent.position = {M_PI_2};
    told_->publish(bent);
    wait_for([this] { return std::abs(transform("base", "hand").translation.x - 1) < 1e-9; });
    seen = transform("base", "hand");
    CHECK(std::abs(seen.translation.z - 0.3) < 1e-9);
    check_parameters();
  }

 private:
  void check_parameters() {
    const auto parameters = std::make_shared<rclcpp::SyncParametersClient>(this->shared_from_this(),
                                                                           "robot_state_publisher");
    CHECK(parameters->wait_for_service(10s));
    const auto refused = parameters->set_parameters_atomically(
        {rclcpp::Parameter("robot_description", "<robot name='broken'>")});
    CHECK(!refused.successful &&
          refused.reason == "Unable to initialize urdf::model from robot description");
    const auto too_often =
        parameters->set_parameters_atomically({rclcpp::Parameter("publish_frequency", 2000.0)});
    CHECK(!too_often.successful);

    std::string higher = text_;
    higher.replace(higher.find("0 0 0.5"), 7, "0 0 1.5");
    CHECK(parameters->set_parameters_atomically({rclcpp::Parameter("robot_description", higher)})
              .successful);
    wait_for([&] { return text_ == higher; });
    wait_for([this] { return transform("base", "column").translation.z == 1.5; });
    CHECK(text_ == higher);
    CHECK(parameters->set_parameters_atomically({rclcpp::Parameter("frame_prefix", "left/")})
              .successful);
    wait_for(
        [this] { return buffer_.canTransform("left/column", "left/upper", tf2::TimePointZero); });
    CHECK(rclcpp::ok());
  }

  template <typename ConditionT>
  void wait_for(ConditionT condition) {
    while (rclcpp::ok() && !condition()) {
      rclcpp::spin_some(shared_from_this());
      rclcpp::sleep_for(5ms);
    }
  }
  geometry_msgs::msg::Transform transform(const char* target, const char* source) {
    return buffer_.lookupTransform(target, source, tf2::TimePointZero).transform;
  }

  Checks& checks;
  tf2_ros::Buffer buffer_;
  tf2_ros::TransformListener listener_{buffer_};
  rclcpp::Publisher<sensor_msgs::msg::JointState>::SharedPtr told_;
  rclcpp::Subscription<std_msgs::msg::String>::SharedPtr description_;
  rclcpp::Subscription<sensor_msgs::msg::JointState>::SharedPtr states_;
  std::string text_;
  sensor_msgs::msg::JointState::ConstSharedPtr last_;
};

}  // namespace

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  Checks checks("robot");
  std::make_shared<Robot>(checks)->check();
  return checks.finish();
}
