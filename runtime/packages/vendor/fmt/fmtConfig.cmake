# The targets, under both of their names: there are headers only.
get_filename_component(fmt_INCLUDE_DIRS "${CMAKE_CURRENT_LIST_DIR}/../../../include" ABSOLUTE)
foreach(_target fmt::fmt fmt::fmt-header-only)
  if(NOT TARGET ${_target})
    add_library(${_target} INTERFACE IMPORTED)
    set_target_properties(${_target} PROPERTIES
      INTERFACE_INCLUDE_DIRECTORIES "${fmt_INCLUDE_DIRS}"
      INTERFACE_COMPILE_DEFINITIONS FMT_HEADER_ONLY=1)
  endif()
endforeach()
set(fmt_TARGETS fmt::fmt)
