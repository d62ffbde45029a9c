// See exec_program.hpp.
#include "bundler/run/exec_program.hpp"

#include <signal.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

namespace ros2wasm {

Diagnostic exec_program(std::vector<std::string> arguments) {
  std::vector<char*> pointers;
  pointers.reserve(arguments.size() + 1);
  for (std::string& argument : arguments) pointers.push_back(argument.data());
  pointers.push_back(nullptr);
  execv(pointers.front(), pointers.data());
  return Diagnostic{.code = "R2W0910",
                    .kind = FailureKind::kEnvironment,
                    .message = "cannot run `" + arguments.front() + "`",
                    .why = {std::strerror(errno)}};  // NOLINT(concurrency-mt-unsafe)
}

}  // namespace ros2wasm
