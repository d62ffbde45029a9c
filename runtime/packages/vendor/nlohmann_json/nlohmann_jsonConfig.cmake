# The target, under both of its names.
get_filename_component(nlohmann_json_INCLUDE_DIRS "${CMAKE_CURRENT_LIST_DIR}/../../../include" ABSOLUTE)
foreach(_target nlohmann_json::nlohmann_json nlohmann_json)
  if(NOT TARGET ${_target})
    add_library(${_target} INTERFACE IMPORTED)
    set_target_properties(${_target} PROPERTIES
      INTERFACE_INCLUDE_DIRECTORIES "${nlohmann_json_INCLUDE_DIRS}"
      INTERFACE_COMPILE_FEATURES cxx_std_11)
  endif()
endforeach()
