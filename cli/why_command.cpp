// `ros2wasm why PATH|NAME`: why a file is in a site, or a package in the lock.
#include <filesystem>
#include <memory>

#include "bundler/io/files.hpp"
#include "bundler/plan/plan_site.hpp"
#include "bundler/resolve/lock_graph.hpp"
#include "bundler/resolve/locked_solve.hpp"
#include "bundler/site/site_list.hpp"
#include "cli/arguments.hpp"
#include "cli/console.hpp"
#include "cli/workspace_lock.hpp"
#include "workspace_schema/base/json_writer.hpp"
#include "workspace_schema/base/suggestion.hpp"

namespace ros2wasm {
namespace {
namespace fs = std::filesystem;

/// The nearest folder above `path` that holds a site.json; empty when there is none.
fs::path site_above(const fs::path& path) {
  std::error_code error;
  fs::path folder = fs::absolute(path, error).lexically_normal().parent_path();
  while (true) {
    if (fs::is_regular_file(folder / kSiteJsonName, error)) return folder;
    if (folder == folder.parent_path()) return {};
    folder = folder.parent_path();
  }
}

Diagnostic not_in_site(const std::string& path, std::vector<std::string> why) {
  return Diagnostic{.code = "R2W0607",
                    .message = "`" + path + "` is not a file that ros2wasm put into a site",
                    .why = std::move(why)};
}

int answer(Context& context, const std::string& path, std::uint64_t size,
           const std::string& reason) {
  if (context.json) {
    JsonWriter json;
    json.begin_object().field("path", path);
    json.key("size").unsigned_integer(size);
    json.field("reason", reason).end_object();
    context.console.result(json.text());
  } else {
    context.console.result(path + ": " + reason + " (" + std::to_string(size) + " bytes)");
  }
  return 0;
}

/// Prints where a package that is built here comes from.
int why_built(Context& context, const std::string& name, const LockedSource& source) {
  if (context.json) {
    JsonWriter json;
    json.begin_object().field("name", name).key("source");
    write_source(json, source);
    context.console.result(json.end_object().text());
    return 0;
  }
  context.console.result(name + " is built from " + title_of(source));
  context.console.result(source.package.empty()
                             ? "  `sources:` of the manifest names it, or a package that needs it"
                             : "  the distribution of `sources:` has it, and no channel");
  return 0;
}

/// Prints why the lock has a package: the chains from requested packages to it.
int why_package(Context& context, const std::string& name) {
  const auto lock = read_workspace_lock({});
  if (!lock) return context.console.fail(lock.errors());
  const LockGraph graph(*lock);
  const auto package = graph.find(name);
  if (!package) {
    if (const LockedSource* source = source_of_package(*lock, name))
      return why_built(context, name, *source);
    return context.console.fail(not_in_lock(name, lock->packages));
  }
  const auto chains = graph.chains_to(*package);
  const PackageRecord& record = graph.package(*package);
  if (context.json) {
    JsonWriter json;
    json.begin_object().field("name", record.name).field("version", record.version);
    json.field("channel", record.channel).key("chains").begin_array();
    for (const auto& chain : chains) {
      json.begin_array();
      for (const LockEdge& edge : chain) {
        json.begin_object().field("name", graph.package(edge.package).name);
        json.field("spec", edge.spec).end_object();
      }
      json.end_array();
    }
    json.end_array().end_object();
    context.console.result(json.text());
    return 0;
  }
  context.console.result(record.name + " " + record.version + " " + record.build +
                         " of the channel " + record.channel);
  if (chains.empty()) context.console.result("  nothing in the lock needs it");
  for (const auto& chain : chains) {
    std::string line = "  asked for: " + chain.front().spec;
    for (std::size_t i = 1; i < chain.size(); ++i)
      line += "\n    " + graph.package(chain[i - 1].package).name + " needs " + chain[i].spec;
    context.console.result(line);
  }
  return 0;
}

int why(Context& context, const std::string& word) {
  std::error_code ignored;
  const bool is_name = word.find('/') == std::string::npos && !fs::exists(word, ignored);
  const fs::path folder = site_above(word);
  if (is_name && (folder.empty() || fs::exists(kLockFileName, ignored)))
    return why_package(context, word);
  if (folder.empty()) {
    return context.console.fail(
        not_in_site(word, {"there is no site.json in the folders above it"}));
  }
  const auto whole = absolute_path(word);
  if (!whole) return context.console.fail(whole.errors());
  const std::string relative =
      whole->lexically_normal().lexically_relative(folder).generic_string();
  const auto text = read_file(folder / kSiteJsonName, kMostOfSiteJson);
  if (!text) return context.console.fail(text.errors());
  const auto list = read_site_list(*text, (folder / kSiteJsonName).string());
  if (!list) return context.console.fail(list.errors());
  if (relative == kSiteJsonName)
    return answer(context, relative, text->size(), "what runs in the site");
  if (relative == kHashList)
    return answer(context, relative, hash_list(*list).size(), kHashListReason);
  std::vector<std::string> known;
  for (const ListedFile& file : list->files) {
    known.push_back(file.path);
    if (file.path == relative) return answer(context, relative, file.size, file.reason);
  }
  Diagnostic error = not_in_site(word, {"site.json of " + folder.string() + " does not list it"});
  if (const auto similar = nearest(relative, known))
    error.why.push_back("it lists `" + *similar + "`");
  return context.console.fail(error);
}

}  // namespace

CommandBody why_command(Arguments& arguments) {
  const auto path = std::make_shared<std::string>();
  arguments.required("PATH", *path, "a file of a site, or the name of a package of ros2wasm.lock");
  arguments.examples({"ros2wasm why site/programs/demo/talker.wasm", "ros2wasm why ros-jazzy-rcl"});
  return [path](Context& context) { return why(context, *path); };
}

}  // namespace ros2wasm
