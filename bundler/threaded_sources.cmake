# What runs in several threads, below bundler/. Its tests are linked with these compiled once more for the thread sanitizer
# (tests/unit/bundler/threads_tests.cmake), in place of the library's, which are objects of their own therefore.
set(threaded_sources
  build/build_workspace.cpp
  channel/read_in_parts.cpp
  io/process.cpp
  io/worker_pool.cpp
  store/cache_care.cpp
  store/store.cpp
  store/tree_seal.cpp
)
