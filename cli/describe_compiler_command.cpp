// `ros2wasm describe-compiler`: the build string of the package emscripten-abi for the compiler
// that is found. runtime/channel/build_channel.py asks; not for people.
#include "bundler/build/compiler_parts.hpp"
#include "cli/arguments.hpp"
#include "cli/console.hpp"

namespace ros2wasm {

CommandBody describe_compiler_command(Arguments&) {
  return [](Context& context) {
    const auto compiler = find_compiler(context.environment);
    if (!compiler) return context.console.fail(compiler.errors());
    context.console.result(abi_build(find_compiler_parts(compiler->home, context.environment), {}));
    return 0;
  };
}

}  // namespace ros2wasm
