// `ros2wasm pack [WORKSPACE]`: from a ROS 2 workspace to a site.
#include <memory>

#include "bundler/course.hpp"
#include "bundler/emit/precompressed.hpp"
#include "bundler/pipeline.hpp"
#include "bundler/plan/shipped_channel.hpp"
#include "cli/arguments.hpp"
#include "cli/console.hpp"
#include "cli/signing_key.hpp"
#include "workspace_schema/base/json_writer.hpp"

namespace ros2wasm {
namespace {

struct Options {
  std::string input;
  std::string output = "site";
  bool locked = false;
  bool frozen = false;
  bool offline = false;
  bool with_channel = false;
  bool plan = false;
  int jobs = 0;
  bool quick = false;
  bool strict = false;
  std::string archive_limits;
  std::string store;
  bool prune = false;
  SigningChoice signing;
  bool precompress = false;
  int max_file_size = 0;
};

constexpr std::uint64_t kMegabyte = 1000000;

std::string column(std::uint64_t size) {
  std::string text = std::to_string(size);
  if (text.size() < 9) text.insert(0, 9 - text.size(), ' ');
  return text;
}

void print_plan(Console& console, const SitePlan& plan) {
  for (const PlannedFile& file : plan.files) {
    console.result(column(file.bytes.size()) + "  " + file.sha256.substr(0, 12) + "  " + file.path +
                   "  (" + file.reason + ")");
  }
  for (const ChannelFile& file : plan.channel) {
    console.result(column(file.size) + "  beside site   " + file.path + "  (" + file.reason + ")");
  }
}

void print_json(Console& console, const PackReport& report, bool written) {
  JsonWriter json;
  json.begin_object();
  if (written) json.field("site", report.output.string());
  json.field("sha256", report.plan.sha256);
  json.key("files").begin_array();
  for (const PlannedFile& file : report.plan.files) {
    json.begin_object().field("path", file.path);
    json.key("size").unsigned_integer(file.bytes.size());
    json.field("sha256", file.sha256).field("reason", file.reason).end_object();
  }
  json.end_array();
  if (!report.plan.channel.empty()) {
    json.key("channel").begin_array();
    for (const ChannelFile& file : report.plan.channel) {
      json.begin_object().field("path", file.path);
      json.key("size").unsigned_integer(file.size);
      json.field("reason", file.reason).end_object();
    }
    json.end_array();
  }
  json.end_object();
  console.result(json.text());
}

std::string kilobytes(std::uint64_t bytes) {
  return std::to_string((bytes + 999) / 1000) + " kB";
}

int run_course(Context& context, const CourseRequest& request) {
  const auto report = pack_course(request, context.cancellation, context.progress);
  if (!report) return context.console.fail(report.errors());
  Console& console = context.console;
  for (const Diagnostic& warning : report->warnings) console.report(warning);
  for (const std::string& remark : report->remarks) console.remark(remark);
  if (context.json) {
    JsonWriter json;
    json.begin_object().field("course", request.pack.output.string());
    json.field("sha256", report->sha256).key("bytes").unsigned_integer(report->bytes);
    json.key("labs").begin_array();
    for (const PackedLab& lab : report->labs) {
      json.begin_object().field("name", lab.name).field("title", lab.title);
      json.field("sha256", lab.sha256).end_object();
    }
    json.end_array().end_object();
    console.result(json.text());
    return 0;
  }
  for (const PackedLab& lab : report->labs)
    console.remark(lab.name + " sha256 " + lab.sha256 + ", " + lab.title);
  console.remark(std::to_string(report->labs.size()) + " labs, " + kilobytes(report->bytes) +
                 (report->removed == 0 ? "" : ", " + kilobytes(report->removed) + " were removed"));
  console.remark("sha256 " + report->sha256);
  console.result(request.pack.output.string());
  return 0;
}

/// R2W0902: options that do not go together.
std::optional<Diagnostic> unsuited(const Options& options) {
  const auto refused = [](std::string message, std::string why, std::string fix) {
    return Diagnostic{.code = "R2W0902",
                      .kind = FailureKind::kCommandLine,
                      .message = std::move(message),
                      .why = {std::move(why)},
                      .fix = {std::move(fix)}};
  };
  const bool courses = is_course(options.input);
  const std::string form = std::filesystem::path(options.output).extension().string();
  const std::string folder = "choose a name with -o that does not end in " + form;
  if (courses && !options.signing.key_file.empty()) {
    return refused("--sign is for sites",
                   "a course has many, and its list of them would not be signed",
                   "sign each lab: `minisign -S -m COURSE/LAB/site.json`");
  }
  if (options.precompress && (form == ".zip" || form == ".html")) {
    return refused("--precompress is for folders", "an archive or a page has no files beside it",
                   folder);
  }
  if (options.max_file_size != 0 && form == ".html")
    return refused("--max-file-size is for folders and archives", "a page is one file", folder);
  if (!courses && options.prune) {
    return refused("--prune is for courses", "only a course knows all sites of its store",
                   "remove the folder of an earlier pack, SITE@HASH, by hand");
  }
  return std::nullopt;
}

int run(Context& context, const Options& options) {
  // Before a password is asked for.
  if (const auto refused = unsuited(options)) return context.console.fail(*refused);
  const auto signer = read_signer(options.signing, context);
  if (!signer) return context.console.fail(signer.errors());
  const PackRequest request{
      .input = options.input,
      .output = options.output,
      .locked = options.locked,
      .frozen = options.frozen,
      .offline = options.offline,
      .with_channel = options.with_channel,
      .plan_only = options.plan,
      .executable = context.executable,
      .variables = context.environment,
      .jobs = static_cast<unsigned>(options.jobs),
      .quick = options.quick,
      .strict = options.strict,
      .store = options.store,
      .max_file_size = kMegabyte * static_cast<std::uint64_t>(options.max_file_size),
      .precompress = options.precompress,
      .archive_limits = options.archive_limits,
      .signer = *signer};
  if (is_course(options.input))
    return run_course(context, {.pack = request, .prune = options.prune});
  const auto report = pack(request, context.cancellation, context.progress);
  if (!report) return context.console.fail(report.errors());
  if (options.precompress && !options.plan) {
    if (auto done = precompress_site(report->output, context.cancellation); !done)
      return context.console.fail(done.errors());
  }
  for (const Diagnostic& warning : report->notes.warnings) context.console.report(warning);
  for (const std::string& remark : report->notes.remarks) context.console.remark(remark);
  if (context.json) {
    print_json(context.console, *report, !options.plan);
  } else if (options.plan) {
    print_plan(context.console, report->plan);
  } else {
    const std::uint64_t names = names_size(report->plan);
    context.console.remark(
        std::to_string(report->plan.nodes.size()) + " nodes, " +
        std::to_string(report->plan.files.size()) + " files, " +
        kilobytes(total_size(report->plan) - names) +
        (names == 0 ? "" : ", and " + kilobytes(names) + " of names for crash reports"));
    if (const std::uint64_t channel = channel_size(report->plan); channel != 0) {
      context.console.remark("the packages are in " + (report->output / kShippedChannel).string() +
                             ", " + kilobytes(channel));
    }
    context.console.remark("sha256 " + report->plan.sha256);
    if (*signer) context.console.remark("signed with the key " + key_id_text((*signer)->key.id));
    context.console.result(report->output.string());
  }
  return 0;
}

}  // namespace

CommandBody pack_command(Arguments& arguments) {
  const auto options = std::make_shared<Options>();
  arguments.optional(
      "WORKSPACE", options->input,
      "a workspace.yaml, a folder with ROS 2 packages (default: the current folder), or a "
      "course.yaml");
  arguments.value(
      "-o,--output", options->output, "FOLDER",
      "where to write the site (default: site); NAME.zip: as one archive, NAME.html: as one "
      "page");
  arguments.flag("--locked", options->locked, "fail rather than change ros2wasm.lock");
  arguments.flag("--frozen", options->frozen,
                 "take packages from ros2wasm.lock only, ask no channel and leave the lock alone");
  arguments.flag("--offline", options->offline, "use only what is on this machine");
  arguments.flag("--with-channel", options->with_channel,
                 "put the packages into SITE/channel, a channel to pack from again");
  arguments.value("--store", options->store, "FOLDER",
                  "keep files there that sites share, by their sha256, and earlier packs beside "
                  "the site");
  arguments.flag("--prune", options->prune,
                 "of a course: remove earlier packs of its labs, and what only they have");
  arguments.number("--max-file-size", options->max_file_size, "MB", 1, 100000,
                   "split larger files into parts, for hosts that limit the size of a file");
  arguments.flag("--precompress", options->precompress,
                 "put NAME.br and NAME.gz beside files, for hosts that send them in their place");
  arguments.flag("--plan", options->plan,
                 "print every file with size, hash and reason; write no site");
  arguments.flag("--quick", options->quick,
                 "link in a fraction of the time, without wasm-opt: larger programs");
  arguments.flag("--strict", options->strict,
                 "fail when the launch file starts what no site can start");
  arguments.number("-j,--jobs", options->jobs, "N", 1, 256,
                   "compilers at once (default: one per processor)");
  arguments.value("--archive-limits", options->archive_limits, "LIMITS",
                  "what archives may unpack to: size=8G,members=500000,ratio=250");
  arguments.value("--sign", options->signing.key_file, "KEYFILE",
                  "sign the site with a secret key of minisign");
  arguments.value("--sign-comment", options->signing.comment, "TEXT",
                  "what the signature says too (default: the site's sha256)");
  arguments.number("--password-fd", options->signing.password_fd, "N", 0, 1023,
                   "read the key's password from this file descriptor (else: "
                   "ROS2WASM_KEY_PASSWORD, or the terminal)");
  arguments.examples({"ros2wasm pack examples/01_talker_listener/workspace.yaml -o site",
                      "ros2wasm pack ~/ros2_ws --plan",
                      "ros2wasm pack --sign ~/.minisign/minisign.key"});
  return [options](Context& context) { return run(context, *options); };
}

}  // namespace ros2wasm
