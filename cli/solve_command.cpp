// `ros2wasm solve --channel DIR SPEC...`: what the resolver chooses, without a workspace.
#include <memory>

#include "bundler/channel/channel_index.hpp"
#include "bundler/resolve/solve.hpp"
#include "cli/arguments.hpp"
#include "cli/channel_choice.hpp"
#include "cli/console.hpp"
#include "workspace_schema/base/json_writer.hpp"

namespace ros2wasm {
namespace {

struct SolveOptions {
  ChannelChoice choice;
  std::vector<std::string> specs;
  std::string priority = "strict";
};

void put_record(JsonWriter& json, const PackageRecord& record) {
  json.begin_object()
      .field("name", record.name)
      .field("version", record.version)
      .field("build", record.build);
  json.key("build_number").unsigned_integer(record.build_number);
  json.field("subdir", record.subdir)
      .field("channel", record.channel)
      .field("file", record.file_name);
  json.field("url", record.url).field("sha256", record.sha256).field("md5", record.md5);
  json.key("size").unsigned_integer(record.size).key("depends").begin_array();
  for (const std::string& spec : record.depends) json.string(spec);
  json.end_array().end_object();
}

void show(Context& context, const Resolution& resolution, const RepoIndex& index) {
  if (!context.json) {
    for (const PackageRecord& record : resolution.packages) {
      context.console.result(record.name + " " + record.version + " " + record.build + "  " +
                             record.url);
    }
    return;
  }
  JsonWriter json;
  json.begin_object().key("packages").begin_array();
  for (const PackageRecord& record : resolution.packages) put_record(json, record);
  json.end_array().key("left_out").begin_array();
  std::vector<LeftOutRecord> left_out = index.left_out;
  left_out.insert(left_out.end(), resolution.left_out.begin(), resolution.left_out.end());
  for (const LeftOutRecord& record : left_out) {
    json.begin_object().field("channel", record.channel).field("subdir", record.subdir);
    json.field("file", record.file_name).field("reason", record.reason).end_object();
  }
  json.end_array().end_object();
  context.console.result(json.text());
}

int run(const SolveOptions& options, Context& context) {
  std::vector<std::string> specs = options.specs;
  const auto open = open_chosen_channels(options.choice, specs, context);
  if (!open) return context.console.fail(open.errors());
  ResolveRequest request{
      .specs = {}, .locked = {}, .priority = channel_priority_of(options.priority)};
  const auto index = open->reachable(specs, request.priority, context.cancellation);
  if (!index) return context.console.fail(index.errors());
  for (const std::string& text : specs)
    request.specs.push_back({.text = text, .origin = {}, .span = {}});
  const auto resolution = solve(request, *index, {.cancellation = context.cancellation});
  if (!resolution) return context.console.fail(resolution.errors());
  show(context, *resolution, *index);
  return 0;
}

}  // namespace

CommandBody solve_command(Arguments& arguments) {
  const auto options = std::make_shared<SolveOptions>();
  arguments.values(
      "-c,--channel", options->choice.channels, "CHANNEL",
      "A folder, an address, or a name such as conda-forge; the embedded channel if none");
  arguments.value("--platform", options->choice.platform, "SUBDIR",
                  "read this folder of the channels beside noarch (default: emscripten-wasm32)");
  arguments.flag("--offline", options->choice.offline, "use only what is on this machine");
  arguments.choice("--priority", options->priority,
                   {kChannelPriorityWords.begin(), kChannelPriorityWords.end()},
                   "What the order of channels means");
  arguments.rest("SPEC", options->specs, "conda match specs: \"ros-jazzy-rclcpp >=28\"");
  arguments.examples({"ros2wasm solve ros-jazzy-std-msgs",
                      "ros2wasm solve --channel my-channel --json \"demo >=1,<2\""});
  return [options](Context& context) { return run(*options, context); };
}

}  // namespace ros2wasm
