# rclcpp_components_register_node(<library> PLUGIN <class> EXECUTABLE <name>
#                                 [EXECUTOR <class>] [RESOURCE_INDEX <name>])
# Notes the component in the package's index and makes a program that runs it alone.
cmake_policy(VERSION 3.20)  # whatever the project that includes this has set, or not yet
macro(rclcpp_components_register_node target)
  cmake_parse_arguments(ARGS "" "PLUGIN;EXECUTABLE;EXECUTOR;RESOURCE_INDEX" "" ${ARGN})
  if(ARGS_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "rclcpp_components_register_node() called with unused arguments: "
      "${ARGS_UNPARSED_ARGUMENTS}")
  endif()
  if("${ARGS_PLUGIN}" STREQUAL "")
    message(FATAL_ERROR
      "rclcpp_components_register_node macro requires a PLUGIN argument for target ${target}")
  endif()
  if("${ARGS_EXECUTABLE}" STREQUAL "")
    message(FATAL_ERROR
      "rclcpp_components_register_node macro requires a EXECUTABLE argument for target ${target}")
  endif()
  set(resource_index "rclcpp_components")
  if(NOT "${ARGS_RESOURCE_INDEX}" STREQUAL "")
    set(resource_index ${ARGS_RESOURCE_INDEX})
  endif()
  set(executor "${ARGS_EXECUTOR}")
  set(_main "node_main_on_executor.cpp.in")
  if(executor MATCHES "^((rclcpp::)?executors::)?SingleThreadedExecutor$" OR executor STREQUAL "")
    set(_main "node_main.cpp.in")
  endif()
  set(component ${ARGS_PLUGIN})
  set(node ${ARGS_EXECUTABLE})
  _rclcpp_components_note(${resource_index} ${component} ${target})
  configure_file(${rclcpp_components_DIR}/${_main}
    ${PROJECT_BINARY_DIR}/rclcpp_components/node_main_${node}.cpp @ONLY)
  add_executable(${node} ${PROJECT_BINARY_DIR}/rclcpp_components/node_main_${node}.cpp)
  rclcpp_components_link_components(${node} ${target})
  install(TARGETS ${node} DESTINATION lib/${PROJECT_NAME})
endmacro()

# Links whole libraries of components into a program, so that they register themselves.
function(rclcpp_components_link_components program)
  target_link_libraries(${program} ${ARGN} rclcpp_components::component)
endfunction()

# A program that links a library of components has all of them, as one that loads a shared library.
function(_rclcpp_components_keep_whole library)
  get_target_property(_kept ${library} ROS2WASM_KEPT_WHOLE)
  if(_kept)
    return()
  endif()
  set_target_properties(${library} PROPERTIES ROS2WASM_KEPT_WHOLE
    "SHELL:-Wl,--whole-archive \"$<TARGET_FILE:${library}>\" -Wl,--no-whole-archive")
  set_property(TARGET ${library} APPEND PROPERTY COMPILE_DEFINITIONS
    "CLASS_LOADER_LIBRARY=\"lib$<TARGET_FILE_BASE_NAME:${library}>.so\"")
  set_property(TARGET ${library} APPEND PROPERTY INTERFACE_LINK_OPTIONS
    "$<BUILD_INTERFACE:$<TARGET_GENEX_EVAL:${library},$<TARGET_PROPERTY:${library},ROS2WASM_KEPT_WHOLE>>>")
endfunction()

# A source of several libraries is kept in the first of them: two shared libraries may have the same
# symbols, two whole archives may not. The others keep the rest, object by object.
function(_rclcpp_components_keep_once)
  set(_seen)
  foreach(_library IN LISTS ARGN)
    get_target_property(_folder ${_library} SOURCE_DIR)
    get_target_property(_sources ${_library} SOURCES)
    list(REMOVE_DUPLICATES _sources)
    set(_own "$<TARGET_OBJECTS:${_library}>")
    set(_given)
    set(_repeated FALSE)
    foreach(_source IN LISTS _sources)
      if(NOT _source MATCHES "[.]c[^./]*$|TARGET_OBJECTS:")
        continue()
      endif()
      set(_path ${_source})
      cmake_path(ABSOLUTE_PATH _path BASE_DIRECTORY ${_folder} NORMALIZE)
      if(NOT _path IN_LIST _seen)
        list(APPEND _seen ${_path})
        if(_source MATCHES "TARGET_OBJECTS:")
          list(APPEND _given ${_source})
        endif()
        continue()
      endif()
      set(_repeated TRUE)
      cmake_path(RELATIVE_PATH _path BASE_DIRECTORY ${_folder})
      string(REGEX REPLACE "[^A-Za-z0-9_/]" "." _path "${_path}")
      set(_own "$<FILTER:${_own},EXCLUDE,/${_library}.dir/(./)?${_path}.>")
    endforeach()
    if(_repeated)
      set_target_properties(${_library} PROPERTIES ROS2WASM_KEPT_WHOLE "${_own};${_given}")
    endif()
  endforeach()
endfunction()

macro(_rclcpp_components_note resource_index component target)
  _rclcpp_components_register_package_hook()
  _rclcpp_components_keep_whole(${target})
  list(APPEND _RCLCPP_COMPONENTS_LIBRARIES ${target})
  set(_RCLCPP_COMPONENTS_${resource_index}__NODES
    "${_RCLCPP_COMPONENTS_${resource_index}__NODES}${component};lib/$<TARGET_FILE_NAME:${target}>\n")
  list(APPEND _RCLCPP_COMPONENTS_PACKAGE_RESOURCE_INDICES ${resource_index})
endmacro()
