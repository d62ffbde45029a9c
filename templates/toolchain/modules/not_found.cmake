# What a project looked for itself and no site has: a variable such as ZMQ_INCLUDE_DIR stays at NOTFOUND. CMake refuses the
# whole project then, also for programs that do not need it. Here include folders that were not found are dropped, and
# only targets that link a library that was not found are skipped, as other absent libraries have it (left_out.cmake).
cmake_policy(VERSION 3.20)  # whatever the project that includes this has set, or not yet
include_guard(GLOBAL)

macro(find_library)
  _find_library(${ARGV})
  if("${${ARGV0}}" MATCHES "-NOTFOUND$")
    # Before the project's calls of install(), which must know.
    include("${ROS2WASM_TOOLCHAIN_DIR}/modules/left_out.cmake")
  endif()
endmacro()

# CMake keeps the words of this call beside the property, and looks at them again when it generates.
function(target_link_libraries target)
  _ros2wasm_found_only("${ARGN}" _found _absent)
  if(_absent)
    set_property(TARGET ${target} PROPERTY ROS2WASM_ABSENT "${_absent}")
  endif()
  _target_link_libraries(${target} ${_found})
endfunction()

# Into <result>: the entries of a property that were found. Into <absent>: the name of one that was not, or nothing.
function(_ros2wasm_found_only entries result absent)
  set(_absent "")
  foreach(_entry IN LISTS entries)
    if(_entry MATCHES "^(.*)-NOTFOUND$")
      set(_absent "${CMAKE_MATCH_1}")
    endif()
  endforeach()
  list(FILTER entries EXCLUDE REGEX "-NOTFOUND$")
  set(${result} "${entries}" PARENT_SCOPE)
  set(${absent} "${_absent}" PARENT_SCOPE)
endfunction()

# Of a folder and those below it, once all targets are known.
function(_ros2wasm_drop_not_found folder)
  get_property(_entries DIRECTORY "${folder}" PROPERTY INCLUDE_DIRECTORIES)
  _ros2wasm_found_only("${_entries}" _found _absent)
  if(_absent)
    message(WARNING "${_absent} was not found: no include folder comes of it")
    set_property(DIRECTORY "${folder}" PROPERTY INCLUDE_DIRECTORIES "${_found}")
  endif()
  get_property(_targets DIRECTORY "${folder}" PROPERTY BUILDSYSTEM_TARGETS)
  foreach(_target IN LISTS _targets)
    foreach(_property IN ITEMS INCLUDE_DIRECTORIES INTERFACE_INCLUDE_DIRECTORIES)
      get_property(_entries TARGET ${_target} PROPERTY ${_property})
      _ros2wasm_found_only("${_entries}" _found _absent)
      if(_absent)
        set_property(TARGET ${_target} PROPERTY ${_property} "${_found}")
      endif()
    endforeach()
  endforeach()
  get_property(_subfolders DIRECTORY "${folder}" PROPERTY SUBDIRECTORIES)
  foreach(_subfolder IN LISTS _subfolders)
    _ros2wasm_drop_not_found("${_subfolder}")
  endforeach()
endfunction()
cmake_language(DEFER DIRECTORY "${CMAKE_SOURCE_DIR}" CALL _ros2wasm_drop_not_found "${CMAKE_SOURCE_DIR}")
