// The main function of all containers, after they have made their manager and its executor.
#pragma once

#include <memory>

#include "rclcpp_components/component_manager.hpp"

namespace rclcpp_components::detail {

/// Loads what the command line names and spins until the context ends.
void spin_container(int argc, char** argv, const std::shared_ptr<ComponentManager>& manager,
                    rclcpp::Executor& executor);

}  // namespace rclcpp_components::detail
