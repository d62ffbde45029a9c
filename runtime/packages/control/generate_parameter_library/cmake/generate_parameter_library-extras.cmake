cmake_policy(VERSION 3.20)  # whatever the project that includes this has set, or not yet
find_package(ament_cmake_python REQUIRED)
include("${generate_parameter_library_DIR}/generate_parameter_library.cmake")
