// Programs that components are loaded into: those that their command lines name, and those that
// they are asked for later. The ones with threads are in component_container_mt.cpp.
#include <memory>
#include <string_view>
#include <vector>

#include "rclcpp/rclcpp.hpp"
#include "rclcpp_components/component_manager.hpp"
#include "rclcpp_components/component_program.hpp"
#include "rclcpp_components/detail/container.hpp"

namespace rclcpp_components {
namespace {

// The words of component_program.hpp.
constexpr std::string_view kComponent = "--component=";
constexpr std::string_view kArgument = "--component-arg=";
constexpr std::string_view kFlag = "--component-flag=";

struct Component {
  std::string plugin;
  std::vector<std::string> arguments;
  std::vector<rclcpp::Parameter> extras;
};

std::vector<Component> components_in(int argc, char** argv) {
  std::vector<Component> components;
  for (int i = 1; i < argc; ++i) {
    const std::string_view word = argv[i];
    const auto rest = [word](std::string_view option) {
      return std::string(word.substr(option.size()));
    };
    if (word.substr(0, kComponent.size()) == kComponent) {
      components.push_back({rest(kComponent), {}, {}});
    } else if (components.empty()) {
      continue;
    } else if (word.substr(0, kArgument.size()) == kArgument) {
      components.back().arguments.push_back(rest(kArgument));
    } else if (word.substr(0, kFlag.size()) == kFlag) {
      components.back().extras.emplace_back(rest(kFlag), true);
    }
  }
  return components;
}

}  // namespace

namespace detail {

void spin_container(int argc, char** argv, const std::shared_ptr<ComponentManager>& manager,
                    rclcpp::Executor& executor) {
  for (const Component& component : components_in(argc, argv)) {
    try {
      manager->load(component.plugin, component.arguments, component.extras);
    } catch (const ComponentManagerException& error) {
      RCLCPP_ERROR(manager->get_logger(), "%s", error.what());
    }
  }
  executor.add_node(manager);
  executor.spin();
}

}  // namespace detail

int run_container(int argc, char** argv) {
  rclcpp::init(argc, argv);
  auto executor = std::make_shared<rclcpp::executors::SingleThreadedExecutor>();
  detail::spin_container(argc, argv, std::make_shared<ComponentManager>(executor), *executor);
  return 0;
}

}  // namespace rclcpp_components
