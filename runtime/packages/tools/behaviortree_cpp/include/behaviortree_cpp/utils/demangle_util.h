// Names of types as people write them.
#pragma once

#include <string>
#include <typeindex>

namespace BT {

[[nodiscard]] std::string demangle(const std::type_index& index);

}  // namespace BT
