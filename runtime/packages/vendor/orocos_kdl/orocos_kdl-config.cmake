# The target, under each of its names, and the variables that packages use instead.
include(CMakeFindDependencyMacro)
find_dependency(Eigen3)
get_filename_component(_prefix "${CMAKE_CURRENT_LIST_DIR}/../../.." ABSOLUTE)
set(orocos_kdl_INCLUDE_DIRS "${_prefix}/include" "${_prefix}/include/eigen3")
set(orocos_kdl_LIBRARY_DIRS "${_prefix}/lib")
set(orocos_kdl_LIBRARIES orocos-kdl)
set(orocos_kdl_TARGETS orocos-kdl)
set(orocos_kdl_FOUND_CATKIN_PROJECT TRUE)
foreach(_target orocos-kdl orocos_kdl::orocos-kdl)
  if(NOT TARGET ${_target})
    add_library(${_target} STATIC IMPORTED)
    set_target_properties(${_target} PROPERTIES
      IMPORTED_LOCATION "${_prefix}/lib/liborocos-kdl.a"
      INTERFACE_INCLUDE_DIRECTORIES "${_prefix}/include"
      INTERFACE_LINK_LIBRARIES Eigen3::Eigen)
  endif()
endforeach()
