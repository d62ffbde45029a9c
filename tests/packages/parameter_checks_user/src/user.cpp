// Finds the header of another package under its older name. Nobody gives it the serial number,
// which is required; then it gets one that the rules refuse.
#include <iostream>

#include "arm_parameters.hpp"
#include "rclcpp/rclcpp.hpp"

void start(const std::vector<rclcpp::Parameter>& overrides) {
  auto node =
      std::make_shared<rclcpp::Node>("user", rclcpp::NodeOptions().parameter_overrides(overrides));
  try {
    const arm::ParamListener listener(node);
    std::cout << "serial " << listener.get_params().serial << std::endl;
  } catch (const rclcpp::exceptions::ParameterUninitializedException& error) {
    std::cout << "uninitialized: " << error.what() << std::endl;
  } catch (const rclcpp::exceptions::InvalidParameterValueException& error) {
    std::cout << "invalid: " << error.what() << std::endl;
  }
}

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  start({});
  start({{"serial", 7}, {"parity", 3}});
  start({{"serial", 7}, {"tries", 6}});
  start({{"serial", 7}});
  rclcpp::shutdown();
}
