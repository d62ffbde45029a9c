# Tests of serving and running sites, and of beginning workspaces.
add_executable(bundler_serve_test
  run/headless_command_test.cpp
  run/node_js_test.cpp
  serve/http_server_test.cpp
  serve/mime_types_test.cpp
  serve/reload_test.cpp
  serve/request_rules_test.cpp
  serve/served_place_test.cpp
  serve/workspace_watch_test.cpp
  workspace/manifest_draft_test.cpp
)
compile_in_groups(bundler_serve_test 2)
target_compile_definitions(bundler_serve_test PRIVATE ROS2WASM_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
compile_as_test(bundler_serve_test bundler_test_headers)
target_link_libraries(bundler_serve_test PRIVATE bundler GTest::gtest_main)
gtest_discover_tests(bundler_serve_test TEST_PREFIX bundler. DISCOVERY_TIMEOUT 60)
