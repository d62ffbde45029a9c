cmake_policy(VERSION 3.20)  # whatever the project that includes this has set, or not yet
include("${ros2_control_cmake_DIR}/ros2_control.cmake")
