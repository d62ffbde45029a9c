# Included after project() of a package that includes C headers of its own messages. Their functions are defined in the
# headers, so that the type support for C has no library: `rosidl_get_typesupport_target(... rosidl_typesupport_c)` and
# rosidl_target_interfaces() find a target that brings the include folders.
if(NOT TARGET ${PROJECT_NAME}__rosidl_typesupport_c)
  find_package(rosidl_runtime_c QUIET)
  add_library(${PROJECT_NAME}__rosidl_typesupport_c INTERFACE IMPORTED GLOBAL)
  if(TARGET rosidl_runtime_c::rosidl_runtime_c)
    target_link_libraries(${PROJECT_NAME}__rosidl_typesupport_c INTERFACE rosidl_runtime_c::rosidl_runtime_c)
  endif()
endif()
