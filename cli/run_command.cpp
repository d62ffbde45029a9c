// `ros2wasm run SITE`: the nodes of a packed site in Node.js, for CI and for a look without a
// browser.
#include <iostream>
#include <memory>

#include "bundler/run/exec_program.hpp"
#include "bundler/run/headless_command.hpp"
#include "bundler/run/node_js.hpp"
#include "bundler/serve/site_responder.hpp"
#include "cli/arguments.hpp"
#include "cli/console.hpp"
#include "cli/launch_arguments.hpp"
#include "workspace_schema/base/duration.hpp"

namespace ros2wasm {
namespace {

struct Options {
  std::string site;
  std::optional<std::string> limit;
  std::optional<std::string> until;
  std::string link;
  bool stepped = false;
  std::optional<int> seed;
  std::optional<std::string> trace;
  std::optional<std::string> bags;
  bool checks = false;
  std::optional<std::string> junit;
  std::vector<std::string> given;
  bool show_arguments = false;
};

void add_errors(Diagnostics& all, const Diagnostics& some) {
  all.insert(all.end(), some.begin(), some.end());
}

int run_site(Context& context, const Options& options) {
  Diagnostics errors;
  HeadlessRun run{.site = options.site,
                  .limit = std::nullopt,
                  .until = options.until,
                  .link = options.link,
                  .stepped = options.stepped || options.seed.has_value(),
                  .seed = options.seed,
                  .trace = options.trace,
                  .bags = options.bags,
                  .checks = options.checks || options.junit.has_value(),
                  .junit = options.junit,
                  .json = context.json,
                  .given = options.given,
                  .show_arguments = options.show_arguments};
  if (options.limit) {
    const auto limit = parse_duration(*options.limit);
    if (limit) {
      run.limit = *limit;
    } else {
      add_errors(errors, limit.errors());
    }
  }
  if (const auto given = launch_arguments_of(options.given); !given)
    add_errors(errors, given.errors());
  if (const auto site = check_site(options.site); !site) add_errors(errors, site.errors());
  const auto program = find_headless_program(context.executable);
  if (!program) add_errors(errors, program.errors());
  const auto node_js =
      find_node_js(context.executable, context.variable("PATH"), context.cancellation);
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
  arguments.rest("NAME:=VALUE", options->given, "launch arguments");
  arguments.flag("--show-args", options->show_arguments,
                 "show the launch arguments of the site, and start nothing");
  arguments.value(
      "--for", options->limit, "TIME",
      "stop this time after the first node begins to run: 500ms, 5s, 2m; with --until, fail when "
      "it was not met");
  arguments.value("--until", options->until, "REGEX",
                  "stop with exit code 0 when a line of output matches (JavaScript syntax)");
  arguments.choice("--link", options->link, {"shared", "port"},
                   "how nodes reach each other; chosen by itself when not given");
  arguments.flag(
      "--stepped", options->stepped,
      "run one node at a time, and let time jump to what is waited for: every run of a seed "
      "sends the same messages; --for is the site's time then");
  arguments.number(
      "--seed", options->seed, "N", 0, 999999999,
      "of the nodes' random numbers in a stepped run (implies --stepped); 0 when not given");
  arguments.value("--trace", options->trace, "FILE",
                  "write every message that a node sends to FILE, and its sha256 to the console");
  arguments.value("--bags", options->bags, "DIR",
                  "write the bags that nodes write, and files of Python nodes, to DIR, in a folder "
                  "for each node");
  arguments.flag("--checks", options->checks,
                 "stop when the checks of the manifest are decided; 1 when one failed");
  arguments.value("--junit", options->junit, "FILE",
                  "write the result of the checks to FILE as JUnit XML (implies --checks)");
  arguments.examples({"ros2wasm run site", "ros2wasm run site --for 5s",
                      "ros2wasm run site robot:=r2", "ros2wasm run site --checks",
                      "ros2wasm run site --until 'I heard' --for 30s"});
  return [options](Context& context) { return run_site(context, *options); };
}

}  // namespace ros2wasm
