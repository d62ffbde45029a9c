// `ros2wasm channel build WORKSPACE -o DIR`, `add DIR ...`, `index DIR` and `check DIR`: make conda
// channels, and look what is in them.
#include <charconv>
#include <memory>

#include "bundler/channel/channel_writer.hpp"
#include "bundler/io/files.hpp"
#include "cli/arguments.hpp"
#include "cli/channel_build.hpp"
#include "cli/channel_choice.hpp"
#include "cli/console.hpp"
#include "workspace_schema/base/json_reader.hpp"
#include "workspace_schema/base/json_writer.hpp"

namespace ros2wasm {
namespace {

struct ChannelOptions {
  std::string action;
  std::vector<std::string> words;
  std::string prefix;
  std::string metadata;
  std::string name;
  std::string version;
  std::string build;
  std::string build_number;
  std::vector<std::string> depends;
  std::vector<std::string> constrains;
  std::string license;
  std::vector<std::string> license_files;
  std::string summary;
  std::string subdir;
  std::string placeholder;
  bool noarch = false;
  bool all = false;
  ChannelBuildOptions built;  // but for the words
};

Diagnostic usage_error(std::string message, std::string why) {
  return Diagnostic{.code = "R2W0902",
                    .kind = FailureKind::kCommandLine,
                    .message = std::move(message),
                    .why = {std::move(why)}};
}

std::vector<std::string> text_list(const JsonValue& json, std::string_view key) {
  std::vector<std::string> list;
  if (const JsonValue* value = json.find(key)) {
    for (const JsonValue& item : value->items()) {
      if (const std::string* text = item.string()) list.push_back(*text);
    }
  }
  return list;
}

/// Reads a metadata file: the keys are CondaPackage's members.
Outcome<CondaPackage> read_metadata(const std::string& file) {
  const auto text = read_file(file, kMostOfList);
  if (!text) return text.errors();
  const auto json = parse_json(*text, file, "R2W0205");
  if (!json) return json.errors();
  CondaPackage package{.name = json->text_of("name"),
                       .version = json->text_of("version"),
                       .build = json->text_of("build"),
                       .subdir = json->text_of("subdir"),
                       .depends = text_list(*json, "depends"),
                       .constrains = text_list(*json, "constrains"),
                       .entry_points = text_list(*json, "entry_points"),
                       .license = json->text_of("license"),
                       .summary = json->text_of("summary"),
                       .home = json->text_of("home")};
  if (json->text_of("noarch") == "python") package.noarch = NoarchKind::kPython;
  for (const std::string& path : text_list(*json, "license_files"))
    package.license_files.emplace_back(path);
  if (const JsonValue* number = json->find("build_number")) {
    package.build_number = number->unsigned_integer().value_or(0);
  }
  if (const JsonValue* time = json->find("timestamp_ms"))
    package.timestamp_ms = time->integer().value_or(0);
  return package;
}

void override_with(std::string& target, const std::string& given) {
  if (!given.empty()) target = given;
}

/// The metadata file, with what the command line says on top.
Outcome<CondaPackage> package_of(const ChannelOptions& options) {
  CondaPackage package;
  if (!options.metadata.empty()) {
    auto read = read_metadata(options.metadata);
    if (!read) return read;
    package = std::move(*read);
  }
  override_with(package.name, options.name);
  override_with(package.version, options.version);
  override_with(package.build, options.build);
  override_with(package.license, options.license);
  override_with(package.summary, options.summary);
  override_with(package.subdir, options.noarch ? "noarch" : options.subdir);
  if (package.subdir.empty()) package.subdir = "emscripten-wasm32";
  if (package.subdir == "noarch" && package.noarch == NoarchKind::kNo)
    package.noarch = NoarchKind::kGeneric;
  if (!options.depends.empty()) package.depends = options.depends;
  if (!options.constrains.empty()) package.constrains = options.constrains;
  for (const std::string& path : options.license_files) package.license_files.emplace_back(path);
  package.placeholder = options.placeholder;
  if (!options.build_number.empty()) {
    const char* end = options.build_number.data() + options.build_number.size();
    const auto read = std::from_chars(options.build_number.data(), end, package.build_number);
    if (read.ec != std::errc() || read.ptr != end) {
      return usage_error("`--build-number " + options.build_number + "` is not a number",
                         "it counts from 0");
    }
  }
  return package;
}

int report_path(Context& context, const std::filesystem::path& archive) {
  if (context.json) {
    JsonWriter json;
    json.begin_object().field("archive", archive.string()).end_object();
    context.console.result(json.text());
  } else {
    context.console.result(archive.string());
  }
  return 0;
}

int add(const ChannelOptions& options, Context& context) {
  if (options.words.size() == 2 && options.prefix.empty()) {
    const auto archive = copy_to_channel(options.words[0], options.words[1]);
    return archive ? report_path(context, *archive) : context.console.fail(archive.errors());
  }
  if (options.words.size() != 1 || options.prefix.empty()) {
    return context.console.fail(usage_error(
        "`ros2wasm channel add` takes a channel and an archive, or a channel and --prefix",
        "`ros2wasm channel --help` has examples"));
  }
  const auto package = package_of(options);
  if (!package) return context.console.fail(package.errors());
  const auto archive = add_to_channel(options.words[0], *package, options.prefix);
  return archive ? report_path(context, *archive) : context.console.fail(archive.errors());
}

int index(const ChannelOptions& options, Context& context) {
  if (options.words.size() != 1) {
    return context.console.fail(usage_error("`ros2wasm channel index` takes one channel folder",
                                            "`ros2wasm channel --help` has examples"));
  }
  const auto summary =
      index_channel(options.words[0], options.all ? Reading::kAll : Reading::kChanged);
  if (!summary) return context.console.fail(summary.errors());
  if (context.json) {
    JsonWriter json;
    json.begin_object()
        .key("packages")
        .unsigned_integer(summary->packages)
        .key("read")
        .unsigned_integer(summary->read)
        .key("subdirs")
        .begin_array();
    for (const std::string& subdir : summary->subdirs) json.string(subdir);
    json.end_array().end_object();
    context.console.result(json.text());
  } else {
    context.console.remark("indexed " + std::to_string(summary->packages) + " packages in " +
                           options.words[0] + ", " + std::to_string(summary->read) +
                           " of them read");
  }
  return 0;
}

/// Prints the records of a channel that the resolver would skip, and the reasons.
int check(const ChannelOptions& options, Context& context) {
  if (options.words.size() != 1) {
    return context.console.fail(
        usage_error("`ros2wasm channel check` takes one channel folder or address",
                    "`ros2wasm channel --help` has examples"));
  }
  const auto open = open_chosen_channels({.channels = options.words}, {}, context);
  if (!open) return context.console.fail(open.errors());
  const auto channel = open->everything(context.cancellation);
  if (!channel) return context.console.fail(channel.errors());
  if (context.json) {
    JsonWriter json;
    json.begin_object().key("records").unsigned_integer(channel->records.size());
    json.key("left_out").begin_array();
    for (const LeftOutRecord& record : channel->left_out) {
      json.begin_object().field("subdir", record.subdir).field("file", record.file_name);
      json.field("reason", record.reason).end_object();
    }
    json.end_array().end_object();
    context.console.result(json.text());
  } else {
    for (const LeftOutRecord& record : channel->left_out)
      context.console.result(record.subdir + "/" + record.file_name + ": " + record.reason);
    context.console.remark(std::to_string(channel->records.size()) + " records can be used, " +
                           std::to_string(channel->left_out.size()) + " are skipped");
  }
  return channel->left_out.empty() ? 0 : 1;
}

}  // namespace

CommandBody channel_command(Arguments& arguments) {
  const auto options = std::make_shared<ChannelOptions>();
  arguments.required(
      "ACTION", options->action,
      "`build` makes a channel of a workspace, of .repos files or of packages of a distribution; "
      "`add` puts a package into a channel, `index` writes its index, `check` lists the records "
      "that cannot be used");
  arguments.rest(
      "WORDS", options->words,
      "the channel's folder; behind it, for `add`, an archive. For `build`, a workspace, "
      "or .repos files and names of packages");
  arguments.text("-o,--output", options->built.output, "DIR",
                 "for `build`: the channel's folder; what it has stays");
  arguments.text("--distribution", options->built.distribution, "FILE",
                 "for `build`: a distribution file of rosdistro, a path or an address");
  arguments.text("--report", options->built.report, "FILE",
                 "for `build`: write what became of each package, as JSON or, in a .md file, "
                 "as Markdown");
  arguments.flag("--locked", options->built.locked,
                 "for `build`: fail rather than change ros2wasm.lock");
  arguments.flag("--offline", options->built.offline,
                 "for `build`: nothing comes over the network");
  arguments.number("-j,--jobs", options->built.jobs, "N", 1, 256,
                   "for `build`: compilers at once (default: one per processor)");
  arguments.value("--prefix", options->prefix, "TREE", "Pack the files of this folder");
  arguments.value("--metadata", options->metadata, "FILE",
                  "JSON with name, version, build, build_number, subdir, depends, noarch ...");
  arguments.value("--name", options->name, "NAME", "Package name");
  arguments.value("--version", options->version, "VERSION", "Package version");
  arguments.text("--build", options->build, "STRING", "Build string");
  arguments.value("--build-number", options->build_number, "N", "Build number");
  arguments.values("--depends", options->depends, "SPEC", "A package that this one needs");
  arguments.values("--constrains", options->constrains, "SPEC",
                   "What another package must be if it is there");
  arguments.text("--license", options->license, "SPDX", "License expression");
  arguments.values("--license-file", options->license_files, "FILE", "A file for info/licenses");
  arguments.text("--summary", options->summary, "TEXT", "One line about the package");
  arguments.value("--subdir", options->subdir, "SUBDIR",
                  "emscripten-wasm32 (the default) or another platform");
  arguments.text(
      "--placeholder", options->placeholder, "PATH",
      "The prefix that the files were installed for; it is replaced where text files name it");
  arguments.flag("--noarch", options->noarch, "The package is for every platform");
  arguments.flag(
      "--all", options->all,
      "for `index`: read every archive, not only those which changed since the last time");
  arguments.examples({"ros2wasm channel build course_ws -o my-channel",
                      "ros2wasm channel build course.repos -o my-channel --report report.md",
                      "ros2wasm channel build nav2_map_server --distribution distribution.yaml -o "
                      "my-channel",
                      "ros2wasm channel add my-channel --prefix stage --metadata package.json",
                      "ros2wasm channel add my-channel demo-1.0-0.conda",
                      "ros2wasm channel index my-channel", "ros2wasm channel check my-channel"});
  return [options](Context& context) {
    if (options->action == "build") {
      options->built.words = options->words;
      return run_channel_build(options->built, context);
    }
    if (options->action == "add") return add(*options, context);
    if (options->action == "index") return index(*options, context);
    if (options->action == "check") return check(*options, context);
    return context.console.fail(
        usage_error("`ros2wasm channel` has no action `" + options->action + "`",
                    "the actions are: build, add, index, check"));
  };
}

}  // namespace ros2wasm
