// See git.hpp.
#include "bundler/io/git.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <chrono>
#include <map>

#include "bundler/io/files.hpp"
#include "bundler/io/process.hpp"
#include "workspace_schema/base/suggestion.hpp"

namespace ros2wasm {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostOutput = std::size_t{256} << 20U;
/// A small delta can stand for a large object, which git makes in memory.
constexpr std::uint64_t kMostMemory = std::uint64_t{8} << 30U;
/// Its own time; ten times as much by the clock (see Patience).
constexpr std::chrono::minutes kMostTime{12};
constexpr std::size_t kHashDigits = 40;
/// Where a fetched commit is named.
constexpr const char* kWanted = "refs/ros2wasm/wanted";

/// Variables by which a surrounding git would lead this one elsewhere.
constexpr auto kVariablesOfGit = std::to_array<const char*>(
    {"GIT_ALTERNATE_OBJECT_DIRECTORIES", "GIT_ATTR_SOURCE", "GIT_COMMON_DIR", "GIT_CONFIG",
     "GIT_CONFIG_COUNT", "GIT_CONFIG_PARAMETERS", "GIT_CONFIG_SYSTEM", "GIT_DEFAULT_HASH",
     "GIT_DEFAULT_REF_FORMAT", "GIT_EXEC_PATH", "GIT_GRAFT_FILE", "GIT_INDEX_FILE", "GIT_NAMESPACE",
     "GIT_OBJECT_DIRECTORY", "GIT_PROXY_COMMAND", "GIT_QUARANTINE_PATH", "GIT_SHALLOW_FILE",
     "GIT_TEMPLATE_DIR", "GIT_WORK_TREE"});

/// Nothing of the user's settings counts, so that the same revision is the same files everywhere;
/// keys and agents of ssh do, without questions.
std::map<std::string, std::string> environment_of_git(const fs::path& folder) {
  // Versions of git that do not know GIT_CONFIG_GLOBAL look into HOME, as .netrc is looked for.
  const std::string home = folder.parent_path().string();
  return {{"GIT_DIR", folder.string()},
          {"HOME", home},
          {"XDG_CONFIG_HOME", home},
          {"GIT_CONFIG_NOSYSTEM", "1"},
          {"GIT_CONFIG_GLOBAL", "/dev/null"},
          {"GIT_ATTR_NOSYSTEM", "1"},
          {"GIT_TERMINAL_PROMPT", "0"},
          {"GIT_ASKPASS", "true"},
          {"SSH_ASKPASS", "true"},
          {"GIT_SSH_COMMAND", "ssh -oBatchMode=yes -oConnectTimeout=30 -oServerAliveInterval=15"},
          {"GIT_ALLOW_PROTOCOL", "file:http:https:ssh"},
          {"GIT_NO_REPLACE_OBJECTS", "1"},
          {"LC_ALL", "C"}};
}

/// Hostile objects are refused when they come. Old trees with modes of a leading zero are harmless,
/// and in many repositories.
constexpr auto kSettings = std::to_array<const char*>(
    {"core.hooksPath=/dev/null", "core.attributesFile=/dev/null", "core.excludesFile=/dev/null",
     "core.autocrlf=false", "core.symlinks=true", "core.fsmonitor=false",
     "credential.helper=", "fetch.fsckObjects=true", "fetch.fsck.zeroPaddedFilemode=ignore",
     "gc.auto=0", "maintenance.auto=false", "protocol.version=2", "submodule.recurse=false",
     "http.lowSpeedLimit=1000", "http.lowSpeedTime=60", "core.packedGitLimit=1g",
     "advice.detachedHead=false"});

/// The lines that git wrote, without those that only repeat the failure.
std::vector<std::string> reasons_in(std::string_view text) {
  std::vector<std::string> reasons;
  constexpr std::size_t kMost = 4;
  while (!text.empty() && reasons.size() < kMost) {
    const std::size_t end = text.find('\n');
    const std::string_view line = text.substr(0, end);
    text = end == std::string_view::npos ? std::string_view() : text.substr(end + 1);
    if (!line.empty()) reasons.push_back("git: " + std::string(line));
  }
  return reasons;
}

Diagnostic cannot_fetch(const std::string& address, std::string_view said) {
  Diagnostic made{.code = "R2W0251",
                  .kind = FailureKind::kEnvironment,
                  .message = "the git repository `" + address + "` cannot be fetched",
                  .why = reasons_in(said)};
  if (said.find("dubious ownership") != std::string_view::npos)
    made.fix.emplace_back(
        "name its path with `folder:` in place of `git:`; its files are then taken as they are");
  return made;
}

std::string without_end(std::string text) {
  while (text.ends_with('\n')) text.pop_back();
  return text;
}

/// "100644 blob HASH    SIZE\tPATH"; nothing when it is not such a line.
std::optional<GitEntry> entry_of(std::string_view line) {
  const std::size_t tab = line.find('\t');
  if (tab == std::string_view::npos || line.size() < 7) return std::nullopt;
  GitEntry entry{.path = std::string(line.substr(tab + 1)), .kind = {}, .object = {}, .size = 0};
  const std::string_view mode = line.substr(0, 6);
  if (mode == "120000") {
    entry.kind = GitObjectKind::kLink;
  } else if (mode == "160000") {
    entry.kind = GitObjectKind::kCommit;
  } else if (mode == "100755") {
    entry.kind = GitObjectKind::kExecutable;
  } else if (!mode.starts_with("100")) {
    return std::nullopt;
  }
  const std::string_view rest = line.substr(7, tab - 7);  // "blob HASH    SIZE"
  const std::size_t hash = rest.find(' ');
  if (hash == std::string_view::npos || rest.size() < hash + 1 + kHashDigits) return std::nullopt;
  entry.object = std::string(rest.substr(hash + 1, kHashDigits));
  const std::size_t size = rest.find_last_of(' ') + 1;
  std::from_chars(rest.data() + size, rest.data() + rest.size(), entry.size);  // "-" of a commit
  return entry;
}

}  // namespace

bool is_commit_hash(std::string_view text) {
  return text.size() == kHashDigits &&
         text.find_first_not_of("0123456789abcdef") == std::string_view::npos;
}

Outcome<GitRepository::Answer> GitRepository::run(std::vector<std::string> arguments) const {
  std::vector<std::string> command{"env"};
  for (const char* variable : kVariablesOfGit) command.insert(command.end(), {"-u", variable});
  command.emplace_back("git");
  for (const char* setting : kSettings) command.insert(command.end(), {"-c", setting});
  for (std::string& one : arguments) command.push_back(std::move(one));
  auto result = run_process({.arguments = std::move(command),
                             .environment = environment_of_git(folder_),
                             .directory = {},
                             .output_mode = OutputMode::kCapture,
                             .on_output = {},
                             .time_limit = kMostTime,
                             .most_output = kMostOutput,
                             .largest_file = most_bytes_,
                             .most_memory = kMostMemory},
                            cancellation_);
  if (!result) return std::move(result).errors();
  if (result->is_out_of_room)
    result->error += "stopped: it wrote more than " + std::to_string(kMostOutput) + " bytes\n";
  if (result->is_out_of_time) result->error += "stopped: it did not finish in time\n";
  result->error += said_of_signal(*result);
  return Answer{.exit_code = result->exit_code,
                .output = std::move(result->output),
                .error = std::move(result->error)};
}

Outcome<std::string> GitRepository::output_of(std::vector<std::string> arguments) const {
  auto answer = run(std::move(arguments));
  if (!answer) return std::move(answer).errors();
  if (answer->exit_code != 0) return cannot_fetch(address_, answer->error);
  return std::move(answer->output);
}

Outcome<GitRepository> GitRepository::make(const std::string& address, const fs::path& folder,
                                           std::uint64_t most_bytes,
                                           const Cancellation& cancellation) {
  if (!find_program("git"))
    return Diagnostic{.code = "R2W0910",
                      .kind = FailureKind::kEnvironment,
                      .message = "cannot run `git`",
                      .why = {"`sources:` of the manifest names a git repository"},
                      .fix = {"sudo apt-get install git"}};
  if (auto made = make_directories(folder.parent_path()); !made) return std::move(made).errors();
  GitRepository repository(address, folder, most_bytes, cancellation);
  auto made = repository.output_of({"init", "--quiet", "--bare", "--template=", folder.string()});
  if (!made) return std::move(made).errors();
  return repository;
}

Outcome<GitRepository::Answer> GitRepository::bring(const std::string& what) const {
  return run({"fetch", "--quiet", "--depth=1", "--no-tags", "--no-recurse-submodules", "--",
              address_, "+" + what + ":" + kWanted});
}

/// R2W0252, with the nearest name that the repository has.
Diagnostic GitRepository::no_such_revision(const std::string& revision) const {
  Diagnostic made{
      .code = "R2W0252",
      .message = "the git repository `" + address_ + "` has no revision `" + revision + "`"};
  const auto answer = run({"ls-remote", "--quiet", "--heads", "--tags", "--refs", "--", address_});
  std::vector<std::string> names;
  std::string_view rest =
      answer && answer->exit_code == 0 ? std::string_view(answer->output) : std::string_view();
  while (!rest.empty()) {
    const std::size_t end = rest.find('\n');
    const std::string_view line = rest.substr(0, end);
    rest = end == std::string_view::npos ? std::string_view() : rest.substr(end + 1);
    for (const std::string_view kind : {"refs/heads/", "refs/tags/"}) {
      const std::size_t at = line.find(kind);
      if (at != std::string_view::npos) names.emplace_back(line.substr(at + kind.size()));
    }
  }
  if (const auto near = nearest(revision, names))
    made.fix.push_back("write `revision: " + *near + "`");
  if (!names.empty()) made.why.push_back("it has: " + name_list(names, 12));
  if (is_commit_hash(revision)) {
    made.why.emplace_back("a commit that no tag or branch leads to any more is gone");
  } else if (revision.find_first_not_of("0123456789abcdef") == std::string::npos) {
    made.why.emplace_back("a commit is named by all 40 digits of its hash");
  }
  return made;
}

Outcome<std::string> GitRepository::fetch(const std::string& revision) const {
  auto answer = bring(revision.empty() ? "HEAD" : revision);
  if (!answer) return std::move(answer).errors();
  if (answer->exit_code != 0 && is_commit_hash(revision)) {
    // A server may give only what a name leads to: then all of that, with its history.
    answer = run({"fetch", "--quiet", "--no-recurse-submodules", "--", address_,
                  "+refs/heads/*:refs/heads/*", "+refs/tags/*:refs/tags/*"});
    if (!answer) return std::move(answer).errors();
    if (answer->exit_code != 0) return cannot_fetch(address_, answer->error);
    const auto there = run({"cat-file", "-e", revision + "^{commit}"});
    if (!there) return there.errors();
    if (there->exit_code != 0) return no_such_revision(revision);
    return revision;
  }
  if (answer->exit_code != 0) {
    if (answer->error.find("couldn't find remote ref") != std::string::npos)
      return revision.empty()
                 ? cannot_fetch(address_, "it is empty, or has no default branch\n" + answer->error)
                 : no_such_revision(revision);
    return cannot_fetch(address_, answer->error);
  }
  const auto commit = run({"rev-parse", "--verify", "--quiet", std::string(kWanted) + "^{commit}"});
  if (!commit) return commit.errors();
  std::string hash = without_end(commit->output);
  if (commit->exit_code != 0 || !is_commit_hash(hash))
    return no_such_revision(revision);  // a tag of a file, or of a folder
  return hash;
}

Outcome<std::string> GitRepository::tree_of(const std::string& commit) const {
  auto hash = output_of({"rev-parse", "--verify", commit + "^{tree}"});
  if (!hash) return hash;
  return without_end(std::move(*hash));
}

Outcome<std::vector<GitEntry>> GitRepository::entries(const std::string& commit) const {
  const auto text = output_of({"ls-tree", "-r", "-z", "-l", "--full-tree", commit});
  if (!text) return text.errors();
  std::vector<GitEntry> entries;
  for (std::string_view rest = *text; !rest.empty();) {
    const std::size_t end = std::min(rest.find('\0'), rest.size());
    auto entry = entry_of(rest.substr(0, end));
    if (!entry)
      return cannot_fetch(
          address_, "it has an entry of an unknown kind: " + std::string(rest.substr(0, end)));
    entries.push_back(std::move(*entry));
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  return entries;
}

Outcome<std::vector<GitSubmodule>> GitRepository::submodules(const std::string& commit) const {
  const auto answer = run({"config", "--blob", commit + ":.gitmodules", "-z", "--list"});
  if (!answer) return answer.errors();
  std::map<std::string, GitSubmodule> by_name;
  std::string_view rest = answer->exit_code == 0 ? answer->output : std::string_view();
  while (!rest.empty()) {  // "submodule.NAME.path\nVALUE\0"
    const std::size_t end = std::min(rest.find('\0'), rest.size());
    const std::string_view one = rest.substr(0, end);
    rest.remove_prefix(std::min(end + 1, rest.size()));
    const std::size_t line = one.find('\n');
    const std::string_view key = one.substr(0, line);
    const std::size_t last = key.rfind('.');
    if (line == std::string_view::npos || !key.starts_with("submodule.") || last < 10) continue;
    GitSubmodule& module = by_name[std::string(key.substr(0, last))];
    if (key.substr(last) == ".path") module.path = std::string(one.substr(line + 1));
    if (key.substr(last) == ".url") module.url = std::string(one.substr(line + 1));
  }
  std::vector<GitSubmodule> modules;
  for (auto& [name, module] : by_name) modules.push_back(std::move(module));
  return modules;
}

Outcome<Done> GitRepository::check_out(const std::string& commit, const fs::path& folder) const {
  if (auto read = output_of({"read-tree", commit}); !read) return std::move(read).errors();
  auto done = output_of({"--work-tree=" + folder.string(), "checkout-index", "--all", "--quiet"});
  if (!done) return std::move(done).errors();
  return Done{};
}

}  // namespace ros2wasm
