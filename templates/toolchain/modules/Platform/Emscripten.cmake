# What CMake must know of the platform: no shared libraries, programs are single .wasm files, and
# the link goes through `ros2wasm link-program`, which chooses the kind of link.
set_property(GLOBAL PROPERTY TARGET_SUPPORTS_SHARED_LIBS FALSE)
set(UNIX 1)
set(EMSCRIPTEN 1)

set(CMAKE_EXECUTABLE_SUFFIX .wasm)
set(CMAKE_STATIC_LIBRARY_PREFIX lib)
set(CMAKE_STATIC_LIBRARY_SUFFIX .a)
set(CMAKE_FIND_LIBRARY_PREFIXES lib)
set(CMAKE_FIND_LIBRARY_SUFFIXES .a)
set(CMAKE_DL_LIBS "")
set(CMAKE_SKIP_RPATH TRUE)
set(CMAKE_POSITION_INDEPENDENT_CODE OFF)

foreach(_lang IN ITEMS C CXX)
  set(CMAKE_${_lang}_COMPILE_OPTIONS_PIC "")
  set(CMAKE_${_lang}_COMPILE_OPTIONS_PIE "")
  set(CMAKE_SHARED_LIBRARY_${_lang}_FLAGS "")
  set(CMAKE_${_lang}_LINK_OPTIONS_PIE "")
  set(CMAKE_${_lang}_LINK_OPTIONS_NO_PIE "")
  set(CMAKE_${_lang}_RESPONSE_FILE_LINK_FLAG "@")
  set(CMAKE_${_lang}_USE_RESPONSE_FILE_FOR_INCLUDES 0)
  # A package's -Werror is about the warnings of the compiler that its authors have; this one has others. Its -Werror=NAME
  # stays, and what is an error without a flag.
  set(CMAKE_${_lang}_COMPILE_OBJECT
    "<CMAKE_${_lang}_COMPILER> <DEFINES> <INCLUDES> <FLAGS> -Wno-error -o <OBJECT> -c <SOURCE>")
  # The archiver writes the symbol table itself; one process less per library.
  set(CMAKE_${_lang}_ARCHIVE_CREATE "<CMAKE_AR> qcs <TARGET> <LINK_FLAGS> <OBJECTS>")
  set(CMAKE_${_lang}_ARCHIVE_APPEND "<CMAKE_AR> qs <TARGET> <LINK_FLAGS> <OBJECTS>")
  set(CMAKE_${_lang}_ARCHIVE_FINISH "")
endforeach()
set(CMAKE_C_LINK_EXECUTABLE
  "\"${ROS2WASM_CLI}\" link-program --package ${CMAKE_PROJECT_NAME} -- \"${ROS2WASM_EMCC}\" <CMAKE_C_LINK_FLAGS> <LINK_FLAGS> <OBJECTS> -o <TARGET> <LINK_LIBRARIES>")
set(CMAKE_CXX_LINK_EXECUTABLE
  "\"${ROS2WASM_CLI}\" link-program --package ${CMAKE_PROJECT_NAME} -- \"${ROS2WASM_EMCXX}\" <CMAKE_CXX_LINK_FLAGS> <LINK_FLAGS> <OBJECTS> -o <TARGET> <LINK_LIBRARIES>")
