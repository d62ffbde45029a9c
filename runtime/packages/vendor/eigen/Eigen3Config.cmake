# The target, and the variables that packages use instead.
get_filename_component(EIGEN3_ROOT_DIR "${CMAKE_CURRENT_LIST_DIR}/../../.." ABSOLUTE)
set(EIGEN3_FOUND TRUE)
set(EIGEN3_VERSION_STRING 3.4.0)
set(EIGEN3_VERSION ${EIGEN3_VERSION_STRING})
set(Eigen3_VERSION ${EIGEN3_VERSION_STRING})
set(EIGEN3_INCLUDE_DIR "${EIGEN3_ROOT_DIR}/include/eigen3")
# <eigen3/Eigen/Dense> is found too, as where headers lie in /usr/include.
set(EIGEN3_INCLUDE_DIRS "${EIGEN3_INCLUDE_DIR}" "${EIGEN3_ROOT_DIR}/include")
set(Eigen3_INCLUDE_DIRS "${EIGEN3_INCLUDE_DIRS}")
set(EIGEN3_DEFINITIONS "")
if(NOT TARGET Eigen3::Eigen)
  add_library(Eigen3::Eigen INTERFACE IMPORTED)
  set_target_properties(Eigen3::Eigen PROPERTIES
    INTERFACE_INCLUDE_DIRECTORIES "${EIGEN3_INCLUDE_DIRS}")
endif()
