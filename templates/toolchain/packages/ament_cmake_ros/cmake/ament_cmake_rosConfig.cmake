# Stands for ament_cmake_ros, which Debian does not have: ament_cmake and nothing else, since libraries of a
# site are static and tests run in the native build.
find_package(ament_cmake REQUIRED)
set(ament_cmake_ros_FOUND_AMENT_PACKAGE TRUE)
# Natively it makes BUILD_SHARED_LIBS an option that is on.
set_property(GLOBAL PROPERTY ROS2WASM_SHARED_BY_DEFAULT TRUE)
