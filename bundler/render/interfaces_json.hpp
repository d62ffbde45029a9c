// interfaces.json: type name -> text of its definition. Pure.
#pragma once

#include <string>

#include "bundler/workspace/installed_tree.hpp"

namespace ros2wasm {

[[nodiscard]] std::string interfaces_json(const InterfaceTexts& interfaces);

}  // namespace ros2wasm
