# CMake toolchain that builds unchanged ROS 2 packages for a ros2wasm site: Emscripten compiles,
# `ros2wasm link-program` links, Debian's ament and rosidl generators run on the host.
# Relocatable: every path is found from this file's own place. Inputs (all optional):
#   CMAKE_PREFIX_PATH  prefixes with packages for the site (include/, lib/, share/)
#   ROS2WASM_CLI       the ros2wasm binary        ROS2WASM_EMCXX / ROS2WASM_EMCC  the compilers
include_guard(GLOBAL)

set(ROS2WASM_TOOLCHAIN_DIR "${CMAKE_CURRENT_LIST_DIR}")
list(APPEND CMAKE_TRY_COMPILE_PLATFORM_VARIABLES
  ROS2WASM_CLI ROS2WASM_EMCC ROS2WASM_EMCXX ROS2WASM_SYSROOT CMAKE_PREFIX_PATH)

set(CMAKE_SYSTEM_NAME Emscripten)
set(CMAKE_SYSTEM_VERSION 1)
set(CMAKE_SYSTEM_PROCESSOR wasm32)
list(PREPEND CMAKE_MODULE_PATH "${ROS2WASM_TOOLCHAIN_DIR}/modules")

# --- the tools ---------------------------------------------------------------------------------
if(NOT ROS2WASM_EMCXX)
  find_program(ROS2WASM_EMCXX em++ HINTS "$ENV{EMSDK}/upstream/emscripten" REQUIRED)
endif()
if(NOT ROS2WASM_EMCC)
  get_filename_component(_ros2wasm_bin "${ROS2WASM_EMCXX}" DIRECTORY)
  set(ROS2WASM_EMCC "${_ros2wasm_bin}/emcc" CACHE FILEPATH "Emscripten C compiler")
endif()
if(NOT ROS2WASM_CLI)
  find_program(ROS2WASM_CLI ros2wasm REQUIRED
    HINTS "${ROS2WASM_TOOLCHAIN_DIR}/../.."          # <build>/templates/toolchain
          "${ROS2WASM_TOOLCHAIN_DIR}/../../build"    # source tree
          "${ROS2WASM_TOOLCHAIN_DIR}/../../../../bin"  # <prefix>/share/ros2wasm/templates/toolchain
    NO_CMAKE_FIND_ROOT_PATH)
endif()
get_filename_component(_ros2wasm_bin "${ROS2WASM_EMCXX}" DIRECTORY)

set(CMAKE_C_COMPILER "${ROS2WASM_EMCC}")
set(CMAKE_CXX_COMPILER "${ROS2WASM_EMCXX}")
find_program(CMAKE_AR emar HINTS "${_ros2wasm_bin}" NO_CMAKE_FIND_ROOT_PATH)
find_program(CMAKE_RANLIB emranlib HINTS "${_ros2wasm_bin}" NO_CMAKE_FIND_ROOT_PATH)

# The compiler is known; asking it with test programs would cost seconds per package.
foreach(_lang IN ITEMS C CXX)
  set(CMAKE_${_lang}_COMPILER_ID_RUN TRUE)
  set(CMAKE_${_lang}_COMPILER_FORCED TRUE)
  set(CMAKE_${_lang}_COMPILER_WORKS TRUE)
  set(CMAKE_${_lang}_COMPILER_ID Clang)
  set(CMAKE_${_lang}_COMPILER_VERSION 14.0)  # the oldest that we support
  set(CMAKE_${_lang}_COMPILER_FRONTEND_VARIANT GNU)
  set(CMAKE_${_lang}_PLATFORM_ID emscripten)
endforeach()
set(CMAKE_C_STANDARD_COMPUTED_DEFAULT 17)
set(CMAKE_CXX_STANDARD_COMPUTED_DEFAULT 14)
set(CMAKE_C_COMPILE_FEATURES c_std_90 c_function_prototypes c_std_99 c_restrict c_variadic_macros
  c_std_11 c_static_assert c_std_17)
set(CMAKE_CXX_COMPILE_FEATURES cxx_std_98 cxx_std_11 cxx_std_14 cxx_std_17 cxx_std_20)
foreach(_year IN ITEMS 98 11 14 17 20)
  set(CMAKE_CXX${_year}_COMPILE_FEATURES cxx_std_${_year})
endforeach()
foreach(_year IN ITEMS 90 99 11 17)
  set(CMAKE_C${_year}_COMPILE_FEATURES c_std_${_year})
endforeach()
set(CMAKE_SIZEOF_VOID_P 4)
set(CMAKE_C_SIZEOF_DATA_PTR 4)
set(CMAKE_CXX_SIZEOF_DATA_PTR 4)
set(CMAKE_C_BYTE_ORDER LITTLE_ENDIAN)
set(CMAKE_CXX_BYTE_ORDER LITTLE_ENDIAN)
set(EMSCRIPTEN 1)

# --- flags: everything is compiled once, whichever way it is linked later ------------------------
# No file of a package names this machine: sources, the build, and the folders with installed packages, whose headers
# say their place by __FILE__.
set(_ros2wasm_places "")
foreach(_prefix IN LISTS CMAKE_PREFIX_PATH)
  get_filename_component(_place "${_prefix}" DIRECTORY)
  if(NOT _place STREQUAL "/")
    list(APPEND _ros2wasm_places "${_place}")
  endif()
endforeach()
list(REMOVE_DUPLICATES _ros2wasm_places)
set(_ros2wasm_maps "")
foreach(_place IN LISTS _ros2wasm_places)
  string(APPEND _ros2wasm_maps "\"-ffile-prefix-map=${_place}=installed\" ")
endforeach()
# The forced include gives libunwind's landing pad context its thread-local declaration; without it
# typed catches fail in programs with threads. For -Os and -Oz the driver has nothing inlined, leaving that to the
# optimizer behind the linker: then each program has thousands of tiny functions to link and optimize, for more bytes.
string(CONCAT _ros2wasm_flags "-fwasm-exceptions -pthread -finline-functions "
  "-include \"${ROS2WASM_TOOLCHAIN_DIR}/include/ros2wasm/exception_context.h\" "
  "${_ros2wasm_maps}"
  "\"-ffile-prefix-map=${CMAKE_SOURCE_DIR}=.\" \"-ffile-prefix-map=${CMAKE_BINARY_DIR}=build\"")
# `long` has 32 bits here. What that would change without a word is said: an argument that a format would read by half (in
# C++ the overloads of ros2wasm_std read it whole, so this is about C and functions of the package with `...`) is an error,
# a 64-bit value that a `long` takes a warning. What natively is a mere warning as well stays one.
string(APPEND _ros2wasm_flags " -Werror=format -Wno-error=format-extra-args -Wno-error=format-zero-length"
  " -Wno-error=format-security -Wno-error=format-insufficient-args -Wno-error=format-invalid-specifier"
  " -Wformat-nonliteral -Wno-error=format-nonliteral -Wshorten-64-to-32 -Wno-error=shorten-64-to-32")
# Headers that stand before those of the compiler: formats of 64-bit machines, and parts of C++20 that its library lacks.
foreach(_prefix IN LISTS CMAKE_PREFIX_PATH)
  if(IS_DIRECTORY "${_prefix}/include/ros2wasm_std")
    string(APPEND _ros2wasm_flags " -isystem \"${_prefix}/include/ros2wasm_std\"")
    break()
  endif()
endforeach()
set(CMAKE_C_FLAGS_INIT "${_ros2wasm_flags}")
set(CMAKE_CXX_FLAGS_INIT "${_ros2wasm_flags}")
# Programs that use nothing of ROS have files from the core too, and all that it wraps; the others name it themselves.
foreach(_prefix IN LISTS CMAKE_PREFIX_PATH)
  if(EXISTS "${_prefix}/share/ros2wasm_core/link_options")
    file(STRINGS "${_prefix}/share/ros2wasm_core/link_options" _ros2wasm_options)
    list(TRANSFORM _ros2wasm_options PREPEND "-Wl,")
    list(JOIN _ros2wasm_options " " _ros2wasm_options)
    set(CMAKE_CXX_STANDARD_LIBRARIES_INIT "\"${_prefix}/lib/libros2wasm_core.a\" ${_ros2wasm_options}")
    break()
  endif()
endforeach()
if(NOT DEFINED CMAKE_BUILD_TYPE OR CMAKE_BUILD_TYPE STREQUAL "")
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Build type")
endif()
# In the cache, because CMake's own rules for Clang append to the _INIT variables.
foreach(_lang IN ITEMS C CXX)
  set(CMAKE_${_lang}_FLAGS_RELEASE "-O2 -DNDEBUG" CACHE STRING "Flags of release builds")
  set(CMAKE_${_lang}_FLAGS_RELWITHDEBINFO "-O2 -DNDEBUG" CACHE STRING "As release: the site has no debugger")
  set(CMAKE_${_lang}_FLAGS_MINSIZEREL "-Os -DNDEBUG" CACHE STRING "Flags of small builds")
  set(CMAKE_${_lang}_FLAGS_DEBUG "-O1" CACHE STRING "Flags of debug builds")
endforeach()
if(NOT DEFINED CMAKE_CXX_STANDARD)
  set(CMAKE_CXX_STANDARD 17)  # what ROS 2 Jazzy's compilers default to
endif()

# --- where things are found ----------------------------------------------------------------------
# Packages, headers and libraries for the site come from CMAKE_PREFIX_PATH only. From the host come
# tools: ament and the rosidl generators, which are scripts.
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE NEVER)
set(CMAKE_FIND_USE_CMAKE_SYSTEM_PATH OFF)
set(CMAKE_FIND_USE_PACKAGE_REGISTRY OFF)
set(CMAKE_FIND_USE_SYSTEM_PACKAGE_REGISTRY OFF)
set(CMAKE_FIND_PACKAGE_PREFER_CONFIG OFF)
# pkg-config knows the packages of this machine by itself.
set(_ros2wasm_pkg_config "")
foreach(_prefix IN LISTS CMAKE_PREFIX_PATH)
  list(APPEND _ros2wasm_pkg_config "${_prefix}/lib/pkgconfig" "${_prefix}/share/pkgconfig")
endforeach()
list(JOIN _ros2wasm_pkg_config ":" _ros2wasm_pkg_config)
set(ENV{PKG_CONFIG_LIBDIR} "${_ros2wasm_pkg_config}")
set(ENV{PKG_CONFIG_PATH} "")
if(NOT DEFINED ROS2WASM_HOST_SHARE)
  set(ROS2WASM_HOST_SHARE /usr/share)
endif()
file(GLOB _ros2wasm_host_packages
  "${ROS2WASM_HOST_SHARE}/ament_cmake*" "${ROS2WASM_HOST_SHARE}/ament_lint*"
  "${ROS2WASM_HOST_SHARE}/rosidl_cmake" "${ROS2WASM_HOST_SHARE}/rosidl_adapter"
  "${ROS2WASM_HOST_SHARE}/rosidl_parser" "${ROS2WASM_HOST_SHARE}/rosidl_cli"
  "${ROS2WASM_HOST_SHARE}/rosidl_pycommon" "${ROS2WASM_HOST_SHARE}/rosidl_generator_c"
  "${ROS2WASM_HOST_SHARE}/rosidl_generator_cpp" "${ROS2WASM_HOST_SHARE}/python_cmake_module")
# The host's would install for the host's Python.
list(REMOVE_ITEM _ros2wasm_host_packages "${ROS2WASM_HOST_SHARE}/ament_cmake_python")
# What the host lacks comes last.
file(GLOB _ros2wasm_own_packages "${ROS2WASM_TOOLCHAIN_DIR}/packages/*")
foreach(_folder IN LISTS _ros2wasm_host_packages _ros2wasm_own_packages)
  get_filename_component(_package "${_folder}" NAME)
  if(${_package}_DIR OR NOT EXISTS "${_folder}/cmake")
    continue()
  endif()
  set(_elsewhere FALSE)
  foreach(_prefix IN LISTS CMAKE_PREFIX_PATH)
    if(EXISTS "${_prefix}/share/${_package}/cmake")
      set(_elsewhere TRUE)
    endif()
  endforeach()
  if(NOT _elsewhere)
    set(${_package}_DIR "${_folder}/cmake")
  endif()
endforeach()
# ament's Python modules belong to Debian's interpreter, whatever `python3` is on PATH.
if(NOT Python3_EXECUTABLE AND EXISTS /usr/bin/python3)
  set(Python3_EXECUTABLE /usr/bin/python3)
endif()
set(CMAKE_PROJECT_INCLUDE "${ROS2WASM_TOOLCHAIN_DIR}/modules/after_project.cmake")
set(CMAKE_PROJECT_TOP_LEVEL_INCLUDES "${ROS2WASM_TOOLCHAIN_DIR}/modules/provider.cmake")

# --- policy of a site build ----------------------------------------------------------------------
# In the cache, because option() of old packages drops ordinary variables. Tests and linters run in the
# native build of the same sources.
set(BUILD_TESTING OFF CACHE BOOL "Build the tests")
set(BUILD_SHARED_LIBS OFF CACHE BOOL "Sites have static libraries only")
