# Stands for image_geometry, which is made of OpenCV: what links it is left out, and the rest of the package is built.
include("${ROS2WASM_TOOLCHAIN_DIR}/modules/left_out.cmake")
ros2wasm_absent_libraries(OpenCV image_geometry::image_geometry)
set(image_geometry_TARGETS image_geometry::image_geometry)
set(image_geometry_FOUND_AMENT_PACKAGE TRUE)
