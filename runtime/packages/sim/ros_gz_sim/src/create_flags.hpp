// The flags of `create`, as gflags reads them: with one dash or two, unknown ones are skipped.
// Pure.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace ros_gz_sim {

struct CreateFlags {
  std::string world, file, param, string, topic, name;
  bool allow_renaming = false;
  double x = 0, y = 0, z = 0, roll = 0, pitch = 0, yaw = 0;
  std::string fault;  ///< what is wrong with them; empty: nothing
};

/// `words`: without the program's name and without what is for ROS.
CreateFlags read_create_flags(const std::vector<std::string>& words);

}  // namespace ros_gz_sim
