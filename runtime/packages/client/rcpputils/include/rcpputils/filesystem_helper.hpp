// Paths, under the name that older ROS packages use.
#pragma once

#include <filesystem>

namespace rcpputils {
namespace fs = std::filesystem;
}  // namespace rcpputils
