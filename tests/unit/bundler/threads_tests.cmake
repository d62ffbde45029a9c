# What runs in several threads, and its tests, under the thread sanitizer: these sources alone are compiled for it, the rest
# of the bundler is as it is. Not together with other sanitizers.
if(NOT CMAKE_CXX_FLAGS MATCHES "-fsanitize")
  include(${PROJECT_SOURCE_DIR}/bundler/threaded_sources.cmake)
  list(TRANSFORM threaded_sources PREPEND ${PROJECT_SOURCE_DIR}/bundler/)
  add_executable(bundler_threads_test
    build/build_workspace_test.cpp
    store/store_test.cpp
    ${threaded_sources}
    io/worker_pool_test.cpp
  )
  compile_in_groups(bundler_threads_test 2)
  target_include_directories(bundler_threads_test PRIVATE ${PROJECT_SOURCE_DIR}/tests)
  target_compile_definitions(bundler_threads_test PRIVATE ROS2WASM_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
  target_compile_options(bundler_threads_test PRIVATE -O1 -fsanitize=thread)
  target_link_options(bundler_threads_test PRIVATE -fsanitize=thread)
  target_link_libraries(bundler_threads_test PRIVATE bundler GTest::gtest_main)
  gtest_discover_tests(bundler_threads_test TEST_PREFIX threads. DISCOVERY_TIMEOUT 60
    PROPERTIES ENVIRONMENT "TSAN_OPTIONS=suppressions=${CMAKE_CURRENT_SOURCE_DIR}/threads_libc.supp")
endif()
