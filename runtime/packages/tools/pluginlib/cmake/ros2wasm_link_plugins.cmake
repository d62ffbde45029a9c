# ros2wasm_link_plugins(<target> INTERFACE|PRIVATE <library>...)
# Links libraries of plugins as a whole: nothing refers to a plugin but its registration. For programs of the channel, which know
# their plugins; what a workspace adds is linked by the kits of its packages. Packages that find the target do not see it.
cmake_policy(VERSION 3.20)  # whatever the project that includes this has set, or not yet
function(ros2wasm_link_plugins target scope)
  foreach(library IN LISTS ARGN)
    target_link_libraries(${target} ${scope} $<BUILD_INTERFACE:${library}>)
    target_link_options(${target} ${scope}
      "$<BUILD_INTERFACE:SHELL:-Wl,--whole-archive $<TARGET_FILE:${library}> -Wl,--no-whole-archive>")
  endforeach()
endfunction()
