// interfaces.json: type name -> text of its definition. Pure.
#pragma once

#include <string>

#include "bundler/plan/site_plan.hpp"

namespace ros2wasm {

[[nodiscard]] std::string interfaces_json(const InterfaceTexts& interfaces);

}  // namespace ros2wasm
