// Walkers go a step of length one into any direction, all at once, a hundred times a second. Publishes the mean of their
// squared distances from the start, which is the number of steps in theory, and tells it at the end.
// Parameters: `seed`, `walkers`, `steps`.
#include <chrono>
#include <cmath>
#include <cstdint>
#include <memory>
#include <vector>

#include "rclcpp/rclcpp.hpp"
#include "std_msgs/msg/float64.hpp"

using namespace std::chrono_literals;

class Walk : public rclcpp::Node
{
public:
  Walk()
  : Node("walk"),
    state_(static_cast<uint64_t>(declare_parameter("seed", 1))),
    walkers_(static_cast<size_t>(declare_parameter("walkers", 1000))),
    steps_(declare_parameter("steps", 100))
  {
    publisher_ = create_publisher<std_msgs::msg::Float64>("mean_squared_distance", 10);
    timer_ = create_wall_timer(10ms, [this]() {step();});
  }

private:
  struct Walker
  {
    double x = 0;
    double y = 0;
  };

  // The generator is a part of the result: those of C++ libraries differ from machine to machine.
  double random()
  {
    state_ += 0x9e3779b97f4a7c15;
    uint64_t z = state_;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
    z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
    return static_cast<double>((z ^ (z >> 31)) >> 11) / 9007199254740992.0;
  }

  void step()
  {
    double sum = 0;
    for (Walker & walker : walkers_) {
      const double direction = 2 * M_PI * random();
      walker.x += std::cos(direction);
      walker.y += std::sin(direction);
      sum += walker.x * walker.x + walker.y * walker.y;
    }
    std_msgs::msg::Float64 mean;
    mean.data = sum / static_cast<double>(walkers_.size());
    publisher_->publish(mean);
    if (++done_ == steps_) {
      timer_->cancel();
      RCLCPP_INFO(
        get_logger(), "after %d steps the mean squared distance is %.2f", static_cast<int>(done_), mean.data);
    }
  }

  uint64_t state_;
  std::vector<Walker> walkers_;
  int64_t steps_;
  int64_t done_ = 0;
  rclcpp::Publisher<std_msgs::msg::Float64>::SharedPtr publisher_;
  rclcpp::TimerBase::SharedPtr timer_;
};

int main(int argc, char * argv[])
{
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Walk>());
  rclcpp::shutdown();
  return 0;
}
