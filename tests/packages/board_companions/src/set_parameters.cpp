// set_parameters NODE NAME=VALUE...: sets one parameter of a node after the other, as `ros2 param
// set` does, and says of each whether the node accepted it. An integer, a double or a string, by
// how VALUE reads.
#include <cstdio>
#include <memory>
#include <string>

#include "rclcpp/rclcpp.hpp"

namespace {

rclcpp::Parameter parameter_of(const std::string& name, const std::string& value) {
  const bool number =
      !value.empty() && value.find_first_not_of("+-.0123456789") == std::string::npos;
  if (!number) return {name, value};
  if (value.find('.') == std::string::npos) return {name, std::stoi(value)};
  return {name, std::stod(value)};
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<std::string> words = rclcpp::init_and_remove_ros_arguments(argc, argv);
  if (words.size() < 3) return 2;
  const auto node = std::make_shared<rclcpp::Node>("set_parameters");
  rclcpp::SyncParametersClient client(node, words[1]);
  while (!client.wait_for_service(std::chrono::seconds(1))) {
    if (!rclcpp::ok()) return 1;
  }
  for (std::size_t i = 2; i < words.size(); ++i) {
    const auto equals = words[i].find('=');
    const std::string name = words[i].substr(0, equals);
    const auto results = client.set_parameters({parameter_of(name, words[i].substr(equals + 1))});
    if (results.empty()) return 1;
    std::printf("%s: %s\n", name.c_str(), results.front().successful ? "successful" : "failed");
  }
  rclcpp::shutdown();
  return 0;
}
