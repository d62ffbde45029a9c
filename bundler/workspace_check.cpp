// See workspace_check.hpp. The steps are those of pipeline.cpp, without the ones that cost.
#include "bundler/workspace_check.hpp"

#include <algorithm>

#include "bundler/channel/channel_index.hpp"
#include "bundler/io/files.hpp"
#include "bundler/languages/language.hpp"
#include "bundler/launch/launch_graph.hpp"
#include "bundler/launch/parameter_file.hpp"
#include "bundler/launch/parameter_sources.hpp"
#include "bundler/store/store.hpp"
#include "bundler/workspace/build_order.hpp"
#include "bundler/workspace/channel_request.hpp"
#include "workspace_schema/manifest_reader.hpp"

namespace ros2wasm {
namespace fs = std::filesystem;
namespace {

constexpr const char* kEmbedded = "embedded";

void append(Diagnostics& to, const Diagnostics& more) {
  to.insert(to.end(), more.begin(), more.end());
}

/// Does everything that the workspace has not come from the channel inside the program?
bool embedded_only(const Manifest& manifest) {
  return std::all_of(manifest.channels.begin(), manifest.channels.end(),
                     [](const auto& channel) { return channel.value == kEmbedded; }) &&
         std::none_of(manifest.dependencies.begin(), manifest.dependencies.end(),
                      [](const auto& spec) { return spec.value.find("::") != std::string::npos; });
}

Diagnostics check_parameters(const Manifest& manifest, const fs::path& folder) {
  ParameterFiles files;
  Diagnostics errors = read_parameter_files(manifest.nodes, folder, files);
  for (const auto& [file, text] : files) {
    if (const auto read = read_parameter_file(text, file); !read) append(errors, read.errors());
  }
  return errors;
}

/// What nobody has. `names`: of all packages of the channels, sorted.
Diagnostics check_names(CheckReport& report, const BuildOrder& order,
                        const std::vector<std::string>& names) {
  Diagnostics errors;
  const auto wanted = channel_request(report.manifest, report.packages, order,
                                      {.names = names, .of_lock = false}, "");
  append(wanted ? report.warnings : errors, wanted ? wanted->warnings : wanted.errors());
  std::vector<std::string> packages = ros_names(names, report.manifest.distro);
  const auto causes = left_out_packages(report.packages, order);
  for (std::size_t i = 0; i < report.packages.size(); ++i) {
    if (!causes.contains(i)) packages.push_back(report.packages[i].xml.name.value);
  }
  append(errors, missing_packages(report.manifest.nodes, packages));
  return errors;
}

}  // namespace

Outcome<CheckReport> check_workspace(const CheckRequest& request,
                                     const Cancellation& cancellation) {
  const auto text = read_file(request.manifest);
  if (!text) return text.errors();
  auto manifest = read_manifest(*text, request.manifest.generic_string());
  if (!manifest) return std::move(manifest).errors();
  CheckReport report{.manifest = std::move(*manifest), .packages = {}, .warnings = {}};
  report.warnings = report.manifest.warnings;
  const fs::path folder = fs::absolute(request.manifest).parent_path();

  Diagnostics errors;
  if (auto refusal = refuse_launch_file(report.manifest)) errors.push_back(std::move(*refusal));
  auto packages =
      discover_packages(folder, request.manifest.parent_path(), report.manifest.packages,
                        ros_condition_variables(report.manifest.distro));
  if (packages) {
    report.packages = std::move(*packages);
  } else {
    append(errors, packages.errors());
  }
  const auto order = order_packages(report.packages, report.manifest.distro);
  if (order) {
    for (const auto& [index, cause] : left_out_packages(report.packages, *order))
      report.warnings.push_back(left_out_warning(report.packages[index], report.packages[cause]));
  } else {
    append(errors, order.errors());
  }
  append(errors, check_parameters(report.manifest, folder));

  ChannelRoots roots{.working_directory = folder,
                     .embedded = {},
                     .cache = default_cache_directory(request.variables),
                     .network = network_of(request.variables)};
  if (report.manifest.channel_alias) roots.network.alias = report.manifest.channel_alias->value;
  std::vector<ChannelSource> channels;
  for (const auto& channel : report.manifest.channels)
    channels.push_back({channel.value, channel.span});
  auto addresses = channel_addresses(channels, roots);
  if (!addresses) append(errors, addresses.errors());
  for (auto [spec, span] : report.manifest.dependencies) {
    if (!addresses) break;
    if (const auto added = add_named_channel(spec, span, *addresses, roots); !added)
      append(errors, added.errors());
  }

  // A program without its channel says so when it packs; the manifest is not to blame.
  const auto embedded = embedded_channel(request.executable);
  if (packages && order && embedded && embedded_only(report.manifest)) {
    roots.embedded = *embedded;
    const ChannelSource source{.name = kEmbedded, .span = std::nullopt};
    const auto open = open_channels({&source, 1}, roots, cancellation);
    if (!open) return open.errors();
    append(errors, check_names(report, *order, open->names()));
  }
  if (!errors.empty()) {
    // What is left out may be the reason.
    append(errors, report.warnings);
    return errors;
  }
  return report;
}

}  // namespace ros2wasm
