// `ros2wasm cache info|verify|prune|fetch`: looks after what was downloaded and unpacked.
#include <memory>

#include "bundler/io/files.hpp"
#include "bundler/resolve/locked_solve.hpp"
#include "bundler/store/cache_care.hpp"
#include "bundler/store/cache_place.hpp"
#include "bundler/store/library_files.hpp"
#include "bundler/store/source_trees.hpp"
#include "bundler/store/store.hpp"
#include "bundler/store/wheel_files.hpp"
#include "cli/arguments.hpp"
#include "cli/console.hpp"
#include "workspace_schema/base/json_writer.hpp"
#include "workspace_schema/schema/lock.hpp"

namespace ros2wasm {
namespace {

struct CacheOptions {
  std::string action;
  std::string lock;
  bool everything = false;
};

std::string size_text(std::uint64_t bytes) {
  std::string text = std::to_string((bytes + 999) / 1000) + " kB";
  if (text.size() < 14) text.insert(0, 14 - text.size(), ' ');
  return text;
}

int info(Context& context, const std::filesystem::path& cache) {
  const auto areas = measure_cache(cache);
  if (!areas) return context.console.fail(areas.errors());
  if (context.json) {
    JsonWriter json;
    json.begin_object().field("cache", cache.string()).key("areas").begin_array();
    for (const CacheArea& area : *areas) {
      json.begin_object().field("name", area.name).key("files").unsigned_integer(area.files);
      json.key("bytes").unsigned_integer(area.bytes).end_object();
    }
    json.end_array().end_object();
    context.console.result(json.text());
    return 0;
  }
  context.console.result(cache.string());
  for (const CacheArea& area : *areas) {
    context.console.result(size_text(area.bytes) + "  " + area.name + " (" +
                           std::to_string(area.files) + " files)");
  }
  return 0;
}

int verify(Context& context, const std::filesystem::path& cache) {
  const auto check = check_cache(cache, context.cancellation);
  if (!check) return context.console.fail(check.errors());
  if (context.json) {
    JsonWriter json;
    json.begin_object().key("checked").unsigned_integer(check->checked).key("faults").begin_array();
    for (const CacheFault& fault : check->faults) {
      json.begin_object().field("path", fault.path).field("reason", fault.reason).end_object();
    }
    json.end_array().end_object();
    context.console.result(json.text());
  } else {
    context.console.result(std::to_string(check->checked) + " checked, " +
                           std::to_string(check->faults.size()) + " damaged");
  }
  if (check->faults.empty()) return 0;
  Diagnostic error{.code = "R2W0239",
                   .kind = FailureKind::kEnvironment,
                   .message = "the cache holds damaged files",
                   .fix = {"ros2wasm cache prune"}};
  for (const CacheFault& fault : check->faults)
    error.why.push_back(fault.path + ": " + fault.reason);
  return context.console.fail({error});
}

int prune(Context& context, const std::filesystem::path& cache, bool everything) {
  const auto pruned = prune_cache(cache, {.everything = everything}, context.cancellation);
  if (!pruned) return context.console.fail(pruned.errors());
  if (context.json) {
    JsonWriter json;
    json.begin_object().key("entries").unsigned_integer(pruned->entries);
    json.key("bytes").unsigned_integer(pruned->bytes).end_object();
    context.console.result(json.text());
  } else {
    context.console.result("removed " + std::to_string(pruned->entries) + " entries, " +
                           std::to_string((pruned->bytes + 999) / 1000) + " kB");
  }
  return 0;
}

/// Everything that a lock names, so that later commands need no network.
int fetch(Context& context, const std::filesystem::path& cache, const std::string& lock_file) {
  const std::filesystem::path file = lock_file.empty() ? kLockFileName : lock_file;
  const auto text = read_file(file, kMostOfList);
  if (!text) return context.console.fail(text.errors());
  const auto lock = read_lock(*text, file.string());
  if (!lock) return context.console.fail(lock.errors());
  const auto limits = extract_limits_of("", context.environment);
  if (!limits) return context.console.fail(limits.errors());
  std::error_code error;
  ChannelRoots roots{.working_directory = std::filesystem::absolute(file, error).parent_path(),
                     .embedded = {},
                     .cache = cache,
                     .network = network_of(context.environment)};
  if (auto embedded = embedded_channel(context.executable)) roots.embedded = std::move(*embedded);
  const auto folders =
      Store(roots, *limits).unpacked_all(lock->packages, context.cancellation, context.progress);
  if (!folders) return context.console.fail(folders.errors());
  if (const auto sources = fetch_source_trees(lock->sources, roots, *limits, context.cancellation);
      !sources)
    return context.console.fail(sources.errors());
  if (const auto wheels = fetch_wheels(lock->wheels, roots, context.cancellation); !wheels)
    return context.console.fail(wheels.errors());
  if (const auto libraries =
          fetch_libraries(lock->libraries, lock->python_index, roots, context.cancellation);
      !libraries)
    return context.console.fail(libraries.errors());
  if (context.json) {
    JsonWriter json;
    json.begin_object().key("packages").unsigned_integer(folders->size()).end_object();
    context.console.result(json.text());
  } else {
    context.console.result(std::to_string(folders->size()) + " packages are there");
  }
  return 0;
}

int run(Context& context, const CacheOptions& options) {
  const auto cache = cache_directory(context.environment);
  if (!cache) return context.console.fail(cache.errors());
  if (options.action == "verify") return verify(context, *cache);
  if (options.action == "fetch") return fetch(context, *cache, options.lock);
  if (options.action == "prune") return prune(context, *cache, options.everything);
  return info(context, *cache);
}

}  // namespace

CommandBody cache_command(Arguments& arguments) {
  const auto options = std::make_shared<CacheOptions>();
  arguments.required(
      "ACTION", options->action,
      "`info` says how large it is, `verify` checks every hash, `prune` removes "
      "leftovers, damaged files and archives that are unpacked, `fetch` brings all that a "
      "lock names");
  arguments.optional("LOCK", options->lock, "for `fetch`: a lock (default: ros2wasm.lock)");
  arguments.flag("--all", options->everything, "prune: remove everything");
  arguments.examples({"ros2wasm cache info", "ros2wasm cache verify", "ros2wasm cache prune --all",
                      "ros2wasm cache fetch ros2wasm.lock"});
  return [options](Context& context) {
    for (const char* action : {"info", "verify", "prune", "fetch"}) {
      if (options->action == action) return run(context, *options);
    }
    return context.console.fail(
        {Diagnostic{.code = "R2W0902",
                    .kind = FailureKind::kCommandLine,
                    .message = "`ros2wasm cache` has no action `" + options->action + "`",
                    .why = {"the actions are: info, verify, prune, fetch"}}});
  };
}

}  // namespace ros2wasm
