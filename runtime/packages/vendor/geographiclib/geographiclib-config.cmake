# The target, under each of its names, and the variables that packages use instead.
get_filename_component(_prefix "${CMAKE_CURRENT_LIST_DIR}/../../.." ABSOLUTE)
set(GeographicLib_INCLUDE_DIRS "${_prefix}/include")
set(GeographicLib_LIBRARY_DIRS "${_prefix}/lib")
set(GeographicLib_LIBRARIES GeographicLib::GeographicLib)
set(GeographicLib_STATIC_LIBRARIES ${GeographicLib_LIBRARIES})
foreach(_target GeographicLib::GeographicLib GeographicLib::GeographicLib_STATIC GeographicLib)
  if(NOT TARGET ${_target})
    add_library(${_target} STATIC IMPORTED)
    set_target_properties(${_target} PROPERTIES
      IMPORTED_LOCATION "${_prefix}/lib/libGeographicLib.a"
      INTERFACE_INCLUDE_DIRECTORIES "${_prefix}/include")
  endif()
endforeach()
