// Public data of conda that is not in the repository. tests/tools/run_tests.py says where it is and
// runs these tests only then; a file that is not there fails its test.
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace ros2wasm::testing {

inline std::filesystem::path conda_data(const std::string& name) {
  const char* folder = std::getenv("ROS2WASM_CONDA_DATA");
  if (folder == nullptr) {
    ADD_FAILURE() << "ROS2WASM_CONDA_DATA does not say where the public data of conda is";
    return {};
  }
  return std::filesystem::path(folder) / name;
}

inline std::string conda_text(const std::string& name) {
  std::ifstream stream(conda_data(name), std::ios::binary);
  EXPECT_TRUE(stream.good()) << name << " is not there";
  return {std::istreambuf_iterator<char>(stream), {}};
}

}  // namespace ros2wasm::testing
