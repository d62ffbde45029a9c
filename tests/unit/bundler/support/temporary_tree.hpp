// A folder of files for one test, removed at the end.
#pragma once

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include <stdlib.h>

namespace ros2wasm::testing {

class TemporaryTree {
 public:
  TemporaryTree() {
    std::string path = (std::filesystem::temp_directory_path() / "ros2wasm-test-XXXXXX").string();
    root_ = ::mkdtemp(path.data());
  }
  TemporaryTree(const TemporaryTree&) = delete;
  TemporaryTree& operator=(const TemporaryTree&) = delete;
  ~TemporaryTree() {
    std::error_code ignored;
    std::filesystem::remove_all(root_, ignored);
  }

  [[nodiscard]] const std::filesystem::path& root() const { return root_; }
  [[nodiscard]] std::filesystem::path operator/(const std::string& relative) const {
    return root_ / relative;
  }

  /// Writes a file below the root and returns its path.
  std::filesystem::path write(const std::string& relative, const std::string& text) const {
    const auto file = root_ / relative;
    std::filesystem::create_directories(file.parent_path());
    std::ofstream(file, std::ios::binary) << text;
    return file;
  }

  [[nodiscard]] std::string read(const std::string& relative) const {
    std::ifstream stream(root_ / relative, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }

 private:
  std::filesystem::path root_;
};

}  // namespace ros2wasm::testing
