// Names of libraries, as the system has them.
#pragma once

#include <string>

namespace BT {

class SharedLibrary {
 public:
  [[nodiscard]] static std::string prefix() { return "lib"; }
  [[nodiscard]] static std::string suffix() { return ".so"; }
  [[nodiscard]] static std::string getOSName(const std::string& name) {
    return prefix() + name + suffix();
  }
};

}  // namespace BT
