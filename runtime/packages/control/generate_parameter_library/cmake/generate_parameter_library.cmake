cmake_policy(VERSION 3.20)  # whatever the project that includes this has set, or not yet
# Functions for the CMakeLists.txt of packages:
#   generate_parameter_library(target file.yaml [validators.hpp])   a header, for C++
#   generate_parameter_module(name file.yaml [package.validators])  a module, for Python
# There are no functions for tests: packages are built for sites without their tests.

# Sets COMMAND, which generates `output` from `yaml`, and what it depends on.
function(_generate_parameters_command language output yaml validators result_command result_depends)
  find_package(Python3 REQUIRED COMPONENTS Interpreter)
  get_filename_component(prefix "${generate_parameter_library_DIR}/../../.." ABSOLUTE)
  set(modules "${prefix}/${PYTHON_INSTALL_DIR}")
  file(GLOB generator "${modules}/generate_parameter_library_py/*.py")
  if(NOT generator)
    message(FATAL_ERROR "generate_parameter_library_py is not installed in ${modules}: package.xml"
      " names generate_parameter_library, which brings it")
  endif()
  set(${result_command} ${Python3_EXECUTABLE} -B
    "${generate_parameter_library_DIR}/run_generator.py" "${modules}" ${language} "${output}"
    "${yaml}" ${validators} PARENT_SCOPE)
  set(${result_depends} ${generator} PARENT_SCOPE)
endfunction()

# A path of the caller's source folder, or an absolute one, that must be there.
function(_generate_parameters_source caller path result)
  get_filename_component(absolute "${path}" ABSOLUTE BASE_DIR "${CMAKE_CURRENT_SOURCE_DIR}")
  if(NOT EXISTS "${absolute}" OR IS_DIRECTORY "${absolute}")
    message(FATAL_ERROR "${caller}: there is no file ${absolute}")
  endif()
  set(${result} "${absolute}" PARENT_SCOPE)
endfunction()

# The target has the header as <project/target.hpp>, and as <target.hpp> too, as older versions have.
# A macro, since ament_export_dependencies() is meant for the caller.
macro(generate_parameter_library LIB_NAME YAML_FILE)
  _generate_parameter_header(${LIB_NAME} "${YAML_FILE}" "${ARGN}")
  ament_export_dependencies(
    fmt generate_parameter_library rclcpp rclcpp_lifecycle rsl tcb_span tl_expected)
endmacro()

function(_generate_parameter_header name yaml_file validators)
  _generate_parameters_source(generate_parameter_library "${yaml_file}" yaml)
  set(folder "${CMAKE_CURRENT_BINARY_DIR}/include/${PROJECT_NAME}")
  set(header "${folder}/${name}.hpp")
  set(sources "${yaml}")
  set(validators_name "")
  if(validators)
    _generate_parameters_source(generate_parameter_library "${validators}" validators)
    get_filename_component(validators_name "${validators}" NAME)
    file(COPY "${validators}" DESTINATION "${folder}")
    list(APPEND sources "${validators}")
  endif()
  _generate_parameters_command(
    cpp "${header}" "${yaml}" "${validators_name}" command generator)
  add_custom_command(
    OUTPUT "${header}"
    COMMAND ${command}
    DEPENDS ${sources} ${generator}
    COMMENT "Generating ${PROJECT_NAME}/${name}.hpp"
    VERBATIM)
  add_library(${name} INTERFACE "${header}")
  target_include_directories(${name} INTERFACE
    $<BUILD_INTERFACE:${CMAKE_CURRENT_BINARY_DIR}/include>
    $<BUILD_INTERFACE:${folder}>
    $<INSTALL_INTERFACE:include>
    $<INSTALL_INTERFACE:include/${PROJECT_NAME}>)
  target_compile_features(${name} INTERFACE cxx_std_17)
  target_link_libraries(${name} INTERFACE
    generate_parameter_library::generate_parameter_library)
  install(DIRECTORY "${folder}" DESTINATION include)
endfunction()

function(generate_parameter_module name yaml_file)
  _generate_parameters_source(generate_parameter_module "${yaml_file}" yaml)
  set(module "${CMAKE_CURRENT_BINARY_DIR}/generate_parameter_module/${name}.py")
  _generate_parameters_command(python "${module}" "${yaml}" "${ARGN}" command generator)
  add_custom_command(
    OUTPUT "${module}"
    COMMAND ${command}
    DEPENDS "${yaml}" ${generator}
    COMMENT "Generating ${name}.py of ${PROJECT_NAME}"
    VERBATIM)
  add_custom_target(${name} ALL DEPENDS "${module}")
  install(FILES "${module}" DESTINATION "${PYTHON_INSTALL_DIR}/${PROJECT_NAME}")
endfunction()
