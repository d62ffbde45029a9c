# The target, under both of its names, and the variables that packages use instead. CMake reads this file for TinyXML2 too,
# as tinyxml2_vendor's module is called.
get_filename_component(_prefix "${CMAKE_CURRENT_LIST_DIR}/../../.." ABSOLUTE)
foreach(_target tinyxml2::tinyxml2 tinyxml2)
  if(NOT TARGET ${_target})
    add_library(${_target} STATIC IMPORTED)
    set_target_properties(${_target} PROPERTIES
      IMPORTED_LOCATION "${_prefix}/lib/libtinyxml2.a"
      INTERFACE_INCLUDE_DIRECTORIES "${_prefix}/include")
  endif()
endforeach()
foreach(_name tinyxml2 TINYXML2 TinyXML2)
  set(${_name}_INCLUDE_DIR "${_prefix}/include")
  set(${_name}_INCLUDE_DIRS "${_prefix}/include")
  set(${_name}_LIBRARY tinyxml2::tinyxml2)
  set(${_name}_LIBRARIES tinyxml2::tinyxml2)
endforeach()
set(TINYXML2_FOUND TRUE)
