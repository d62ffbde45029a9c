# The target, and the variable that packages use instead.
get_filename_component(nanoflann_INCLUDE_DIRS "${CMAKE_CURRENT_LIST_DIR}/../../../include" ABSOLUTE)
if(NOT TARGET nanoflann::nanoflann)
  add_library(nanoflann::nanoflann INTERFACE IMPORTED)
  set_target_properties(nanoflann::nanoflann PROPERTIES
    INTERFACE_INCLUDE_DIRECTORIES "${nanoflann_INCLUDE_DIRS}"
    INTERFACE_COMPILE_FEATURES cxx_std_11)
endif()
