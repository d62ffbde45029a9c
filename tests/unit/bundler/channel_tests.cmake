# Tests of what comes from channels: archives, channels, resolving, the store.
add_executable(bundler_channel_test
  archive/conda_writer_test.cpp
  archive/extract_limits_test.cpp
  archive/hostile_archive_test.cpp
  archive/side_module_test.cpp
  archive/wheel_reader_test.cpp
  channel/channel_index_test.cpp
  channel/channel_network_test.cpp
  channel/channel_writer_test.cpp
  channel/msgpack_reader_test.cpp
  channel/repodata_index_test.cpp
  channel/shard_index_test.cpp
  channel/spec_table_test.cpp
  io/files_test.cpp
  io/cached_folder_test.cpp
  io/part_file_test.cpp
  resolve/check_solution_test.cpp
  ${PROJECT_SOURCE_DIR}/tests/property/solve_against_libsolv_test.cpp
  ${PROJECT_SOURCE_DIR}/tests/property/solve_property_test.cpp
  resolve/solve_test.cpp
  store/environment_test.cpp
  store/cache_place_test.cpp
  store/source_trees_test.cpp
  store/store_test.cpp
  workspace/foreign_environment_test.cpp
)
compile_in_groups(bundler_channel_test 5)
target_include_directories(bundler_channel_test PRIVATE ${PROJECT_SOURCE_DIR}/tests)
target_compile_definitions(bundler_channel_test PRIVATE ROS2WASM_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
compile_as_test(bundler_channel_test bundler_test_headers)
target_link_libraries(bundler_channel_test PRIVATE bundler GTest::gtest_main)
gtest_discover_tests(bundler_channel_test TEST_PREFIX bundler. DISCOVERY_TIMEOUT 60)
