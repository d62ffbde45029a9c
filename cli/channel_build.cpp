// See channel_build.hpp.
#include "cli/channel_build.hpp"

#include <filesystem>

#include "bundler/channel_build.hpp"
#include "bundler/io/files.hpp"
#include "cli/console.hpp"
#include "workspace_schema/base/names.hpp"
#include "workspace_schema/schema/named_source.hpp"

namespace ros2wasm {
namespace fs = std::filesystem;
namespace {

Diagnostic refused(std::string message, std::string why, std::string fix) {
  return Diagnostic{.code = "R2W0902",
                    .kind = FailureKind::kCommandLine,
                    .message = std::move(message),
                    .why = {std::move(why)},
                    .fix = {std::move(fix)}};
}

NamedSource source_of(SourceKind kind, const std::string& place) {
  return {.kind = kind,
          .place = place,
          .revision = {},
          .sha256 = {},
          .name = source_name(place),
          .repos = {},
          .packages = {},
          .package_places = {},
          .span = {.file = place, .line_text = {}}};
}

/// Sources are relative to the manifest, of which there is none.
Outcome<std::string> whole_place(const std::string& place) {
  if (is_web_place(place)) return place;
  const auto whole = absolute_path(place);
  if (!whole) return whole.errors();
  return whole->string();
}

/// Sorts the words into a workspace, .repos files and names.
class Words {
 public:
  explicit Words(const ChannelBuildOptions& options) : options_(options) {}

  Outcome<ChannelBuildRequest> request() {
    if (options_.output.empty())
      return refused("`ros2wasm channel build` needs a place for the channel", "there is no -o",
                     "ros2wasm channel build WORKSPACE -o my-channel");
    for (const std::string& word : options_.words)
      if (auto done = take(word); !done) return std::move(done).errors();
    if (auto done = take_distribution(); !done) return std::move(done).errors();
    if (!workspace_.empty() && !request_.pack.more_sources.empty())
      return refused("a workspace and other sources are named at once",
                     "`" + workspace_ + "` is a workspace, which names its own sources",
                     "write them into its workspace.yaml, below `sources:`");
    request_.channel = options_.output;
    const bool has_sources = !request_.pack.more_sources.empty();
    request_.pack.input = has_sources ? options_.output : workspace_;
    request_.pack.locked = options_.locked;
    request_.pack.offline = options_.offline;
    request_.pack.jobs = static_cast<unsigned>(options_.jobs);
    return std::move(request_);
  }

 private:
  Outcome<Done> take(const std::string& word) {
    std::error_code error;
    const bool is_file = fs::exists(word, error);
    if (word.ends_with(".repos")) {
      auto place = whole_place(word);
      if (!place) return std::move(place).errors();
      request_.pack.more_sources.push_back(source_of(SourceKind::kRepos, *place));
      return Done{};
    }
    if (is_file) {
      if (!workspace_.empty())
        return refused("two workspaces are named: `" + workspace_ + "` and `" + word + "`",
                       "a channel is built from one at a time; it can be added to",
                       "ros2wasm channel build " + workspace_ + " -o " + options_.output);
      workspace_ = word;
      return Done{};
    }
    if (const auto fault = package_name_fault(word))
      return refused("`" + word + "` is neither a file nor the name of a package", fault->why,
                     "ros2wasm channel build WORKSPACE -o " + options_.output);
    request_.names.push_back(word);
    return Done{};
  }

  Outcome<Done> take_distribution() {
    if (request_.names.empty() && options_.distribution.empty()) return Done{};
    if (request_.names.empty())
      return refused("no package is named",
                     "a distribution has hundreds; those that are named are built",
                     "ros2wasm channel build NAME --distribution " + options_.distribution +
                         " -o " + options_.output);
    if (options_.distribution.empty())
      return refused("`" + request_.names.front() + "` is not a file or folder here",
                     "packages are built by name when a distribution says where their sources are",
                     "--distribution distribution.yaml");
    auto place = whole_place(options_.distribution);
    if (!place) return std::move(place).errors();
    NamedSource source = source_of(SourceKind::kDistribution, *place);
    source.packages = request_.names;
    for (std::size_t i = 0; i < request_.names.size(); ++i)
      source.package_places.push_back(source.span);
    request_.pack.more_sources.push_back(std::move(source));
    return Done{};
  }

  const ChannelBuildOptions& options_;
  ChannelBuildRequest request_;
  std::string workspace_;
};

void print(const ChannelBuildReport& report, Console& console) {
  for (const ChannelPackage& one : report.packages) {
    if (one.state == ChannelPackageState::kAdded && !console.json()) console.result(one.archive);
    for (const Diagnostic& error : one.errors) console.report(error);
  }
  for (const ChannelPackage& one : report.packages) {
    if (one.state == ChannelPackageState::kFailed)
      console.remark("failed: " + one.name);
    else if (one.state == ChannelPackageState::kSkipped)
      console.remark("skipped: " + one.name +
                     (one.reason.empty() ? "" : ": " + one.reason.front()));
  }
}

}  // namespace

int run_channel_build(const ChannelBuildOptions& options, Context& context) {
  auto request = Words(options).request();
  if (!request) return context.console.fail(request.errors());
  request->pack.executable = context.executable;
  request->pack.variables = context.environment;
  const auto report = build_channel(*request, context.cancellation, context.progress);
  if (!report) return context.console.fail(report.errors());
  for (const Diagnostic& warning : report->warnings) context.console.report(warning);
  print(*report, context.console);
  for (const std::string& remark : report->remarks) context.console.remark(remark);
  const std::string json = channel_report_json(*report);
  if (context.json) context.console.result(json);
  if (!options.report.empty()) {
    const bool is_markdown = options.report.ends_with(".md");
    const auto written =
        write_file(options.report, is_markdown ? channel_report_markdown(*report) : json + "\n");
    if (!written) return context.console.fail(written.errors());
  }
  Diagnostics errors;
  for (const ChannelPackage& one : report->packages)
    errors.insert(errors.end(), one.errors.begin(), one.errors.end());
  return errors.empty() ? 0 : exit_code_of(errors);
}

}  // namespace ros2wasm
