// `ros2wasm run SITE`: the nodes of a packed site in Node.js, for CI and for a look without a
// browser.
#include <iostream>
#include <memory>

#include "bundler/run/duration.hpp"
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
  std::optional<std::string> limit;
  std::optional<std::string> until;
  std::string link;
};

std::string path_variable(const Context& context) {
  const auto found = context.environment.find("PATH");
  return found == context.environment.end() ? std::string() : found->second;
}

void add_errors(Diagnostics& all, const Diagnostics& some) {
  all.insert(all.end(), some.begin(), some.end());
}

int run_site(Context& context, const Options& options) {
  Diagnostics errors;
  HeadlessRun run{.site = options.site,
                  .limit = std::nullopt,
                  .until = options.until,
                  .link = options.link,
                  .json = context.json};
  if (options.limit) {
    const auto limit = parse_duration(*options.limit);
    if (limit) {
      run.limit = *limit;
    } else {
      add_errors(errors, limit.errors());
    }
  }
  if (const auto site = check_site(options.site); !site) add_errors(errors, site.errors());
  const auto program = find_headless_program(context.executable);
  if (!program) add_errors(errors, program.errors());
  const auto node_js =
      find_node_js(context.executable, path_variable(context), context.cancellation);
  if (!node_js) add_errors(errors, node_js.errors());
  if (node_js && run.until) {
    const auto pattern = check_pattern(*node_js, *run.until, context.cancellation);
    if (!pattern) add_errors(errors, pattern.errors());
  }
  if (!errors.empty()) return context.console.fail(errors);
  std::cout.flush();
  return context.console.fail(exec_program(headless_command(*node_js, *program, run)));
}

}  // namespace

CommandBody run_command(Arguments& arguments) {
  const auto options = std::make_shared<Options>();
  arguments.required("SITE", options->site, "the folder that `ros2wasm pack` wrote");
  arguments.value("--for", options->limit, "TIME",
                  "stop after this time: 500ms, 5s, 2m; with --until, fail when it was not met");
  arguments.value("--until", options->until, "REGEX",
                  "stop with exit code 0 when a line of output matches (JavaScript syntax)");
  arguments.choice("--link", options->link, {"shared", "port"},
                   "how nodes reach each other; chosen by itself when not given");
  arguments.examples({"ros2wasm run site", "ros2wasm run site --for 5s",
                      "ros2wasm run site --until 'I heard' --for 30s"});
  return [options](Context& context) { return run_site(context, *options); };
}

}  // namespace ros2wasm
