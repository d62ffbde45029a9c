# add_library(), which marks what natively would be a shared library: in its archive lies an object with
# nothing in it. When a definition stands twice on a link line, `ros2wasm link-program` goes by it
# (bundler/build/wasm_object.hpp).
cmake_policy(VERSION 3.20)  # whatever the project that includes this has set, or not yet
include_guard(GLOBAL)

function(add_library name)
  _add_library(${ARGV})
  if("IMPORTED" IN_LIST ARGN OR "ALIAS" IN_LIST ARGN)
    return()
  endif()
  get_target_property(_type "${name}" TYPE)
  get_property(_shared_by_default GLOBAL PROPERTY ROS2WASM_SHARED_BY_DEFAULT)
  if(NOT _type STREQUAL "STATIC_LIBRARY" OR "STATIC" IN_LIST ARGN)
    return()
  endif()
  if(NOT "SHARED" IN_LIST ARGN AND NOT "MODULE" IN_LIST ARGN AND NOT BUILD_SHARED_LIBS
      AND NOT _shared_by_default)
    return()
  endif()
  set(_mark "${CMAKE_BINARY_DIR}/natively_shared.o")
  if(NOT EXISTS "${_mark}")
    execute_process(COMMAND printf "\\0asm\\1\\0\\0\\0\\0\\11\\7linking\\2" OUTPUT_FILE "${_mark}")
  endif()
  set_property(TARGET "${name}" APPEND PROPERTY STATIC_LIBRARY_OPTIONS "${_mark}")
endfunction()
