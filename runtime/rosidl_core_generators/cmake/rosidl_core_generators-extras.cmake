# The order is the order in which the generators run.
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
