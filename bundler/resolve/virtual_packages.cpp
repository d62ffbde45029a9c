// See virtual_packages.hpp.
#include "bundler/resolve/virtual_packages.hpp"

namespace ros2wasm {

std::vector<PackageRecord> virtual_packages() {
  return {
      PackageRecord{.name = "__archspec", .version = "0", .build = "wasm32", .subdir = "noarch"},
      PackageRecord{.name = "__unix", .version = "0", .build = "0", .subdir = "noarch"}};
}

}  // namespace ros2wasm
