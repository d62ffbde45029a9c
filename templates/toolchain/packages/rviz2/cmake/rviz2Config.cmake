# Stands for rviz2, a program with windows: packages that only look for it are built all the same.
set(rviz2_FOUND_AMENT_PACKAGE TRUE)
