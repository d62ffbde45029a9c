# The target, and the variables that packages use instead.
get_filename_component(ARMADILLO_INCLUDE_DIRS "${CMAKE_CURRENT_LIST_DIR}/../../../include" ABSOLUTE)
set(ARMADILLO_LIBRARIES "")
set(ARMADILLO_FOUND TRUE)
if(NOT TARGET armadillo)
  add_library(armadillo INTERFACE IMPORTED)
  set_target_properties(armadillo PROPERTIES INTERFACE_INCLUDE_DIRECTORIES "${ARMADILLO_INCLUDE_DIRS}")
endif()
