# Stands for cv_bridge, which is made of OpenCV: what links it is left out, and the rest of the package is built.
include("${ROS2WASM_TOOLCHAIN_DIR}/modules/left_out.cmake")
ros2wasm_absent_libraries(OpenCV cv_bridge::cv_bridge)
set(cv_bridge_TARGETS cv_bridge::cv_bridge)
set(cv_bridge_FOUND_AMENT_PACKAGE TRUE)
