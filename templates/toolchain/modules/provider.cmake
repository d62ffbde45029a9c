# Lets gazebo.cmake answer find_package(). CMake includes this in the first project() call, the only place for it, and in the
# scope of the project, whose policies stay as they are.
cmake_policy(PUSH)
cmake_policy(VERSION 3.20)
macro(_ros2wasm_provide method)
  _ros2wasm_before_find_package(${ARGN})
endmacro()
if(NOT CMAKE_VERSION VERSION_LESS 3.24)
  cmake_language(SET_DEPENDENCY_PROVIDER _ros2wasm_provide SUPPORTED_METHODS FIND_PACKAGE)
endif()
cmake_policy(POP)
