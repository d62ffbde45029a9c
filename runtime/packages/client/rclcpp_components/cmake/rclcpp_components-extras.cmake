# The functions of this package, for those that find it.
cmake_policy(VERSION 3.20)  # whatever the project that includes this has set, or not yet

macro(_rclcpp_components_register_package_hook)
  if(NOT DEFINED _RCLCPP_COMPONENTS_PACKAGE_HOOK_REGISTERED)
    set(_RCLCPP_COMPONENTS_PACKAGE_HOOK_REGISTERED TRUE)
    find_package(ament_cmake_core QUIET REQUIRED)
    ament_register_extension("ament_package" "rclcpp_components"
      "rclcpp_components_package_hook.cmake")
  endif()
endmacro()

include("${rclcpp_components_DIR}/rclcpp_components_register_node.cmake")
include("${rclcpp_components_DIR}/rclcpp_components_register_nodes.cmake")
