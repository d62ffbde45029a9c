# mujoco::mujoco: the physics engine.
if(NOT TARGET mujoco::mujoco)
  get_filename_component(_mujoco_prefix "${CMAKE_CURRENT_LIST_DIR}/../../.." ABSOLUTE)
  add_library(mujoco::mujoco STATIC IMPORTED)
  set_target_properties(mujoco::mujoco PROPERTIES
    IMPORTED_LOCATION "${_mujoco_prefix}/lib/libmujoco.a"
    INTERFACE_INCLUDE_DIRECTORIES "${_mujoco_prefix}/include")
endif()
