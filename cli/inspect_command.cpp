// `ros2wasm inspect version|spec|match|archive`: what the parsers make of a text or a file, one
// JSON object a line.
#include <charconv>
#include <iostream>
#include <memory>

#include "bundler/archive/package_listing.hpp"
#include "bundler/io/sha256.hpp"
#include "cli/arguments.hpp"
#include "cli/console.hpp"
#include "workspace_schema/json_writer.hpp"
#include "workspace_schema/match_spec.hpp"
#include "workspace_schema/version.hpp"

namespace ros2wasm {
namespace {

struct InspectOptions {
  std::string what;
  std::string file;
};

Diagnostic usage_error(std::string message) {
  return Diagnostic{.code = "R2W0902",
                    .kind = FailureKind::kCommandLine,
                    .message = std::move(message),
                    .why = {"`ros2wasm inspect --help` has examples"}};
}

std::string failed(const std::string& input, const Diagnostics& errors) {
  JsonWriter json;
  json.begin_object().field("input", input).field("error", errors.front().message).end_object();
  return json.text();
}

std::string version_line(const std::string& input) {
  const auto version = Version::parse(input);
  if (!version) return failed(input, version.errors());
  std::string out =
      "{\"input\":" + json_quoted(input) + ",\"parsed\":" + version_json(version->segments());
  if (!version->local().empty()) out += ",\"local\":" + version_json(version->local());
  return out + "}";
}

std::string spec_line(const std::string& input) {
  const auto spec = MatchSpec::parse(input);
  if (!spec) return failed(input, spec.errors());
  JsonWriter json;
  json.begin_object().field("input", input).key("parsed").begin_object();
  json.field("name", spec->name().text());
  if (!spec->version().any()) json.field("version", spec->version().text());
  if (spec->build()) json.field("build", spec->build()->text());
  if (spec->channel()) json.field("channel", spec->channel()->text());
  if (!spec->subdir().empty()) json.field("subdir", spec->subdir());
  json.end_object().end_object();
  return json.text();
}

/// A name that the spec matches: its own, with nothing in place of each `*`.
std::string fitting_name(const MatchSpec& spec) {
  std::string name = spec.name().text();
  std::erase(name, '*');
  return name.empty() ? "package" : name;
}

/// Build strings end with their number by custom: "py39_1".
std::uint64_t number_of_build(std::string_view build) {
  const std::size_t digits = build.find_last_not_of("0123456789") + 1;
  std::uint64_t number = 0;
  std::from_chars(build.data() + digits, build.data() + build.size(), number);
  return number;
}

/// "spec<TAB>version<TAB>build", as if the package had the spec's name.
std::string match_line(const std::string& input) {
  const std::size_t first = input.find('\t');
  const std::size_t second = first == std::string::npos ? first : input.find('\t', first + 1);
  if (first == std::string::npos) {
    return failed(input, {usage_error("the line is not of the form spec<TAB>version<TAB>build")});
  }
  const auto spec = MatchSpec::parse(input.substr(0, first));
  if (!spec) return failed(input, spec.errors());
  PackageRecord record{
      .name = fitting_name(*spec),
      .version = input.substr(first + 1, second == std::string::npos ? second : second - first - 1),
      .build = second == std::string::npos ? std::string() : input.substr(second + 1)};
  record.build_number = number_of_build(record.build);
  const auto version = Version::parse(record.version);
  if (!version) return failed(input, version.errors());
  JsonWriter json;
  json.begin_object()
      .field("input", input)
      .field_boolean("matches", spec->matches(record, *version))
      .end_object();
  return json.text();
}

int each_line(Context& context, std::string (*answer)(const std::string&)) {
  for (std::string line; std::getline(std::cin, line);) {
    if (line.ends_with('\r')) line.pop_back();
    context.console.result(answer(line));
  }
  return 0;
}

std::string_view kind_word(MemberKind kind) {
  switch (kind) {
    case MemberKind::kFile:
      return "file";
    case MemberKind::kLink:
      return "link";
    case MemberKind::kHardLink:
      return "hard_link";
    case MemberKind::kDirectory:
      return "directory";
    case MemberKind::kOther:
      return "other";
  }
  return "other";
}

int inspect_archive(Context& context, const std::string& file) {
  const auto hashes = hash_file(file);
  if (!hashes) return context.console.fail(hashes.errors());
  const auto listing = list_package(file);
  if (!listing) return context.console.fail(listing.errors());
  JsonWriter json;
  json.begin_object().field("archive", file).field("sha256", hashes->sha256);
  json.key("size").unsigned_integer(hashes->size).key("members").begin_array();
  for (const ListedMember& member : listing->members) {
    json.begin_object().field("path", member.path).field("kind", kind_word(member.kind));
    if (member.kind == MemberKind::kFile) {
      json.key("size").unsigned_integer(member.size).field("sha256", member.sha256);
    }
    if (!member.target.empty()) json.field("target", member.target);
    json.end_object();
  }
  json.end_array().key("faults").begin_array();
  for (const ListingFault& fault : listing->faults) {
    json.begin_object().field("path", fault.path).field("reason", fault.reason).end_object();
  }
  json.end_array().end_object();
  context.console.result(json.text());
  return listing->faults.empty() ? 0 : 1;
}

int run(const InspectOptions& options, Context& context) {
  if (options.what == "archive") {
    if (options.file.empty())
      return context.console.fail(usage_error("`ros2wasm inspect archive` takes a file"));
    return inspect_archive(context, options.file);
  }
  if (options.what == "version") return each_line(context, version_line);
  if (options.what == "spec") return each_line(context, spec_line);
  if (options.what == "match") return each_line(context, match_line);
  return context.console.fail(usage_error(
      "`ros2wasm inspect` knows version, spec, match and archive, not `" + options.what + "`"));
}

}  // namespace

CommandBody inspect_command(Arguments& arguments) {
  const auto options = std::make_shared<InspectOptions>();
  arguments.required(
      "WHAT", options->what,
      "`version` and `spec` read lines from stdin; `match` reads spec<TAB>version<TAB>build; "
      "`archive` looks into a file");
  arguments.optional("FILE", options->file, "for `archive`: a .conda or .tar.bz2 file");
  arguments.examples(
      {"echo 1.0rc1 | ros2wasm inspect version", "ros2wasm inspect archive demo-1.0-0.conda"});
  return [options](Context& context) { return run(*options, context); };
}

}  // namespace ros2wasm
