include("${ros2_control_cmake_DIR}/ros2_control.cmake")
