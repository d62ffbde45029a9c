# Extension of rosidl_generate_interfaces(): generates type support and makes these targets:
#   <target>__rosidl_typesupport_cpp  static library with the type support of all interfaces
#   <package>::<target>               the library and the headers, for target_link_libraries()
cmake_policy(VERSION 3.20)  # whatever the project that includes this has set, or not yet
find_package(rosidl_runtime_cpp REQUIRED)
find_package(rosidl_typesupport_wasm_cpp REQUIRED)
find_package(Python3 REQUIRED COMPONENTS Interpreter)

set(_wasm_cpp_target "${rosidl_generate_interfaces_TARGET}")
set(_wasm_cpp_library "${_wasm_cpp_target}__rosidl_typesupport_cpp")
set(_wasm_cpp_output
  "${CMAKE_CURRENT_BINARY_DIR}/rosidl_typesupport_wasm_cpp/${PROJECT_NAME}")
set(_wasm_cpp_source "${_wasm_cpp_output}/${_wasm_cpp_target}__rosidl_typesupport_wasm_cpp.cpp")
set(_wasm_cpp_headers "")
set(_wasm_cpp_descriptions "")
foreach(_idl_file ${rosidl_generate_interfaces_ABS_IDL_FILES})
  get_filename_component(_folder "${_idl_file}" DIRECTORY)
  get_filename_component(_folder "${_folder}" NAME)
  get_filename_component(_stem "${_idl_file}" NAME_WE)
  string_camel_case_to_lower_case_underscore("${_stem}" _header)
  list(APPEND _wasm_cpp_headers
    "${_wasm_cpp_output}/${_folder}/detail/${_header}__rosidl_typesupport_wasm_cpp.hpp")
  list(APPEND _wasm_cpp_descriptions "${_wasm_cpp_output}/${_folder}/${_stem}.json")
  if(NOT rosidl_generate_interfaces_SKIP_INSTALL)
    install(FILES "${_wasm_cpp_output}/${_folder}/${_stem}.json"
      DESTINATION "share/${PROJECT_NAME}/${_folder}")
  endif()
endforeach()

# Descriptions of other packages' types lie beside their .idl files.
set(_wasm_cpp_dependencies "")
set(_wasm_cpp_dependency_files "")
foreach(_package ${rosidl_generate_interfaces_DEPENDENCY_PACKAGE_NAMES})
  foreach(_idl_file ${${_package}_IDL_FILES})
    set(_abs_idl_file "${${_package}_DIR}/../${_idl_file}")
    normalize_path(_abs_idl_file "${_abs_idl_file}")
    list(APPEND _wasm_cpp_dependencies "${_package}:${_abs_idl_file}")
    string(REGEX REPLACE "\\.idl$" ".json" _json "${_abs_idl_file}")
    list(APPEND _wasm_cpp_dependency_files "${_json}")
  endforeach()
endforeach()
file(GLOB _wasm_cpp_generator "${rosidl_typesupport_wasm_cpp_GENERATOR}/*.py")

set(_wasm_cpp_arguments
  "${CMAKE_CURRENT_BINARY_DIR}/${_wasm_cpp_target}__rosidl_typesupport_wasm_cpp.json")
rosidl_write_generator_arguments("${_wasm_cpp_arguments}"
  PACKAGE_NAME "${PROJECT_NAME}"
  IDL_TUPLES "${rosidl_generate_interfaces_IDL_TUPLES}"
  NON_IDL_TUPLES "${_non_idl_tuples}"
  ROS_INTERFACE_DEPENDENCIES "${_wasm_cpp_dependencies}"
  OUTPUT_DIR "${_wasm_cpp_output}")
add_custom_command(
  OUTPUT "${_wasm_cpp_source}" ${_wasm_cpp_headers} ${_wasm_cpp_descriptions}
  COMMAND Python3::Interpreter -B "${rosidl_typesupport_wasm_cpp_GENERATOR}/generate.py"
    --generator-arguments-file "${_wasm_cpp_arguments}" --target "${_wasm_cpp_target}"
  DEPENDS ${_wasm_cpp_generator} ${rosidl_generate_interfaces_ABS_IDL_FILES} ${_non_idl_files}
    ${_wasm_cpp_dependency_files}
  COMMENT "Generating type support of ${PROJECT_NAME}"
  VERBATIM)

add_library(${_wasm_cpp_library} STATIC "${_wasm_cpp_source}" ${_wasm_cpp_headers})
target_compile_features(${_wasm_cpp_library} PUBLIC cxx_std_17)
target_compile_options(${_wasm_cpp_library} PRIVATE
  -ffunction-sections -fdata-sections -Wno-deprecated-declarations)
target_include_directories(${_wasm_cpp_library} PUBLIC
  "$<BUILD_INTERFACE:${CMAKE_CURRENT_BINARY_DIR}/rosidl_typesupport_wasm_cpp>"
  "$<INSTALL_INTERFACE:include/${PROJECT_NAME}>")
target_link_libraries(${_wasm_cpp_library} PUBLIC
  ${_wasm_cpp_target}__rosidl_generator_cpp
  rosidl_typesupport_wasm_cpp::rosidl_typesupport_wasm_cpp)
foreach(_package ${rosidl_generate_interfaces_DEPENDENCY_PACKAGE_NAMES})
  target_link_libraries(${_wasm_cpp_library} PUBLIC
    ${${_package}_TARGETS__rosidl_typesupport_cpp})
endforeach()

# `<target>` itself is taken by rosidl's custom target, so the library of that name is an alias here
# and gets the name when it is exported.
set(_wasm_cpp_all ${_wasm_cpp_target}__interfaces)
add_library(${_wasm_cpp_all} INTERFACE)
target_link_libraries(${_wasm_cpp_all} INTERFACE ${_wasm_cpp_library})
set_target_properties(${_wasm_cpp_all} PROPERTIES EXPORT_NAME ${_wasm_cpp_target})
add_library(${PROJECT_NAME}::${_wasm_cpp_target} ALIAS ${_wasm_cpp_all})
add_library(${PROJECT_NAME}::${_wasm_cpp_library} ALIAS ${_wasm_cpp_library})
add_dependencies(${_wasm_cpp_target} ${_wasm_cpp_library})

if(NOT rosidl_generate_interfaces_SKIP_INSTALL)
  install(DIRECTORY "${_wasm_cpp_output}/"
    DESTINATION "include/${PROJECT_NAME}/${PROJECT_NAME}" FILES_MATCHING PATTERN "*.hpp")
  install(TARGETS ${_wasm_cpp_library} ${_wasm_cpp_all}
    EXPORT export_${_wasm_cpp_library}
    ARCHIVE DESTINATION lib)
  ament_export_targets(export_${_wasm_cpp_library})
  rosidl_export_typesupport_targets(__rosidl_typesupport_cpp ${_wasm_cpp_library})
  ament_export_include_directories("include/${PROJECT_NAME}")
  ament_export_libraries(${_wasm_cpp_library})
  ament_export_dependencies(rosidl_runtime_c rosidl_runtime_cpp rosidl_typesupport_wasm_cpp)
endif()
