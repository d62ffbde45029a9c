# The targets, under each of their names.
get_filename_component(_range_v3_include "${CMAKE_CURRENT_LIST_DIR}/../../../include/range-v3" ABSOLUTE)
foreach(_target range-v3 range-v3-concepts range-v3-meta range-v3::range-v3 range-v3::concepts range-v3::meta)
  if(NOT TARGET ${_target})
    add_library(${_target} INTERFACE IMPORTED)
    set_target_properties(${_target} PROPERTIES
      INTERFACE_INCLUDE_DIRECTORIES "${_range_v3_include}"
      INTERFACE_COMPILE_FEATURES cxx_std_14)
  endif()
endforeach()
set(range-v3_INCLUDE_DIRS "${_range_v3_include}")
