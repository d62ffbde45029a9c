// `ros2wasm rebuild SITE`: whether a site is what the sources that it carries make.
#include <memory>

#include "bundler/rebuild.hpp"
#include "cli/arguments.hpp"
#include "cli/console.hpp"
#include "workspace_schema/base/json_writer.hpp"

namespace ros2wasm {
namespace {

struct Options {
  std::string site;
  std::string workspace;
  std::string output;
  bool offline = false;
  int jobs = 0;
  std::string archive_limits;
};

Diagnostic other_site(const RebuildReport& report) {
  constexpr std::size_t kShown = 10;
  Diagnostic fault{.code = "R2W0663",
                   .message = "the sources make another site: sha256 " + report.made,
                   .why = {"this one is " + report.sha256},
                   .fix = {"keep the new one with `-o FOLDER`, and see `ros2wasm diff SITE FOLDER`",
                           "another ros2wasm, compiler or runtime makes other bytes"}};
  const std::string own = "ros2wasm " ROS2WASM_VERSION;
  if (report.generator != own)
    fault.why.push_back("it was packed by " + report.generator + ", and this is " + own);
  const auto& all = report.differences;
  for (std::size_t i = 0; i < all.size() && i < kShown; ++i)
    fault.why.push_back(difference_line(all[i]));
  if (all.size() > kShown)
    fault.why.push_back("and " + std::to_string(all.size() - kShown) + " more files");
  return fault;
}

int run(Context& context, const Options& options) {
  const auto report = rebuild({.site = options.site,
                               .workspace = options.workspace,
                               .output = options.output,
                               .offline = options.offline,
                               .jobs = static_cast<unsigned>(options.jobs),
                               .archive_limits = options.archive_limits,
                               .executable = context.executable,
                               .variables = context.environment},
                              context.cancellation, context.progress);
  if (!report) return context.console.fail(report.errors());
  for (const Diagnostic& warning : report->warnings) context.console.report(warning);
  for (const std::string& remark : report->remarks) context.console.remark(remark);
  const bool same = report->differences.empty();
  if (context.json) {
    JsonWriter json;
    json.begin_object().field("site", options.site).field("sha256", report->sha256);
    json.field("made", report->made).field_boolean("same", same);
    json.key("differences").begin_array();
    write_differences(json, report->differences);
    json.end_array().end_object();
    context.console.result(json.text());
  }
  if (!same) return context.console.fail(other_site(*report));
  if (!context.json) {
    context.console.result(options.site + ": its sources make the same site");
    context.console.result("sha256 " + report->sha256);
  }
  return 0;
}

}  // namespace

CommandBody rebuild_command(Arguments& arguments) {
  const auto options = std::make_shared<Options>();
  arguments.required("SITE", options->site, "folder of a site, or NAME.zip");
  arguments.value("--workspace", options->workspace, "FOLDER",
                  "make it from this workspace and its lock, and not from what the site carries");
  arguments.value("-o,--output", options->output, "FOLDER",
                  "where to keep the new site (default: nowhere)");
  arguments.flag("--offline", options->offline, "use only what is on this machine");
  arguments.number("-j,--jobs", options->jobs, "N", 1, 256,
                   "compilers at once (default: one per processor)");
  arguments.examples({"ros2wasm rebuild site", "ros2wasm rebuild lab.zip -o again",
                      "ros2wasm rebuild site --workspace ."});
  return [options](Context& context) { return run(context, *options); };
}

}  // namespace ros2wasm
