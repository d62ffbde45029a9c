// A node with one of each: topics, a service, an action that counts, parameters with and without limits.
#include "example_interfaces/action/fibonacci.hpp"
#include "example_interfaces/srv/add_two_ints.hpp"
#include "geometry_msgs/msg/point_stamped.hpp"
#include "rclcpp/rclcpp.hpp"
#include "rclcpp_action/rclcpp_action.hpp"
#include "std_msgs/msg/string.hpp"

using example_interfaces::srv::AddTwoInts;
using Fibonacci = example_interfaces::action::Fibonacci;
using Handle = rclcpp_action::ServerGoalHandle<Fibonacci>;

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto node = std::make_shared<rclcpp::Node>("robot");

  auto chatter = node->create_publisher<std_msgs::msg::String>("chatter", 10);
  auto place = node->create_publisher<geometry_msgs::msg::PointStamped>("place", rclcpp::SensorDataQoS());
  auto map = node->create_publisher<std_msgs::msg::String>("map", rclcpp::QoS(1).transient_local());
  std_msgs::msg::String drawn;
  drawn.data = "the map";
  map->publish(drawn);
  int count = 0;
  auto talk = node->create_wall_timer(std::chrono::milliseconds(50), [&] {
    std_msgs::msg::String text;
    text.data = "Hello World: " + std::to_string(++count);
    chatter->publish(text);
    geometry_msgs::msg::PointStamped point;
    point.header.stamp = node->now();
    point.header.frame_id = "map";
    point.point.x = 0.5;
    point.point.y = 2.0;
    place->publish(point);
  });
  auto words = node->create_subscription<std_msgs::msg::String>("words", 10, [&](const std_msgs::msg::String & text) {
    RCLCPP_INFO(node->get_logger(), "heard [%s]", text.data.c_str());
  });

  auto adder = node->create_service<AddTwoInts>(
    "add_two_ints", [](const AddTwoInts::Request::SharedPtr request, AddTwoInts::Response::SharedPtr response) {
      response->sum = request->a + request->b;
    });

  std::shared_ptr<Handle> active;
  auto counted = std::make_shared<Fibonacci::Result>();
  auto counting = rclcpp_action::create_server<Fibonacci>(
    node, "fibonacci",
    [](const rclcpp_action::GoalUUID &, std::shared_ptr<const Fibonacci::Goal> goal) {
      return goal->order < 0 ? rclcpp_action::GoalResponse::REJECT : rclcpp_action::GoalResponse::ACCEPT_AND_EXECUTE;
    },
    [](const std::shared_ptr<Handle>) {return rclcpp_action::CancelResponse::ACCEPT;},
    [&](const std::shared_ptr<Handle> handle) {
      active = handle;
      counted = std::make_shared<Fibonacci::Result>();
      counted->sequence = {0, 1};
    });
  auto work = node->create_wall_timer(std::chrono::milliseconds(5), [&] {
    if (!active) {return;}
    if (active->is_canceling()) {
      active->canceled(counted);
      RCLCPP_INFO(node->get_logger(), "goal canceled");
      active.reset();
      return;
    }
    auto & sequence = counted->sequence;
    if (sequence.size() > static_cast<std::size_t>(active->get_goal()->order)) {
      active->succeed(counted);
      active.reset();
      return;
    }
    if (sequence.size() < 40) {sequence.push_back(sequence[sequence.size() - 1] + sequence[sequence.size() - 2]);}
    auto feedback = std::make_shared<Fibonacci::Feedback>();
    feedback->sequence = sequence;
    active->publish_feedback(feedback);
  });

  rcl_interfaces::msg::ParameterDescriptor speed;
  speed.description = "How fast it may go";
  speed.floating_point_range.resize(1);
  speed.floating_point_range[0].from_value = 0.0;
  speed.floating_point_range[0].to_value = 2.0;
  node->declare_parameter("speed", 1.5, speed);
  node->declare_parameter("arm.joints", std::vector<std::string>{"base", "elbow"});
  node->declare_parameter("arm.lengths", std::vector<double>{1.0, 0.5});
  node->declare_parameter("label", "blue");

  rclcpp::spin(node);
  rclcpp::shutdown();
  return 0;
}
