// Publishes a sine wave on "reading". Parameter `period`: seconds between two readings.
#include <chrono>
#include <cmath>
#include <memory>

#include "rclcpp/rclcpp.hpp"
#include "readings/msg/reading.hpp"

class Sensor : public rclcpp::Node
{
public:
  Sensor()
  : Node("sensor"), period_(declare_parameter("period", 0.5))
  {
    publisher_ = create_publisher<readings::msg::Reading>("reading", 10);
    timer_ = create_wall_timer(std::chrono::duration<double>(period_), [this]() {measure();});
  }

private:
  void measure()
  {
    readings::msg::Reading reading;
    reading.stamp = now();
    reading.value = std::sin(count_++ * period_);
    publisher_->publish(reading);
  }

  double period_;
  rclcpp::Publisher<readings::msg::Reading>::SharedPtr publisher_;
  rclcpp::TimerBase::SharedPtr timer_;
  int count_ = 0;
};

int main(int argc, char * argv[])
{
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Sensor>());
  rclcpp::shutdown();
  return 0;
}
