// Runs one component as a program of its own.
#include "rclcpp_components/component_program.hpp"

#include <algorithm>
#include <memory>
#include <string>

#include "class_loader/class_loader.hpp"
#include "rclcpp/rclcpp.hpp"
#include "rclcpp_components/node_factory.hpp"

namespace rclcpp_components {

int run_component(int argc, char** argv, const char* program, const char* component,
                  rclcpp::Executor& (*make_executor)()) {
  const auto arguments = rclcpp::init_and_remove_ros_arguments(argc, argv);
  const rclcpp::Logger logger = rclcpp::get_logger(program);
  rclcpp::NodeOptions options;
  options.arguments(arguments);
  const std::string class_name =
      std::string("rclcpp_components::NodeFactoryTemplate<") + component + ">";
  class_loader::ClassLoader loader("");
  if (!loader.isClassAvailable<NodeFactory>(class_name)) {
    RCLCPP_ERROR(logger, "Class %s not found in library %s", class_name.c_str(), program);
    return 1;
  }
  const auto factory = loader.createInstance<NodeFactory>(class_name);
  std::unique_ptr<rclcpp::Executor> own;
  if (make_executor == nullptr) {
    own = std::make_unique<rclcpp::executors::SingleThreadedExecutor>();
  }
  rclcpp::Executor& executor = own == nullptr ? make_executor() : *own;
  {
    NodeInstanceWrapper wrapper = factory->create_node_instance(options);
    const auto node = wrapper.get_node_base_interface();
    executor.add_node(node);
    executor.spin();
    executor.remove_node(node);
  }
  rclcpp::shutdown();
  return 0;
}

}  // namespace rclcpp_components
