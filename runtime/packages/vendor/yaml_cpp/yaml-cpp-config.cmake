# The target, under both of its names, and the variables that packages use instead.
get_filename_component(_prefix "${CMAKE_CURRENT_LIST_DIR}/../../.." ABSOLUTE)
set(YAML_CPP_INCLUDE_DIR "${_prefix}/include")
set(YAML_CPP_LIBRARY_DIR "${_prefix}/lib")
set(YAML_CPP_LIBRARIES yaml-cpp::yaml-cpp)
# ament asks for these when a package names yaml_cpp_vendor only.
set(yaml-cpp_INCLUDE_DIRS "${YAML_CPP_INCLUDE_DIR}")
set(yaml-cpp_LIBRARIES yaml-cpp::yaml-cpp)
foreach(_target yaml-cpp::yaml-cpp yaml-cpp)
  if(NOT TARGET ${_target})
    add_library(${_target} STATIC IMPORTED)
    set_target_properties(${_target} PROPERTIES
      IMPORTED_LOCATION "${YAML_CPP_LIBRARY_DIR}/libyaml-cpp.a"
      INTERFACE_INCLUDE_DIRECTORIES "${YAML_CPP_INCLUDE_DIR}")
  endif()
endforeach()
