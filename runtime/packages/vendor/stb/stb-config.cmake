# Headers below include/, so `#include <stb/stb_image.h>`.
if(NOT TARGET stb::stb)
  get_filename_component(_stb_prefix "${CMAKE_CURRENT_LIST_DIR}/../../.." ABSOLUTE)
  add_library(stb::stb INTERFACE IMPORTED)
  set_target_properties(stb::stb PROPERTIES INTERFACE_INCLUDE_DIRECTORIES "${_stb_prefix}/include")
endif()
