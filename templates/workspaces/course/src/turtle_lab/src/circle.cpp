// Drives turtle1 in circles. Parameters: `radius`, and `speed` in units per second.
#include <chrono>
#include <memory>

#include "geometry_msgs/msg/twist.hpp"
#include "rclcpp/rclcpp.hpp"

using namespace std::chrono_literals;

class Circle : public rclcpp::Node
{
public:
  Circle()
  : Node("circle")
  {
    declare_parameter("radius", 1.0);
    declare_parameter("speed", 1.0);
    publisher_ = create_publisher<geometry_msgs::msg::Twist>("turtle1/cmd_vel", 10);
    timer_ = create_wall_timer(100ms, [this]() {drive();});
  }

private:
  void drive()
  {
    geometry_msgs::msg::Twist command;
    command.linear.x = get_parameter("speed").as_double();
    command.angular.z = command.linear.x / get_parameter("radius").as_double();
    publisher_->publish(command);
  }

  rclcpp::Publisher<geometry_msgs::msg::Twist>::SharedPtr publisher_;
  rclcpp::TimerBase::SharedPtr timer_;
};

int main(int argc, char * argv[])
{
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Circle>());
  rclcpp::shutdown();
  return 0;
}
