cmake_policy(VERSION 3.20)  # whatever the project that includes this has set, or not yet
include("${nav2_common_DIR}/nav2_package.cmake")
