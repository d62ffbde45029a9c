# What runs in several threads, and its tests, under the thread sanitizer: these sources alone are compiled for it, the rest
# of the bundler is as it is. Not together with other sanitizers.
if(NOT CMAKE_CXX_FLAGS MATCHES "-fsanitize")
  add_executable(bundler_threads_test
    build/build_workspace_test.cpp
    store/store_test.cpp
    ${PROJECT_SOURCE_DIR}/bundler/build/build_workspace.cpp
    ${PROJECT_SOURCE_DIR}/bundler/channel/read_in_parts.cpp
    ${PROJECT_SOURCE_DIR}/bundler/io/process.cpp
    ${PROJECT_SOURCE_DIR}/bundler/io/worker_pool.cpp
    ${PROJECT_SOURCE_DIR}/bundler/store/cache_care.cpp
    ${PROJECT_SOURCE_DIR}/bundler/store/store.cpp
    ${PROJECT_SOURCE_DIR}/bundler/store/tree_seal.cpp
    io/worker_pool_test.cpp
  )
  target_include_directories(bundler_threads_test PRIVATE ${PROJECT_SOURCE_DIR}/tests)
  target_compile_definitions(bundler_threads_test PRIVATE ROS2WASM_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
  target_compile_options(bundler_threads_test PRIVATE -O1 -fsanitize=thread)
  target_link_options(bundler_threads_test PRIVATE -fsanitize=thread)
  target_link_libraries(bundler_threads_test PRIVATE bundler GTest::gtest_main)
  gtest_discover_tests(bundler_threads_test TEST_PREFIX threads. DISCOVERY_TIMEOUT 60
    PROPERTIES ENVIRONMENT "TSAN_OPTIONS=suppressions=${CMAKE_CURRENT_SOURCE_DIR}/threads_libc.supp")
endif()
