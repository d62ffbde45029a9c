# rclcpp_components_register_nodes(<library> <class>... [RESOURCE_INDEX <name>])
# Notes components in the package's index.
cmake_policy(VERSION 3.20)  # whatever the project that includes this has set, or not yet
macro(rclcpp_components_register_nodes target)
  if(NOT TARGET ${target})
    message(FATAL_ERROR
      "rclcpp_components_register_nodes() first argument '${target}' is not a target")
  endif()
  cmake_parse_arguments(ARGS "" "RESOURCE_INDEX" "" ${ARGN})
  set(resource_index "rclcpp_components")
  if(NOT "${ARGS_RESOURCE_INDEX}" STREQUAL "")
    set(resource_index ${ARGS_RESOURCE_INDEX})
  endif()
  set(_unique_names)
  foreach(_arg ${ARGS_UNPARSED_ARGUMENTS})
    if(_arg IN_LIST _unique_names)
      message(FATAL_ERROR "rclcpp_components_register_nodes() the plugin names must be unique "
        "(multiple '${_arg}')")
    endif()
    list(APPEND _unique_names "${_arg}")
    _rclcpp_components_note(${resource_index} ${_arg} ${target})
  endforeach()
endmacro()
