# At ament_package(): makes the containers of the package's components, unless the package sets
# RCLCPP_COMPONENTS_NO_CONTAINER; programs that load libraries
# of classes at run time, and link none of the package's themselves, get all of them, since nothing
# can be loaded later; writes the components into the package's index.
cmake_policy(VERSION 3.20)  # whatever the project that includes this has set, or not yet
list(REMOVE_DUPLICATES _RCLCPP_COMPONENTS_LIBRARIES)
_rclcpp_components_keep_once(${_RCLCPP_COMPONENTS_LIBRARIES})
if(NOT RCLCPP_COMPONENTS_NO_CONTAINER)
  foreach(_container component_container component_container_mt component_container_isolated)
    if(TARGET ${_container})  # the package's own
      continue()
    endif()
    set(_main component_container_mt.cpp)
    if(_container STREQUAL "component_container")
      set(_main component_container.cpp)
    endif()
    add_executable(${_container} ${rclcpp_components_DIR}/${_main})
    target_link_libraries(${_container}
      ${_RCLCPP_COMPONENTS_LIBRARIES} rclcpp_components::component_manager)
    install(TARGETS ${_container} DESTINATION lib/${PROJECT_NAME})
  endforeach()
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
