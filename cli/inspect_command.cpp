// `ros2wasm inspect version|spec|match|archive|lock`: what the parsers make of a text or a file,
// one JSON object a line.
#include <poll.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <charconv>
#include <filesystem>
#include <memory>
#include <utility>

#include "bundler/archive/package_listing.hpp"
#include "bundler/io/files.hpp"
#include "bundler/io/sha256.hpp"
#include "bundler/resolve/locked_solve.hpp"
#include "bundler/resolve/solve.hpp"
#include "bundler/workspace/foreign_environment.hpp"
#include "cli/arguments.hpp"
#include "cli/console.hpp"
#include "workspace_schema/base/json_writer.hpp"
#include "workspace_schema/conda/match_spec.hpp"
#include "workspace_schema/conda/version.hpp"
#include "workspace_schema/schema/lock.hpp"

namespace ros2wasm {
namespace {

struct InspectOptions {
  std::string what;
  std::string file;
  std::string environment;
  std::string archive_limits;
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
  for (const auto& [key, value] : spec->fields()) json.field(key, value);
  json.end_object().end_object();
  return json.text();
}

/// Build strings end with their number by custom: "py39_1".
std::uint64_t number_of_build(std::string_view build) {
  const std::size_t digits = build.find_last_not_of("0123456789") + 1;
  std::uint64_t number = 0;
  std::from_chars(build.data() + digits, build.data() + build.size(), number);
  return number;
}

/// "spec<TAB>version<TAB>build": for a package of the spec's name, channel and so on, about which
/// the line says nothing.
std::string match_line(const std::string& input) {
  const std::size_t first = input.find('\t');
  const std::size_t second = first == std::string::npos ? first : input.find('\t', first + 1);
  if (first == std::string::npos) {
    return failed(input, {usage_error("the line is not of the form spec<TAB>version<TAB>build")});
  }
  const auto spec = MatchSpec::parse(std::string_view(input).substr(0, first));
  if (!spec) return failed(input, spec.errors());
  const std::string_view rest = std::string_view(input).substr(first + 1);
  const auto version = Version::parse(rest.substr(0, rest.find('\t')));
  if (!version) return failed(input, version.errors());
  const std::string_view build =
      second == std::string::npos ? std::string_view() : std::string_view(input).substr(second + 1);
  JsonWriter json;
  json.begin_object()
      .field("input", input)
      .field_boolean("matches", spec->matches_build(*version, build, number_of_build(build)))
      .end_object();
  return json.text();
}

/// Answers all lines of one read with one write: a program can exchange single lines through pipes,
/// and a million lines do not cost a million writes.
int each_line(Context& context, std::string (*answer)(const std::string&)) {
  constexpr std::size_t kLongestLine = 1 << 20;
  std::string pending;
  std::string chunk(1 << 16, '\0');
  std::string answers;
  bool passing_over = false;
  const auto take_line = [&](std::string line) {
    if (line.ends_with('\r')) line.pop_back();
    answers += answer(line) + "\n";
  };
  for (;;) {
    std::array<pollfd, 2> ready{
        {{.fd = STDIN_FILENO, .events = POLLIN, .revents = 0},
         {.fd = context.cancellation.wake_fd(), .events = POLLIN, .revents = 0}}};
    const int polled = ::poll(ready.data(), ready.size(), -1);
    if (context.cancellation.requested()) return context.console.fail({interrupted()});
    if (polled < 0 && errno == EINTR) continue;
    const ssize_t count = ::read(STDIN_FILENO, chunk.data(), chunk.size());
    if (count <= 0) break;
    std::string_view rest(chunk.data(), static_cast<std::size_t>(count));
    for (std::size_t end = rest.find('\n'); end != std::string_view::npos; end = rest.find('\n')) {
      pending += rest.substr(0, end);
      rest.remove_prefix(end + 1);
      if (!std::exchange(passing_over, false)) take_line(std::move(pending));
      pending.clear();
    }
    if (!passing_over) pending += rest;
    if (pending.size() > kLongestLine) {
      answers += failed(pending.substr(0, 100), {usage_error("the line is too long")}) + "\n";
      pending.clear();
      passing_over = true;
    }
    context.console.result_text(std::exchange(answers, {}));
  }
  if (!pending.empty()) take_line(std::move(pending));
  context.console.result_text(answers);
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

int inspect_archive(Context& context, const InspectOptions& options) {
  const std::string& file = options.file;
  const auto limits = extract_limits_of(options.archive_limits, context.environment);
  if (!limits) return context.console.fail(limits.errors());
  const auto hashes = hash_file(file);
  if (!hashes) return context.console.fail(hashes.errors());
  const auto listing = list_package(file, *limits);
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
  json.end_array().key("has_file_hashes").boolean(listing->has_hashes);
  json.key("faults").begin_array();
  for (const ListingFault& fault : listing->faults) {
    json.begin_object().field("path", fault.path).field("reason", fault.reason).end_object();
  }
  json.end_array().key("entry_points").begin_array();
  for (const EntryPoint& one : listing->entry_points) {
    json.begin_object().field("command", one.command).field("module", one.module);
    json.field("function", one.function).end_object();
  }
  json.end_array().key("link_scripts").begin_array();
  for (const std::string& path : listing->link_scripts) json.string(path);
  json.end_array().end_object();
  context.console.result(json.text());
  return listing->faults.empty() ? 0 : 1;
}

struct LockedPackages {
  std::vector<PackageRecord> packages;
  std::vector<PackageRecord> built_here;  ///< as in RepoIndex
};

/// The packages of a lock, ours or another tool's.
Outcome<LockedPackages> locked_packages(const InspectOptions& options) {
  const auto text = read_file(options.file, kMostOfList);
  if (!text) return text.errors();
  if (std::filesystem::path(options.file).filename() == kLockFileName) {
    auto lock = read_lock(*text, options.file);
    if (!lock) return std::move(lock).errors();
    LockedPackages result{.packages = std::move(lock->packages), .built_here = {}};
    for (const std::string& one : lock->built_here) {
      const std::size_t space = std::min(one.find(' '), one.size());
      result.built_here.push_back({.name = one.substr(0, space),
                                   .version = one.substr(std::min(space + 1, one.size())),
                                   .build = "workspace"});
    }
    return result;
  }
  auto foreign = read_foreign_environment(*text, options.file, options.environment);
  if (!foreign) return std::move(foreign).errors();
  return LockedPackages{.packages = std::move(foreign->packages), .built_here = {}};
}

/// Whether all that each package needs and allows is so.
int inspect_lock(Context& context, const InspectOptions& options) {
  const auto locked = locked_packages(options);
  if (!locked) return context.console.fail(locked.errors());
  const Diagnostics faults = check_solution({}, locked->packages, locked->built_here);
  JsonWriter json;
  json.begin_object().field("lock", options.file);
  json.key("packages").unsigned_integer(locked->packages.size()).key("faults").begin_array();
  for (const Diagnostic& one : faults) json.string(one.message);
  json.end_array().end_object();
  context.console.result(json.text());
  return faults.empty() ? 0 : 1;
}

int run(const InspectOptions& options, Context& context) {
  if (options.what == "lock") {
    if (options.file.empty())
      return context.console.fail(usage_error("`ros2wasm inspect lock` takes a file"));
    return inspect_lock(context, options);
  }
  if (options.what == "archive") {
    if (options.file.empty())
      return context.console.fail(usage_error("`ros2wasm inspect archive` takes a file"));
    return inspect_archive(context, options);
  }
  if (options.what == "version") return each_line(context, version_line);
  if (options.what == "spec") return each_line(context, spec_line);
  if (options.what == "match") return each_line(context, match_line);
  return context.console.fail(
      usage_error("`ros2wasm inspect` knows version, spec, match, archive and lock, not `" +
                  options.what + "`"));
}

}  // namespace

CommandBody inspect_command(Arguments& arguments) {
  const auto options = std::make_shared<InspectOptions>();
  arguments.required(
      "WHAT", options->what,
      "`version` and `spec` read lines from stdin; `match` reads spec<TAB>version<TAB>build; "
      "`archive` looks into a file; `lock` checks every dependency of a lock");
  arguments.optional("FILE", options->file,
                     "for `archive`: a .conda or .tar.bz2 file; for `lock`: a ros2wasm.lock, "
                     "pixi.lock or conda-lock file");
  arguments.value("--environment", options->environment, "NAME",
                  "for `lock`: which environment of a pixi.lock");
  arguments.value("--archive-limits", options->archive_limits, "LIMITS",
                  "for `archive`: what it may unpack to: size=8G,members=500000,ratio=250");
  arguments.examples({"echo 1.0rc1 | ros2wasm inspect version",
                      "ros2wasm inspect archive demo-1.0-0.conda",
                      "ros2wasm inspect lock pixi.lock --environment wasm"});
  return [options](Context& context) { return run(*options, context); };
}

}  // namespace ros2wasm
