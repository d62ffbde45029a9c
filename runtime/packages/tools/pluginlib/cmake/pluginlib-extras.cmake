# The functions of this package, for those that find it.
cmake_policy(VERSION 3.20)  # whatever the project that includes this has set, or not yet

macro(_pluginlib_register_package_hook)
  if(NOT DEFINED _PLUGINLIB_PACKAGE_HOOK_REGISTERED)
    set(_PLUGINLIB_PACKAGE_HOOK_REGISTERED TRUE)
    find_package(ament_cmake_core QUIET REQUIRED)
    ament_register_extension("ament_package" "pluginlib" "pluginlib_package_hook.cmake")
  endif()
endmacro()

include("${pluginlib_DIR}/pluginlib_export_plugin_description_file.cmake")
include("${pluginlib_DIR}/ros2wasm_link_plugins.cmake")
include("${pluginlib_DIR}/ros2wasm_plugin_kits.cmake")
