# The order is the order in which the generators run.
find_package(rosidl_cmake QUIET REQUIRED)
find_package(rosidl_generator_cpp QUIET REQUIRED)
find_package(rosidl_typesupport_wasm_cpp QUIET REQUIRED)
rosidl_typesupport_wasm_cpp_register()
