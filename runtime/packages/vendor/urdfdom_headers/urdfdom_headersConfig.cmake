# The target, and the variable that packages use instead.
get_filename_component(urdfdom_headers_INCLUDE_DIRS
  "${CMAKE_CURRENT_LIST_DIR}/../../../include/urdfdom_headers" ABSOLUTE)
if(NOT TARGET urdfdom_headers::urdfdom_headers)
  add_library(urdfdom_headers::urdfdom_headers INTERFACE IMPORTED)
  set_target_properties(urdfdom_headers::urdfdom_headers PROPERTIES
    INTERFACE_INCLUDE_DIRECTORIES "${urdfdom_headers_INCLUDE_DIRS}")
endif()
