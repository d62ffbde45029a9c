// `ros2wasm search SPEC`: what the channels have that fits, and what a distribution has sources of.
#include <algorithm>
#include <memory>

#include "bundler/released_packages.hpp"
#include "bundler/workspace/build_order.hpp"
#include "cli/arguments.hpp"
#include "cli/channel_choice.hpp"
#include "cli/console.hpp"
#include "workspace_schema/base/json_writer.hpp"
#include "workspace_schema/base/suggestion.hpp"
#include "workspace_schema/conda/match_spec.hpp"
#include "workspace_schema/schema/manifest.hpp"

namespace ros2wasm {
namespace {

struct SearchOptions {
  std::string spec;
  std::string distribution;
  ChannelChoice choice;
};

/// A package that can be built from its sources.
struct Source {
  std::string name;
  std::string version;
  ReleasedPackage released;
};

/// The packages of the distribution that fit, by ROS name or by conda's.
Outcome<std::vector<Source>> search_sources(const MatchSpec& spec, const SearchOptions& options,
                                            const Context& context) {
  std::vector<Source> found;
  if (options.distribution.empty()) return found;
  const auto roots = chosen_roots(options.choice, context);
  if (!roots) return roots.errors();
  const auto released = read_distribution(options.distribution, *roots, context.cancellation);
  if (!released) return released.errors();
  for (const auto& [name, one] : *released) {
    // The part after `-` counts the releases of a version, not versions.
    PackageRecord record{.name = conda_name(name, Manifest().distro),
                         .version = one.version.substr(0, one.version.find('-')),
                         .build = "source",
                         .subdir = "noarch"};
    const auto version = Version::parse(record.version);
    if (!version) continue;
    bool fits = false;
    for (const std::string& called : {record.name, name}) {
      record.name = called;
      fits = fits || (spec.name().matches(called) && spec.matches(record, *version));
    }
    if (fits) found.push_back({name, record.version, one});
  }
  return found;
}

struct Found {
  PackageRecord record;
  Version version;
};

/// By name, newest first; the rest only so that the order is one.
bool comes_before(const Found& a, const Found& b) {
  if (a.record.name != b.record.name) return a.record.name < b.record.name;
  if (const auto order = a.version <=> b.version; order != 0) return order > 0;
  if (a.record.build_number != b.record.build_number)
    return a.record.build_number > b.record.build_number;
  return a.record.url < b.record.url;
}

Outcome<std::vector<Found>> search(const MatchSpec& spec, const OpenChannels& open,
                                   const Cancellation& cancellation) {
  const std::vector<std::string> wanted{spec.text()};
  // A pattern may speak of any name.
  auto index = spec.exact_name() ? open.reachable(wanted, ChannelPriority::kDisabled, cancellation)
                                 : open.everything(cancellation);
  if (!index) return std::move(index).errors();
  std::vector<Found> found;
  for (PackageRecord& record : index->records) {
    if (!spec.name().matches(record.name)) continue;
    auto version = Version::parse(record.version);
    if (version && spec.matches(record, *version))
      found.push_back({std::move(record), std::move(*version)});
  }
  std::sort(found.begin(), found.end(), comes_before);
  return found;
}

Diagnostic nothing_fits(const MatchSpec& spec, const OpenChannels& open, bool names_channels) {
  Diagnostic made{.code = "R2W0332",
                  .message = "no package of the channels fits `" + spec.text() + "`",
                  .why = {"the channels are: " + name_list(open.channels())}};
  if (!names_channels)
    made.fix.emplace_back("say which with `--channel`: a folder, an address or a name");
  const auto name = spec.exact_name();
  const auto& names = open.names();
  if (!name) return made;
  if (std::binary_search(names.begin(), names.end(), *name)) {
    made.why.push_back("there are other versions or builds: `ros2wasm search " + *name + "`");
  } else if (const auto similar = nearest(*name, names)) {
    made.why.push_back("there is `" + *similar + "`");
  }
  return made;
}

void show(Context& context, const std::vector<Found>& found, const std::vector<Source>& sources) {
  if (!context.json) {
    for (const auto& [record, version] : found) {
      context.console.result(record.name + " " + record.version + " " + record.build + "  " +
                             record.subdir + "  " + record.channel);
    }
    for (const Source& one : sources)
      context.console.result(one.name + " " + one.version + " source  " + one.released.url + " " +
                             one.released.tag);
    return;
  }
  JsonWriter json;
  json.begin_object().key("packages").begin_array();
  for (const auto& [record, version] : found) {
    json.begin_object().field("name", record.name).field("version", record.version);
    json.field("build", record.build).field("subdir", record.subdir);
    json.field("channel", record.channel).field("url", record.url).field("sha256", record.sha256);
    json.key("size").unsigned_integer(record.size).field("license", record.license);
    json.key("depends").begin_array();
    for (const std::string& one : record.depends) json.string(one);
    json.end_array().end_object();
  }
  json.end_array().key("sources").begin_array();
  for (const Source& one : sources) {
    json.begin_object().field("name", one.name).field("version", one.version);
    json.field("git", one.released.url).field("revision", one.released.tag).end_object();
  }
  json.end_array().end_object();
  context.console.result(json.text());
}

int run(Context& context, const SearchOptions& options) {
  std::string text = options.spec;
  if (const auto bad = MatchSpec::parse(text); !bad) return context.console.fail(bad.errors());
  const auto open = open_chosen_channels(options.choice, {&text, 1}, context);
  if (!open) return context.console.fail(open.errors());
  const auto spec = MatchSpec::parse(text);
  if (!spec) return context.console.fail(spec.errors());
  const auto found = search(*spec, *open, context.cancellation);
  if (!found) return context.console.fail(found.errors());
  const auto sources = search_sources(*spec, options, context);
  if (!sources) return context.console.fail(sources.errors());
  if (found->empty() && sources->empty())
    return context.console.fail(nothing_fits(*spec, *open, !options.choice.channels.empty()));
  show(context, *found, *sources);
  return 0;
}

}  // namespace

CommandBody search_command(Arguments& arguments) {
  const auto options = std::make_shared<SearchOptions>();
  arguments.required("SPEC", options->spec, "a conda match spec: ros-jazzy-*, \"python >=3.11\"");
  arguments.values(
      "-c,--channel", options->choice.channels, "CHANNEL",
      "A folder, an address, or a name such as conda-forge; the embedded channel if none");
  arguments.text(
      "--distribution", options->distribution, "FILE",
      "also what this distribution file of rosdistro has sources of: a path or an address");
  arguments.flag("--offline", options->choice.offline, "use only what is on this machine");
  arguments.examples({"ros2wasm search \"ros-jazzy-*msgs\"",
                      "ros2wasm search --channel conda-forge --json \"zlib >=1.3\""});
  return [options](Context& context) { return run(context, *options); };
}

}  // namespace ros2wasm
