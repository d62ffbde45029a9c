// The requirements that the wheels of a manifest meet, and those that they request from the
// channels. Pure.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "bundler/store/wheel_files.hpp"
#include "bundler/workspace/channel_request.hpp"

namespace ros2wasm {

/// Adds what each wheel requires that no other of them is, and no library of `libraries`. R2W0520,
/// a warning: no channel has it either. Whether a program needs it shows when its imports are
/// followed.
void add_wheel_request(const std::vector<NamedWheel>& wheels, const KnownNames& known,
                       std::string_view distro, const std::vector<LockedLibrary>& libraries,
                       ChannelRequest& request);

/// The channel package of a Python project or module: by its rosdep key, by its own name, or by
/// that of a ROS package. Empty: none of `names` (sorted).
[[nodiscard]] std::string python_package_name(std::string_view project,
                                              const std::vector<std::string>& names,
                                              std::string_view distro);

/// Takes away what wheels bring: dependencies by a project's name or rosdep key
/// (`python3-<project>`), and modules.
void drop_met_by_wheels(const std::vector<NamedWheel>& wheels, std::string_view distro,
                        std::vector<LocalPackage>& packages);

}  // namespace ros2wasm
