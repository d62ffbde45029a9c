// See launch_arguments.hpp.
#include "cli/launch_arguments.hpp"

namespace ros2wasm {

Outcome<std::map<std::string, std::string>> launch_arguments_of(
    const std::vector<std::string>& given) {
  std::map<std::string, std::string> result;
  for (const std::string& one : given) {
    const std::size_t at = one.find(":=");
    if (at == 0 || at == std::string::npos) {
      return Diagnostic{.code = "R2W0902",
                        .kind = FailureKind::kCommandLine,
                        .message = "`" + one + "` is not a launch argument",
                        .why = {"write it as name:=value"}};
    }
    result[one.substr(0, at)] = one.substr(at + 2);
  }
  return result;
}

}  // namespace ros2wasm
