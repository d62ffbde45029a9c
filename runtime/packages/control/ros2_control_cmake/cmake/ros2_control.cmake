cmake_policy(VERSION 3.20)  # whatever the project that includes this has set, or not yet
# C++17 and warnings. Upstream makes errors of some warnings; here they stay warnings, as the compiler of the site warns of
# other things than GCC does, and `long` and `size_t` have 32 bits.
macro(set_compiler_options)
  if(NOT CMAKE_CXX_STANDARD)
    set(CMAKE_CXX_STANDARD 17)
    set(CMAKE_CXX_STANDARD_REQUIRED ON)
  endif()
  add_compile_options(-Wall -Wextra -Wpedantic)
endmacro()

# Only Windows needs it.
macro(export_windows_symbols)
endmacro()
