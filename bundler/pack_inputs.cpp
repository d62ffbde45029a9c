// See pack_inputs.hpp.
#include "bundler/pack_inputs.hpp"

#include <algorithm>
#include <optional>

#include "bundler/build/compiler_parts.hpp"
#include "bundler/channel/channel_index.hpp"
#include "bundler/channel/transport.hpp"
#include "bundler/fuel_models.hpp"
#include "bundler/io/files.hpp"
#include "bundler/languages/language.hpp"
#include "bundler/notebook_files.hpp"
#include "bundler/python_libraries_of_site.hpp"
#include "bundler/released_packages.hpp"
#include "bundler/resolve/locked_solve.hpp"
#include "bundler/workspace/bringup_file.hpp"
#include "bundler/workspace/build_order.hpp"
#include "bundler/workspace/channel_request.hpp"
#include "bundler/workspace/default_manifest.hpp"
#include "bundler/workspace/discovery.hpp"
#include "bundler/workspace/page_bags.hpp"
#include "bundler/workspace/wheel_request.hpp"
#include "bundler/workspace/workspace_channels.hpp"
#include "bundler/workspace_sources.hpp"
#include "workspace_schema/base/diagnostic_list.hpp"
#include "workspace_schema/base/suggestion.hpp"
#include "workspace_schema/conda/version.hpp"
#include "workspace_schema/schema/manifest_reader.hpp"

namespace ros2wasm {
namespace fs = std::filesystem;
namespace {

constexpr const char* kManifestName = "workspace.yaml";
/// The author of `ros2wasm init paper`.
constexpr std::string_view kNobody = "Your name";

/// Step 1: read the manifest, or make one up for a folder that has none.
Outcome<ReadWorkspace> read_workspace(const PackRequest& request, PackNotes& notes) {
  const fs::path input = request.input.empty() ? fs::path(".") : fs::path(request.input);
  if (auto whole = absolute_path(input); !whole) return std::move(whole).errors();
  std::error_code error;
  fs::path file = input;
  if (fs::is_directory(input, error)) {
    file = input / kManifestName;
    if (is_absent(file)) {
      ReadWorkspace made;
      made.folder = fs::canonical(input, error);
      made.shown_folder = input;
      made.manifest = default_manifest(made.folder);
      made.has_manifest = false;
      notes.remarks.push_back("there is no " + std::string(kManifestName) + " in " +
                              input.string() + ", so all packages below it are taken");
      return made;
    }
    file = file.lexically_normal();
  }
  const auto text = read_file(file, kMostOfText);
  if (!text) return text.errors();
  auto manifest = read_manifest(*text, file.string(),
                                request.for_channel ? ManifestUse::kPackages : ManifestUse::kSite);
  if (!manifest) return std::move(manifest).errors();
  append(notes.warnings, manifest->warnings);
  notes.watched.push_back(fs::canonical(file, error));
  return ReadWorkspace{.manifest = std::move(manifest).value(),
                       .folder = fs::canonical(file, error).parent_path(),
                       .shown_folder = file.parent_path(),
                       .notebook = std::nullopt};
}

/// R2W0125: an author that a template left to be filled in.
std::optional<Diagnostic> placeholder_author(const Manifest& manifest) {
  const auto found = std::find_if(manifest.authors.begin(), manifest.authors.end(),
                                  [](const Author& author) { return author.name == kNobody; });
  if (found == manifest.authors.end()) return std::nullopt;
  return Diagnostic{.code = "R2W0125",
                    .message = "`authors:` still has the template's `" + std::string(kNobody) + "`",
                    .span = SourceSpan{.file = manifest.file, .line_text = {}},
                    .why = {"the page, CITATION.cff and BibTeX entries would name that author"},
                    .fix = {"authors:\n  - {name: Ada Lovelace}"}};
}

/// Without a manifest the launch file that starts the workspace says what runs, when one can be
/// told from the others.
void take_bringup(ReadWorkspace& workspace, const std::vector<LocalPackage>& packages,
                  PackNotes& notes) {
  std::vector<std::string> files;
  for (const LocalPackage& package : packages)
    for (const fs::path& file : package.launch_files)
      files.push_back(file.lexically_relative(workspace.folder).generic_string());
  const BringupChoice choice = bringup_file(files);
  if (!choice.file.empty()) {
    workspace.manifest.launch_file = Spanned<std::string>{
        .value = choice.file, .span = {.file = workspace.folder.string(), .line_text = {}}};
    notes.remarks.push_back("it starts " + choice.file);
  }
  if (!choice.candidates.empty())
    notes.remarks.push_back("a workspace.yaml can start another launch file: " +
                            name_list(choice.candidates, 12));
}

/// A new site takes the place of the old one, with all that lies in it. `channels`, or archives of
/// theirs.
std::optional<Diagnostic> refuse_own_channel(const PackRequest& request,
                                             const std::vector<ChannelSource>& channels,
                                             const fs::path& working_directory) {
  if (request.output.empty() || request.with_channel || request.plan_only) return std::nullopt;
  std::error_code error;
  const fs::path site = fs::weakly_canonical(fs::absolute(request.output, error), error);
  for (const ChannelSource& channel : channels) {
    const auto folder = local_channel_folder(channel.name, working_directory);
    if (!folder) continue;
    const fs::path from_site = fs::weakly_canonical(*folder, error).lexically_relative(site);
    if (from_site.empty() || *from_site.begin() == "..") continue;
    return Diagnostic{
        .code = "R2W0603",
        .message = "the site at `" + request.output.string() +
                   "` holds the channel that the workspace is packed from",
        .span = channel.span,
        .label = "inside the site",
        .why = {"the new site takes the place of the old one, so the channel would be gone"},
        .fix = {"add --with-channel, which puts the packages into the new site too",
                "choose another place with -o"}};
  }
  return std::nullopt;
}

/// The packages of a lock in place of those of the channels, so that no channel is asked. `rest`
/// becomes what else it says.
Outcome<RepoIndex> locked_index(const fs::path& lock_file, LockRest& rest) {
  auto lock = read_lock_file(lock_file);
  if (!lock) return std::move(lock).errors();
  rest = {.absent = std::move(lock->absent),
          .sources = {},
          .wheels = std::move(lock->wheels),
          .python_index = std::move(lock->python_index),
          .libraries = std::move(lock->libraries)};
  std::vector<std::string> names;
  for (const PackageRecord& record : lock->packages) names.push_back(record.name);
  std::sort(names.begin(), names.end());
  return RepoIndex{.channels = std::move(lock->channels),
                   .records = std::move(lock->packages),
                   .left_out = {},
                   .names = [names = std::move(names)] { return names; },
                   .elsewhere = {}};
}

/// A lock may lead where the manifest's channels do not.
std::vector<ChannelSource> places_of(const std::vector<PackageRecord>& records) {
  std::vector<ChannelSource> places;
  for (const PackageRecord& record : records) places.push_back({record.url, std::nullopt});
  return places;
}

/// Packages of the workspace and of its sources that no channel has: packages of channels may need
/// them.
std::vector<PackageRecord> built_here(const std::vector<LocalPackage>& packages,
                                      const LeftOutPackages& left_out, const KnownNames& known,
                                      std::string_view distro) {
  std::vector<PackageRecord> records;
  for (std::size_t i = 0; i < packages.size(); ++i) {
    std::string name = conda_name(packages[i].xml.name.value, distro);
    const std::string& version = packages[i].xml.version.value;
    if (left_out.contains(i) || !Version::parse(version) ||
        std::binary_search(known.names.begin(), known.names.end(), name))
      continue;
    records.push_back({.name = std::move(name),
                       .version = version,
                       .build = "workspace",
                       .subdir = "noarch",
                       .channel = {},
                       .file_name = {},
                       .url = {}});
  }
  return records;
}

/// The build of kClientAbi that the channels have; of several, that of the first channel. Empty
/// when none has it.
Outcome<std::string> client_abi_of(OpenChannels& open, ChannelPriority priority,
                                   const Cancellation& cancellation) {
  const std::string name(kClientAbiPackage);
  const auto found = open.reachable({&name, 1}, priority, cancellation);
  if (!found) return found.errors();
  return found->records.empty() ? std::string() : found->records.front().build;
}

/// Each once, sorted by text as they are.
void add_specs(std::vector<RequestedSpec> specs, ChannelRequest& wanted) {
  const auto is_before = [](const RequestedSpec& a, const RequestedSpec& b) {
    return a.text < b.text;
  };
  for (RequestedSpec& one : specs) {
    const auto place = std::lower_bound(wanted.specs.begin(), wanted.specs.end(), one, is_before);
    if (place == wanted.specs.end() || place->text != one.text)
      wanted.specs.insert(place, std::move(one));
  }
}

/// Step 1, with the sources that the request names, and with all that can be refused before a
/// package is looked for.
Outcome<ReadWorkspace> read_inputs(const PackRequest& request, PackNotes& notes) {
  auto read = read_workspace(request, notes);
  if (!read) return read;
  Manifest& manifest = read->manifest;
  if (!request.more_sources.empty()) {
    if (!read->has_manifest) manifest.packages.clear();
    manifest.sources.insert(manifest.sources.end(), request.more_sources.begin(),
                            request.more_sources.end());
  }
  if (auto nobody = placeholder_author(manifest)) {
    if (request.signer) return *std::move(nobody);
    nobody->severity = Severity::kWarning;
    notes.warnings.push_back(*std::move(nobody));
  }
  const auto page = read_page_files(read->folder, manifest);
  if (!page) return page.errors();  // reported before anything is built
  append(notes.warnings, cut_bags(page->bags, manifest.ui_bags));
  return read;
}

/// Step 2: the packages of the workspace and of its sources, and the places of the channels.
struct FoundPackages {
  std::vector<LocalPackage> packages;
  std::vector<Spanned<std::string>> notebook_needs;  ///< modules that cells of the notebook import
  WorkspaceChannels channels;
  SourcesRequest sources_request;
  WorkspaceSources sources;
};

Outcome<FoundPackages> find_packages(const PackRequest& request, const ExtractLimits& limits,
                                     ReadWorkspace& read, PackNotes& notes,
                                     const Cancellation& cancellation,
                                     const ProgressSink& progress) {
  auto packages = discover_packages(read.folder, read.shown_folder, read.manifest.packages,
                                    ros_condition_variables(read.manifest.distro));
  auto notebook_needs = read_notebook(read);
  if (!notebook_needs) return std::move(notebook_needs).errors();
  if (!packages) return std::move(packages).errors();
  if (!read.has_manifest) take_bringup(read, *packages, notes);
  for (const LocalPackage& package : *packages) notes.watched.push_back(package.directory);
  auto channels =
      workspace_channels(read.manifest, read.folder, request.executable, request.variables);
  if (!channels) return std::move(channels).errors();
  channels->roots.network.offline = request.offline;
  const SourcesRequest sources_request{.folder = read.folder,
                                       .shown_folder = read.shown_folder,
                                       .update = request.update,
                                       .must_be_locked = request.locked || request.frozen,
                                       .takes_carried = request.takes_carried};
  auto sources = add_source_packages(read.manifest, sources_request, channels->roots, limits,
                                     *packages, cancellation, progress);
  if (!sources) return std::move(sources).errors();
  // Mistakes in the packages at hand are reported before a channel is asked.
  if (auto known = order_packages(*packages, read.manifest.distro); !known)
    return std::move(known).errors();
  return FoundPackages{.packages = std::move(*packages),
                       .notebook_needs = std::move(*notebook_needs),
                       .channels = std::move(*channels),
                       .sources_request = sources_request,
                       .sources = std::move(*sources)};
}

/// The channels, or a frozen lock in their place: where packages can be had.
struct Offers {
  KnownNames known;
  std::vector<PackageRecord> compilers;  ///< records of kCompilerPackage
  std::optional<OpenChannels> open;      ///< nothing with a frozen lock
  RepoIndex locked;                      ///< of a frozen lock
  LockRest rest;                         ///< of a frozen lock
  std::string client_abi;                ///< as in Supplies
};

Outcome<Offers> offers_of_lock(const fs::path& lock_file, const std::vector<NamedWheel>& wheels) {
  LockRest rest;
  auto index = locked_index(lock_file, rest);
  if (!index) return std::move(index).errors();
  if (auto faults = other_wheels(rest.wheels, locked_wheels(wheels)); !faults.empty()) {
    faults.back().fix.emplace_back("ros2wasm lock");
    return faults;
  }
  std::vector<PackageRecord> compilers;
  for (const PackageRecord& record : index->records)
    if (record.name == kCompilerPackage) compilers.push_back(record);
  return Offers{.known = {.names = index->names(), .of_lock = true, .absent = rest.absent},
                .compilers = std::move(compilers),
                .open = std::nullopt,
                .locked = std::move(*index),
                .rest = std::move(rest),
                .client_abi = {}};
}

Outcome<Offers> offers_of_channels(const PackRequest& request, const WorkspaceChannels& channels,
                                   ChannelPriority priority, const Cancellation& cancellation,
                                   const ProgressSink& progress) {
  auto open = open_channels(channels.addresses, channels.roots, cancellation, progress);
  if (!open) return std::move(open).errors();
  const std::string compiler_package(kCompilerPackage);
  auto compilers = open->reachable({&compiler_package, 1}, priority, cancellation);
  if (!compilers) return std::move(compilers).errors();
  std::string client_abi;
  if (request.for_channel) {
    auto abi = client_abi_of(*open, priority, cancellation);
    if (!abi) return std::move(abi).errors();
    client_abi = *std::move(abi);
  }
  KnownNames known{.names = open->names(), .of_lock = false, .absent = {}};
  return Offers{.known = std::move(known),
                .compilers = std::move(compilers->records),
                .open = std::move(*open),
                .locked = {},
                .rest = {},
                .client_abi = std::move(client_abi)};
}

/// The records that may fulfil the request; a frozen lock must fulfil all of it.
Outcome<RepoIndex> index_for(const ChannelRequest& wanted, ChannelPriority priority,
                             std::vector<PackageRecord> here, Offers& offers,
                             const Cancellation& cancellation) {
  Outcome<RepoIndex> index = std::move(offers.locked);
  if (offers.open) {
    std::vector<std::string> texts;
    for (const RequestedSpec& spec : wanted.specs) texts.push_back(spec.text);
    index = offers.open->reachable(texts, priority, cancellation);
    if (!index) return index;
  } else if (auto faults = check_solution(wanted.specs, index->records, here); !faults.empty()) {
    faults.back().fix.emplace_back("ros2wasm lock");
    return faults;
  }
  index->built_here = std::move(here);
  return index;
}

bool needs_compiler(const std::vector<LocalPackage>& packages) {
  return !std::all_of(packages.begin(), packages.end(), reads_setup_py);
}

}  // namespace

bool reads_setup_py(const LocalPackage& package) {
  return package.xml.build_type == kPythonBuildType;
}

Outcome<Question> ask(const PackRequest& request, PackNotes& notes,
                      const Cancellation& cancellation, const ProgressSink& progress) {
  const auto limits = extract_limits_of(request.archive_limits, request.variables);
  if (!limits) return limits.errors();

  // 1. the manifest
  auto read = read_inputs(request, notes);
  if (!read) return std::move(read).errors();
  const Manifest& manifest = read->manifest;

  // 2. the packages of the workspace and of its sources
  auto found = find_packages(request, *limits, *read, notes, cancellation, progress);
  if (!found) return std::move(found).errors();
  auto& [packages, notebook_needs, channels, sources_request, sources] = *found;
  auto compiler = find_compiler(request.variables);
  if (!compiler && needs_compiler(packages)) return std::move(compiler).errors();

  // 3. what the channels have, and what is asked of them
  begin_step(progress, "solve");
  if (channels.roots.embedded.empty() && manifest.channels.empty())
    return embedded_channel(request.executable).errors();
  if (auto refusal = refuse_own_channel(request, channels.addresses, read->folder)) return *refusal;
  auto wheels = read_wheels(manifest, channels.roots, *limits, true, cancellation);
  if (!wheels) return std::move(wheels).errors();
  for (const WheelEntry& wheel : manifest.wheels) {
    if (!wheel.is_url) notes.watched.push_back(read->folder / wheel.place.value);
  }
  auto offers =
      request.frozen
          ? offers_of_lock((read->shown_folder / kLockFileName).lexically_normal(), *wheels)
          : offers_of_channels(request, channels, manifest.channel_priority, cancellation,
                               progress);
  if (!offers) return std::move(offers).errors();
  const KnownNames& known = offers->known;
  if (auto added = add_released_packages(manifest, sources_request, channels.roots, *limits,
                                         known.names, packages, sources, cancellation, progress);
      !added)
    return std::move(added).errors();
  if (auto added = add_fuel_models(manifest, sources_request, channels.roots, *limits, packages,
                                   sources, notes.warnings, cancellation, progress);
      !added)
    return std::move(added).errors();
  if (!compiler && needs_compiler(packages)) return std::move(compiler).errors();
  notes.watched.insert(notes.watched.end(), sources.watched.begin(), sources.watched.end());
  notes.remarks.insert(notes.remarks.end(), sources.remarks.begin(), sources.remarks.end());
  drop_met_by_wheels(*wheels, manifest.distro, packages);
  auto order = order_packages(packages, manifest.distro);
  if (!order) return std::move(order).errors();
  compiler = fitting_compiler(std::move(compiler), offers->compilers, request.variables,
                              channels.roots.cache);
  if (!compiler) return std::move(compiler).errors();
  auto libraries =
      ask_for_libraries(request.executable, *wheels, known, notebook_needs, *read, packages, notes);
  if (!libraries) return std::move(libraries).errors();
  if (request.frozen) {
    if (auto faults = other_libraries(offers->rest.libraries, libraries->supply.asked);
        !faults.empty()) {
      faults.back().fix.emplace_back("ros2wasm lock");
      return faults;
    }
  }
  auto left_out = left_out_packages(packages, *order, known, manifest.distro, known_build_types());
  Lacks lacks = packages_with_lacks(packages, left_out, known, manifest.distro);
  auto wanted =
      channel_request(manifest, packages, left_out, known, compiler->version, notebook_needs);
  if (!wanted) return std::move(wanted).errors();
  add_wheel_request(*wheels, known, manifest.distro, libraries->supply.asked, *wanted);
  add_specs(std::move(libraries->specs), *wanted);
  append(notes.warnings, wanted->warnings);
  auto index =
      index_for(*wanted, manifest.channel_priority,
                built_here(packages, left_out, known, manifest.distro), *offers, cancellation);
  if (!index) return std::move(index).errors();
  std::vector<std::string> all_packages = ros_names(known.names, manifest.distro);
  return Question{.read = std::move(*read),
                  .supplies = {.roots = std::move(channels.roots),
                               .limits = *limits,
                               .channel_names = known.names,
                               .client_abi = std::move(offers->client_abi),
                               .source_trees = std::move(sources.trees),
                               .wheels = std::move(*wheels),
                               .python = std::move(libraries->supply)},
                  .packages = std::move(packages),
                  .order = std::move(*order),
                  .left_out = std::move(left_out),
                  .lacks = std::move(lacks),
                  .absent = std::move(wanted->absent),
                  .compiler = std::move(*compiler),
                  .index = std::move(*index),
                  .all_packages = std::move(all_packages),
                  .specs = std::move(wanted->specs)};
}

LockRest lock_rest(const Question& question) {
  const Supplies& supplies = question.supplies;
  return {.absent = question.absent,
          .sources = sources_to_lock(supplies.source_trees, question.packages),
          .wheels = locked_wheels(supplies.wheels),
          .python_index = supplies.python.index,
          .libraries = supplies.python.asked};
}

Outcome<Resolved> resolve(const PackRequest& request, const Question& question, PackNotes& notes,
                          const Cancellation& cancellation) {
  const ReadWorkspace& read = question.read;
  const fs::path lock_file = read.folder / kLockFileName;
  auto solved = solve_with_lock(question.specs, lock_rest(question), question.index, lock_file,
                                read.manifest.channel_priority, request.locked, {}, cancellation);
  if (!solved) return std::move(solved).errors();
  if (auto refusal = refuse_own_channel(request, places_of(solved->packages), read.folder))
    return *refusal;
  if (!request.locked && !request.frozen && !request.plan_only && solved->lock_changed) {
    if (auto written = write_file(lock_file, solved->lock_text); !written)
      return std::move(written).errors();
    notes.remarks.push_back("wrote " + std::string(kLockFileName) + " (" +
                            std::to_string(solved->packages.size()) + " packages)");
  }
  return Resolved{.records = std::move(solved->packages),
                  .lock_text = std::move(solved->lock_text)};
}

}  // namespace ros2wasm
