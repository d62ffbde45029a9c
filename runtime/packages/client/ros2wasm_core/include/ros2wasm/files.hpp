// File operations of a program other than reading and writing.
#pragma once

#include <string>

namespace ros2wasm {

/// Hands a copy of a file that the program has written to whoever runs the site, who may keep it.
/// Nothing happens where there is no such file.
void give_file(const std::string& path);

}  // namespace ros2wasm
