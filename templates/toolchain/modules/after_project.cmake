# Runs after each project() call. Gives the interpreter's target without FindPython3's probing,
# which needs development files that a site build never uses.
# A file that project() includes shares the project's policies: its own end with it.
cmake_policy(PUSH)
cmake_policy(VERSION 3.20)  # whatever the project that includes this has set, or not yet
if(Python3_EXECUTABLE AND NOT TARGET Python3::Interpreter)
  add_executable(Python3::Interpreter IMPORTED)
  set_target_properties(Python3::Interpreter PROPERTIES IMPORTED_LOCATION "${Python3_EXECUTABLE}")
endif()

include("${ROS2WASM_TOOLCHAIN_DIR}/modules/add_library.cmake")
include("${ROS2WASM_TOOLCHAIN_DIR}/modules/not_found.cmake")
include("${ROS2WASM_TOOLCHAIN_DIR}/modules/gazebo.cmake")

# Programs that include what nothing gives: a first build found that out.
if(ROS2WASM_MISSING_HEADERS)
  include("${ROS2WASM_TOOLCHAIN_DIR}/modules/left_out.cmake")
  include("${ROS2WASM_MISSING_HEADERS}")
endif()

cmake_policy(POP)
