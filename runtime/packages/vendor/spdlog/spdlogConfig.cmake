# The targets, under both of their names: there are headers only.
include(CMakeFindDependencyMacro)
find_dependency(fmt)
get_filename_component(spdlog_INCLUDE_DIRS "${CMAKE_CURRENT_LIST_DIR}/../../../include" ABSOLUTE)
foreach(_target spdlog::spdlog spdlog::spdlog_header_only)
  if(NOT TARGET ${_target})
    add_library(${_target} INTERFACE IMPORTED)
    set_target_properties(${_target} PROPERTIES
      INTERFACE_INCLUDE_DIRECTORIES "${spdlog_INCLUDE_DIRS}"
      INTERFACE_COMPILE_DEFINITIONS SPDLOG_FMT_EXTERNAL
      INTERFACE_LINK_LIBRARIES fmt::fmt)
  endif()
endforeach()
set(spdlog_LIBRARIES spdlog::spdlog)
