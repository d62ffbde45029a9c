# Stands for xacro: descriptions are expanded when the site is packed, by launch files that say so.
set(xacro_FOUND_AMENT_PACKAGE TRUE)
function(xacro_add_files)
  message(FATAL_ERROR "xacro_add_files() of xacro is not there: install the .xacro file, and expand it in a launch file")
endfunction()
function(xacro_install)
  xacro_add_files()
endfunction()
