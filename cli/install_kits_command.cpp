// `ros2wasm install-kits`: what the build of a channel runs when a package is installed, so that
// its programs can be linked again with the plugins of a workspace. Not for people.
#include <memory>

#include "bundler/build/link_kit.hpp"
#include "cli/arguments.hpp"
#include "cli/console.hpp"

namespace ros2wasm {
namespace {

struct Options {
  std::string package;
  std::string kits;
  std::string tree;
  std::string environment;
};

}  // namespace

CommandBody install_kits_command(Arguments& arguments) {
  const auto options = std::make_shared<Options>();
  arguments.value("--package", options->package, "NAME", "the package that was installed");
  arguments.value("--kits", options->kits, "DIR", "what the links of its build have left");
  arguments.value("--tree", options->tree, "DIR", "where it was installed");
  arguments.value("--environment", options->environment, "DIR", "the packages it was built with");
  return [options](Context& context) {
    const auto done =
        install_movable_kits(options->kits, options->tree, options->package, options->environment);
    return done.ok() ? 0 : context.console.fail(done.errors());
  };
}

}  // namespace ros2wasm
