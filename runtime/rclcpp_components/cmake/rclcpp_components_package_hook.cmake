# At ament_package(): makes the container of the package's components, unless the package sets
# RCLCPP_COMPONENTS_NO_CONTAINER; programs that load libraries
# of classes at run time, and link none of the package's themselves, get all of them, since nothing
# can be loaded later; writes the components into the package's index.
list(REMOVE_DUPLICATES _RCLCPP_COMPONENTS_LIBRARIES)
_rclcpp_components_keep_once(${_RCLCPP_COMPONENTS_LIBRARIES})
if(NOT TARGET component_container AND NOT RCLCPP_COMPONENTS_NO_CONTAINER)
  add_executable(component_container ${rclcpp_components_DIR}/component_container.cpp)
  target_link_libraries(component_container
    ${_RCLCPP_COMPONENTS_LIBRARIES} rclcpp_components::component_manager)
  install(TARGETS component_container DESTINATION lib/${PROJECT_NAME})
endif()
get_property(_targets DIRECTORY PROPERTY BUILDSYSTEM_TARGETS)
foreach(_target IN LISTS _targets)
  get_target_property(_type ${_target} TYPE)
  get_target_property(_linked ${_target} LINK_LIBRARIES)
  if(NOT _type STREQUAL "EXECUTABLE" OR NOT "class_loader::class_loader" IN_LIST _linked)
    continue()
  endif()
  set(_chosen FALSE)
  foreach(_library IN LISTS _RCLCPP_COMPONENTS_LIBRARIES)
    if(_library IN_LIST _linked)
      set(_chosen TRUE)
    endif()
  endforeach()
  if(NOT _chosen)
    set_property(TARGET ${_target} APPEND PROPERTY LINK_LIBRARIES ${_RCLCPP_COMPONENTS_LIBRARIES})
  endif()
endforeach()
list(REMOVE_DUPLICATES _RCLCPP_COMPONENTS_PACKAGE_RESOURCE_INDICES)
foreach(resource_index ${_RCLCPP_COMPONENTS_PACKAGE_RESOURCE_INDICES})
  ament_index_register_resource(${resource_index}
    CONTENT "${_RCLCPP_COMPONENTS_${resource_index}__NODES}")
endforeach()
