# What `cpack` makes of an installation: a .deb for the Debian release that it is built on, and a tarball that runs from wherever
# it is unpacked. Both are the same bytes each time when SOURCE_DATE_EPOCH is set and the umask is 022 (`./dev package` does both).
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION share/doc/ros2wasm RENAME copyright)

set(CMAKE_SKIP_INSTALL_ALL_DEPENDENCY ON) # tests are no part of it
set(CPACK_GENERATOR DEB TGZ)
set(CPACK_PACKAGE_NAME ros2wasm)
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(CPACK_PACKAGE_VENDOR "the ros2wasm authors")
set(CPACK_PACKAGE_CONTACT "the ros2wasm authors <ros2wasm@example.org>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "packs a ROS 2 workspace into a static site that runs in the browser")
set(CPACK_PACKAGE_DESCRIPTION "Each node becomes a worker in the visitor's browser; topics, services and actions
connect them, and a page shows what happens. With the channel of packages that workspaces are built from.")
set(CPACK_PACKAGE_DIRECTORY ${CMAKE_BINARY_DIR}/packages)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SECTION devel)
set(CPACK_DEBIAN_COMPRESSION_TYPE gzip) # packages of the channel are compressed already
# Workspaces with packages in CMake are compiled; a site is played, and setup.py read, by Node.js. `serve` and `verify` need none
# of these.
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "emscripten, cmake, ninja-build, ament-cmake, rosidl-cmake, rosidl-core, \
rosidl-generator-c-cpp, python3-rosidl, nodejs (>= 22.13)")
include(CPack)
