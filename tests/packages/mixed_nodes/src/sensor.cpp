#include <chrono>
#include <memory>

#include "mixed_nodes/msg/reading.hpp"
#include "rclcpp/rclcpp.hpp"

class Sensor : public rclcpp::Node {
 public:
  Sensor() : Node("sensor") {
    publisher_ = create_publisher<mixed_nodes::msg::Reading>("readings", 10);
    timer_ = create_wall_timer(std::chrono::milliseconds(100), [this] {
      mixed_nodes::msg::Reading reading;
      reading.sensor = "left";
      reading.values = {1.0, 2.0, 3.0};
      publisher_->publish(reading);
    });
  }

 private:
  rclcpp::Publisher<mixed_nodes::msg::Reading>::SharedPtr publisher_;
  rclcpp::TimerBase::SharedPtr timer_;
};

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Sensor>());
  rclcpp::shutdown();
  return 0;
}
