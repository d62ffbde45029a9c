# Gazebo's own libraries, with which plugins for its server are written. The simulator of a site takes the place of that
# server and loads no such plugin, so what links these libraries, or includes their headers, is skipped (left_out.cmake), and
# the rest of the package is built: worlds, models, launch files and nodes.
cmake_policy(VERSION 3.20)  # whatever the project that includes this has set, or not yet
include_guard(GLOBAL)

set(_ros2wasm_gazebo_libraries "^(gazebo|gazebo_dev|gazebo_ros|SDFormat|sdformat[0-9]*|(gz|ignition)-(cmake|common|fuel_tools|fuel-tools|\
gazebo|gui|launch|math|msgs|physics|plugin|rendering|sensors|sim|tools|transport|utils)[0-9]*|(gz_.*|sdformat)_vendor)$")
# What natively `find_package(gz-sim)` of ROS 2 Jazzy finds, and `find_package(gazebo)` of Humble.
set(_ros2wasm_version_of_sim 8)
set(_ros2wasm_version_of_gazebo 11)

# Asked before each package is looked for, with the words of find_package(). Packages that this does not set as found are
# looked for as ever. A macro: packages set variables for who asks.
macro(_ros2wasm_before_find_package)
  if("${ARGV0}" MATCHES "${_ros2wasm_gazebo_libraries}")
    set_property(GLOBAL PROPERTY ROS2WASM_ASKED_FOR_GAZEBO TRUE)
    include("${ROS2WASM_TOOLCHAIN_DIR}/modules/left_out.cmake")
    if(NOT "${ARGV0}" STREQUAL "gazebo_ros")  # a package of the channel: nodes name it for its launch files, too
      _ros2wasm_find_gazebo_library(${ARGV})
    endif()
  endif()
endmacro()

# Newer versions of CMake ask the provider (provider.cmake), so that errors name the line of the project.
if(CMAKE_VERSION VERSION_LESS 3.24)
  macro(find_package)
    _ros2wasm_before_find_package(${ARGV})
    if("${ARGV0}" STREQUAL "gazebo_ros" OR NOT "${ARGV0}" MATCHES "${_ros2wasm_gazebo_libraries}")
      _find_package(${ARGV})
    endif()
  endmacro()
endif()

# Those of Gazebo's own build system.
macro(gz_find_package)
  find_package(${ARGV})
endmacro()
macro(ign_find_package)
  find_package(${ARGV})
endmacro()

# The variables and targets that the library's own package gives, for targets that are absent.
macro(_ros2wasm_find_gazebo_library name)
  cmake_parse_arguments(_ros2wasm_asked "" "" "COMPONENTS;OPTIONAL_COMPONENTS" ${ARGN})
  set(${name}_FOUND TRUE)
  set(${name}_INCLUDE_DIRS "")
  if("${name}" MATCHES "_vendor$")
    set(${name}_FOUND_AMENT_PACKAGE TRUE)
    set(${name}_TARGETS "")
    set(${name}_LIBRARIES "")
  else()
    string(REGEX REPLACE "[0-9]+$" "" _ros2wasm_plain "${name}")
    string(REGEX MATCH "[0-9]+$" ${name}_VERSION_MAJOR "${name}")
    if("${${name}_VERSION_MAJOR}" STREQUAL "")
      set(${name}_VERSION_MAJOR ${_ros2wasm_version_of_sim})
      if("${name}" MATCHES "^gazebo")
        set(${name}_VERSION_MAJOR ${_ros2wasm_version_of_gazebo})
      endif()
    endif()
    set(${name}_VERSION "${${name}_VERSION_MAJOR}.0.0")
    set(${name}_LIBRARIES "${name}::${name}")
    set(${name}_TARGETS "${name}::${name}")
    set(_ros2wasm_parts ${_ros2wasm_plain} core all requested register ${_ros2wasm_asked_COMPONENTS}
      ${_ros2wasm_asked_OPTIONAL_COMPONENTS})
    foreach(_ros2wasm_part IN LISTS _ros2wasm_parts)
      ros2wasm_absent_libraries("the libraries of Gazebo" "${name}::${_ros2wasm_part}" "${_ros2wasm_plain}::${_ros2wasm_part}"
        "${name}::${name}-${_ros2wasm_part}")
    endforeach()
    ros2wasm_absent_libraries("the libraries of Gazebo" "${name}::${name}")
    if("${name}" STREQUAL "gazebo")
      set(GAZEBO_FOUND TRUE)
      set(GAZEBO_VERSION "${gazebo_VERSION}")
      set(GAZEBO_MAJOR_VERSION "${gazebo_VERSION_MAJOR}")
      set(GAZEBO_LIBRARIES "${gazebo_LIBRARIES}")
      set(GAZEBO_INCLUDE_DIRS "")
      set(GAZEBO_LIBRARY_DIRS "")
      set(GAZEBO_CXX_FLAGS "")
    elseif("${name}" MATCHES "^(SDFormat|sdformat)")
      set(SDFormat_LIBRARIES "${${name}_LIBRARIES}")
      set(SDFormat_INCLUDE_DIRS "")
    endif()
  endif()
endmacro()

# Targets that include a header of Gazebo without naming a library: gazebo_ros brings both natively. Called for each folder
# once all targets are known, before those that are left out are gone through.
function(_ros2wasm_mark_users_of_gazebo folder)
  get_property(_asked GLOBAL PROPERTY ROS2WASM_ASKED_FOR_GAZEBO)
  if(NOT _asked)
    return()
  endif()
  get_property(_targets DIRECTORY "${folder}" PROPERTY BUILDSYSTEM_TARGETS)
  foreach(_target IN LISTS _targets)
    get_target_property(_sources ${_target} SOURCES)
    foreach(_source IN LISTS _sources)
      get_filename_component(_source "${_source}" ABSOLUTE BASE_DIR "${folder}")
      if(NOT EXISTS "${_source}")
        continue()
      endif()
      file(STRINGS "${_source}" _found LIMIT_COUNT 1
        REGEX "^[ \t]*#[ \t]*include[ \t]*<(gazebo|gz|ignition|sdf|gazebo_ros|gazebo_plugins)/")
      if(_found)
        set_target_properties(${_target} PROPERTIES ROS2WASM_ABSENT "the libraries of Gazebo")
      endif()
    endforeach()
  endforeach()
endfunction()
