# Users of messages need the headers only. Who generates messages calls this macro, after
# find_package(rosidl_generator_cpp), whose extension has to run first.
cmake_policy(VERSION 3.20)  # whatever the project that includes this has set, or not yet
set(rosidl_typesupport_wasm_cpp_GENERATOR "${rosidl_typesupport_wasm_cpp_DIR}/../generator")

macro(rosidl_typesupport_wasm_cpp_register)
  find_package(ament_cmake_core QUIET REQUIRED)
  list(PREPEND rosidl_generator_cpp_BIN "${rosidl_typesupport_wasm_cpp_GENERATOR}/service_events.py")
  file(GLOB _wasm_cpp_templates "${rosidl_typesupport_wasm_cpp_GENERATOR}/templates/*.em")
  list(APPEND rosidl_generator_cpp_GENERATOR_FILES
    "${rosidl_typesupport_wasm_cpp_GENERATOR}/own_constants.py" ${_wasm_cpp_templates})
  ament_register_extension(
    "rosidl_generate_idl_interfaces"
    "rosidl_typesupport_wasm_cpp"
    "rosidl_typesupport_wasm_cpp_generate_interfaces.cmake")
  # Before all generators: it says which packages they need.
  list(PREPEND AMENT_EXTENSIONS_rosidl_generate_idl_interfaces
    "rosidl_typesupport_wasm_cpp:rosidl_typesupport_wasm_cpp_service_events.cmake")
endmacro()
