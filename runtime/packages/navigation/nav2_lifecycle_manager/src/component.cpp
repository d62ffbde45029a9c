// The manager in a container.
#include "nav2_lifecycle_manager/lifecycle_manager.hpp"
#include "rclcpp_components/register_node_macro.hpp"

RCLCPP_COMPONENTS_REGISTER_NODE(nav2_lifecycle_manager::LifecycleManager)
