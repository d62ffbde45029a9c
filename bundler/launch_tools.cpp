// See launch_tools.hpp.
#include "bundler/launch_tools.hpp"

#include <memory>
#include <utility>

#include "bundler/build/source_hash.hpp"
#include "bundler/io/files.hpp"
#include "bundler/io/installation.hpp"
#include "bundler/io/sha256.hpp"
#include "bundler/launch/host/seen_path.hpp"
#include "bundler/resolve/solve.hpp"
#include "bundler/run/node_js.hpp"
#include "bundler/store/build_place.hpp"
#include "bundler/store/cache_place.hpp"
#include "bundler/store/environment.hpp"
#include "bundler/workspace/python_tree.hpp"
#include "bundler/workspace/workspace_channels.hpp"

namespace ros2wasm {
namespace fs = std::filesystem;
namespace {

constexpr const char* kReader = "the reader of Python files";

/// Pyodide of the program's own channel, unpacked in the cache.
Outcome<fs::path> own_pyodide(const fs::path& executable,
                              const std::map<std::string, std::string>& variables,
                              const Cancellation& cancellation) {
  Manifest nothing;
  const auto here = absolute_path(".");
  if (!here) return here.errors();
  auto channels = workspace_channels(nothing, *here, executable, variables);
  if (!channels) return std::move(channels).errors();
  auto& [roots, addresses] = *channels;
  roots.network.offline = true;
  const auto open = open_channels(addresses, roots, cancellation);
  if (!open) return open.errors();
  const std::string wanted(kPyodidePackage);
  const auto index = open->reachable({&wanted, 1}, nothing.channel_priority, cancellation);
  if (!index) return index.errors();
  const auto solved = solve(
      {.specs = {{.text = wanted, .origin = "launch files in Python", .span = {}}}, .locked = {}},
      *index);
  if (!solved) return no_pyodide("a launch file is written in Python");
  const Store store(roots, {});
  const auto environment = make_environment(store, solved->packages, cancellation);
  if (!environment) return environment.errors();
  return environment->prefix / kPyodideFolder;
}

/// Another place for everything that is not among the files that the interpreter looks at: its own
/// parts, where the folders are, and what is asked of it. Empty when there is no cache.
fs::path kept_place(const LaunchEvaluationAsked& asked) {
  const auto cache = cache_directory(asked.variables);
  if (!cache) return {};
  HashBuilder key;
  const auto templates = find_own_data(asked.executable, "templates/python", kReader);
  if (templates) {
    if (const auto hash = hash_of_tree(*templates)) key.add("reader", *hash);
  }
  Manifest nothing;
  const auto here = absolute_path(".");
  const auto channels =
      here ? workspace_channels(nothing, *here, asked.executable, asked.variables) : here.errors();
  if (channels) {
    const auto index = hash_file(channels->roots.embedded / "noarch" / "repodata.json");
    if (index) key.add("channel", index->sha256);
  }
  key.add("environment", asked.environment.string()).add("file", asked.file);
  for (const auto& [name, value] : asked.given) key.add("argument", name).add("value", value);
  std::error_code error;
  // The folder of a build is another one after each change, so it is not part of the key; its
  // contents are checked through the files that were looked at.
  const std::string built = fs::absolute(build_area(*cache), error).string() + "/";
  for (const LaunchFolder& folder : asked.folders) {
    const std::string from = fs::absolute(folder.from, error).string();
    key.add("at", folder.at).add("from", from.starts_with(built) ? "a build" : from);
    key.add("is", fs::is_directory(folder.from, error) ? "there" : "absent");
    key.add("holds", folder.holds_modules ? "modules" : "files");
  }
  return kept_launch_place(*cache) / (key.finish() + ".json");
}

/// Nothing when there is none, or when something of what it was made of is not as it was.
KeptPython kept_talk(const fs::path& place, const std::vector<LaunchFolder>& folders) {
  std::error_code error;
  if (!fs::is_regular_file(place, error)) return {};
  const auto text = read_file(place, kMostOfList);
  auto kept = text ? read_kept_python(*text) : std::nullopt;
  if (!kept) return {};
  for (const auto& [path, state] : kept->seen)
    if (!is_still(folders, path, state)) return {};
  // By that the cache sees which are in use.
  fs::last_write_time(place, fs::file_time_type::clock::now(), error);
  return std::move(*kept);
}

}  // namespace

Outcome<PythonFiles> launch_modules(const fs::path& executable) {
  const auto folder = find_own_data(executable, "templates/python/launch_modules", kReader);
  if (!folder) return folder.errors();
  const auto tree = list_tree(*folder);
  if (!tree) return tree.errors();
  PythonFiles result;
  for (const TreeEntry& entry : *tree) {
    if (entry.kind != FileKind::kFile || !entry.path.ends_with(".py")) continue;
    auto bytes = read_file(*folder / entry.path, kMostOfList);
    if (!bytes) return std::move(bytes).errors();
    result.emplace(entry.path, std::move(*bytes));
  }
  return result;
}

Outcome<PythonTools> find_launch_tools(const fs::path& executable,
                                       const std::map<std::string, std::string>& variables,
                                       const fs::path& environment,
                                       const Cancellation& cancellation) {
  const auto path = variables.find("PATH");
  auto node = find_node_js(executable, path == variables.end() ? "" : path->second, cancellation);
  if (!node) return std::move(node).errors();
  const auto templates = find_own_data(executable, "templates/python", kReader);
  if (!templates) return templates.errors();
  std::error_code error;
  fs::path pyodide = environment / kPyodideFolder;
  if (environment.empty() || !fs::is_directory(pyodide, error)) {
    auto own = own_pyodide(executable, variables, cancellation);
    if (!own) return std::move(own).errors();
    pyodide = std::move(*own);
  }
  return PythonTools{.node_js = std::move(*node),
                     .pyodide = fs::canonical(pyodide, error),
                     .templates = fs::canonical(*templates, error)};
}

LaunchInterpreter launch_interpreter(const LaunchEvaluationAsked& asked,
                                     const Cancellation& cancellation) {
  const auto host = std::make_shared<PythonHost>(
      [asked, cancellation] {
        return find_launch_tools(asked.executable, asked.variables, asked.environment,
                                 cancellation);
      },
      asked.folders, cancellation);
  // Read when Python is first asked: most launch files have none.
  const auto transcript = std::make_shared<std::optional<PythonTranscript>>();
  const auto place = std::make_shared<fs::path>();
  const auto seen_before = std::make_shared<SeenPaths>();
  LaunchInterpreter result;
  result.python = [=](const std::string& request,
                      const std::function<std::string(const std::string&)>& reply) {
    if (!*transcript) {
      *place = kept_place(asked);
      KeptPython kept = kept_talk(*place, asked.folders);
      *seen_before = std::move(kept.seen);
      transcript->emplace(std::move(kept.remarks), [host](const auto& one, const auto& told) {
        return host->ask(one, told);
      });
    }
    return (*transcript)->ask(request, reply);
  };
  result.keep = [=] {
    if (!*transcript || place->empty() || !(*transcript)->end() || !(*transcript)->is_live() ||
        (*transcript)->has_failed())
      return;
    auto seen = host->seen();
    if (!seen) return;
    const KeptPython kept{.remarks = (*transcript)->remarks(), .seen = std::move(*seen)};
    // When the result cannot be cached, the next run asks again.
    static_cast<void>(write_file(*place, kept_python_json(kept)));
  };
  result.seen = [=]() -> Outcome<SeenPaths> {
    if (!*transcript) return SeenPaths();
    if (auto ended = (*transcript)->end(); !ended) return std::move(ended).errors();
    if (!(*transcript)->is_live()) return *seen_before;
    auto seen = host->seen();
    if (seen) return *std::move(seen);
    return Diagnostic{.code = "R2W0416",
                      .message = "the interpreter of launch files in Python has ended",
                      .why = {"what they opened, which the site needs, is not known"},
                      .fix = {"run the command again"}};
  };
  return result;
}

}  // namespace ros2wasm
