#include "bench.hpp"
#include "rclcpp/rclcpp.hpp"

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  std::printf("%s\n", measured_navfn().c_str());
  rclcpp::shutdown();
}
