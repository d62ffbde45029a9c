# nav2_package(): C++17 and warnings. Warnings do not fail a build: clang has some that gcc has not.
cmake_policy(VERSION 3.20)  # whatever the project that includes this has set, or not yet
macro(nav2_package)
  if(NOT CMAKE_CXX_STANDARD)
    set(CMAKE_CXX_STANDARD 17)
  endif()
  add_compile_options(-Wall -Wextra -Wpedantic -Wdeprecated -Wshadow
    "$<$<COMPILE_LANGUAGE:CXX>:-Wnon-virtual-dtor>")
endmacro()
