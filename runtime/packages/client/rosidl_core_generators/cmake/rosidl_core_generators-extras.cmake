# The order is the order in which the generators run.
cmake_policy(VERSION 3.20)  # whatever the project that includes this has set, or not yet
# Packages of interfaces only need not ask for it themselves: the generators export include folders.
find_package(ament_cmake QUIET REQUIRED)
find_package(rosidl_cmake QUIET REQUIRED)
find_package(rosidl_generator_cpp QUIET REQUIRED)
find_package(rosidl_typesupport_wasm_cpp QUIET REQUIRED)
rosidl_typesupport_wasm_cpp_register()

# Older packages link their own messages by it. rosidl_cmake's takes no type support with more than one include folder.
function(rosidl_target_interfaces target interfaces typesupport)
  rosidl_get_typesupport_target(_typesupport ${interfaces} ${typesupport})
  add_dependencies(${target} ${interfaces})
  target_link_libraries(${target} ${_typesupport})
endfunction()
