# Who finds this package may have libraries of nodes, which are linked into programs.
cmake_policy(VERSION 3.20)  # whatever the project that includes this has set, or not yet
if(NOT DEFINED _BEHAVIORTREE_CPP_HOOK_REGISTERED)
  set(_BEHAVIORTREE_CPP_HOOK_REGISTERED TRUE)
  find_package(ament_cmake_core QUIET REQUIRED)
  ament_register_extension("ament_package" "behaviortree_cpp" "behaviortree_cpp_package_hook.cmake")
endif()
