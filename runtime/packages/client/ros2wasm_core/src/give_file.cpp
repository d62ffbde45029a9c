// See files.hpp.
#include "ros2wasm/files.hpp"

#include <filesystem>
#include <fstream>
#include <system_error>

#include "ros2wasm/host.h"

namespace ros2wasm {

void give_file(const std::string& path) {
  std::error_code missing;
  const auto size = std::filesystem::file_size(path, missing);
  if (missing) {
    return;
  }
  std::string bytes(static_cast<size_t>(size), '\0');
  std::ifstream file(path, std::ios::binary);
  if (file.read(bytes.data(), static_cast<std::streamsize>(bytes.size()))) {
    const std::string name = std::filesystem::absolute(path).lexically_normal().generic_string();
    ros2wasm_file_give(name.data(), name.size(), bytes.data(), bytes.size());
  }
}

}  // namespace ros2wasm
