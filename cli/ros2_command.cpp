// `ros2wasm ros2 SITE ...`: a command of `ros2` on the nodes of a packed site, in Node.js.
#include <iostream>
#include <memory>

#include "bundler/run/exec_program.hpp"
#include "bundler/run/headless_command.hpp"
#include "bundler/run/node_js.hpp"
#include "bundler/serve/site_responder.hpp"
#include "cli/arguments.hpp"
#include "cli/console.hpp"

namespace ros2wasm {
namespace {

struct Options {
  std::string site;
  std::string link;
  std::vector<std::string> words;
};

int run_ros2(Context& context, const Options& options) {
  Diagnostics errors;
  const auto add = [&errors](const Diagnostics& some) {
    errors.insert(errors.end(), some.begin(), some.end());
  };
  if (const auto site = check_site(options.site); !site) add(site.errors());
  const auto program = find_headless_program(context.executable, kRos2Role);
  if (!program) add(program.errors());
  const auto node_js =
      find_node_js(context.executable, context.variable("PATH"), context.cancellation);
  if (!node_js) add(node_js.errors());
  if (!errors.empty()) return context.console.fail(errors);
  std::vector<std::string> words = {node_js->string(), program->string()};
  if (!options.link.empty()) {
    words.insert(words.end(), {"--link", options.link});
  }
  words.push_back(options.site);
  words.insert(words.end(), options.words.begin(), options.words.end());
  std::cout.flush();
  return context.console.fail(exec_program(std::move(words)));
}

}  // namespace

CommandBody ros2_command(Arguments& arguments) {
  const auto options = std::make_shared<Options>();
  arguments.choice("--link", options->link, {"shared", "port"},
                   "how nodes reach each other; shared when not given");
  arguments.required("SITE", options->site, "the folder that `ros2wasm pack` wrote");
  arguments.raw_rest(options->words);
  arguments.examples({"ros2wasm ros2 site topic list -t",
                      "ros2wasm ros2 site topic echo --once /chatter",
                      "ros2wasm ros2 site service call /add_two_ints "
                      "example_interfaces/srv/AddTwoInts '{a: 1, b: 2}'",
                      "ros2wasm ros2 site --help   (the commands of ros2)"});
  return [options](Context& context) { return run_ros2(context, *options); };
}

}  // namespace ros2wasm
