// Containers with threads; apart, since a program that refers to threads is linked with them.
#include <algorithm>
#include <memory>
#include <string_view>

#include "rclcpp/rclcpp.hpp"
#include "rclcpp_components/component_manager_isolated.hpp"
#include "rclcpp_components/component_program.hpp"
#include "rclcpp_components/detail/container.hpp"

namespace rclcpp_components {
namespace {

using rclcpp::executors::MultiThreadedExecutor;
using rclcpp::executors::SingleThreadedExecutor;

std::shared_ptr<ComponentManager> isolated_manager(const rclcpp::Executor::SharedPtr& executor,
                                                   bool has_threads_each) {
  if (has_threads_each) {
    return std::make_shared<ComponentManagerIsolated<MultiThreadedExecutor>>(executor);
  }
  return std::make_shared<ComponentManagerIsolated<SingleThreadedExecutor>>(executor);
}

}  // namespace

int run_container_mt(int argc, char** argv, const char* name) {
  rclcpp::init(argc, argv);
  if (std::string_view(name) == "component_container_isolated") {
    const bool has_threads_each =
        std::find(argv, argv + argc, std::string_view("--use_multi_threaded_executor")) !=
        argv + argc;
    const auto executor = std::make_shared<SingleThreadedExecutor>();
    detail::spin_container(argc, argv, isolated_manager(executor, has_threads_each), *executor);
    return 0;
  }
  const auto manager = std::make_shared<ComponentManager>();
  const auto executor = std::make_shared<MultiThreadedExecutor>(
      rclcpp::ExecutorOptions(), manager->get_parameter("thread_num").as_int());
  manager->set_executor(executor);
  detail::spin_container(argc, argv, manager, *executor);
  return 0;
}

}  // namespace rclcpp_components
