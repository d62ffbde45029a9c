// See container_link.hpp.
#include "bundler/build/container_link.hpp"

#include <algorithm>

#include "bundler/build/link_kit.hpp"
#include "bundler/build/plugin_link.hpp"
#include "bundler/build/second_link.hpp"
#include "bundler/build/source_hash.hpp"

namespace ros2wasm {
namespace fs = std::filesystem;
namespace {

/// The function main() of the containers, one for those without threads and one for the others.
bool is_main(const std::string& argument) {
  const std::string name = fs::path(argument).filename().string();
  return name == "component_container.cpp.o" || name == "component_container_mt.cpp.o";
}

Outcome<LinkKit> kit_of(const BuiltPackage& package, const std::string& container) {
  auto kits = program_kits(package.prefix, package.name);
  if (!kits) return std::move(kits).errors();
  for (LinkKit& kit : *kits)
    if (kit.name == container) return std::move(kit);
  return Diagnostic{.code = "R2W0505",
                    .message = "package `" + package.name + "` has no container `" + container +
                               "` that could be linked with components of others"};
}

}  // namespace

Outcome<fs::path> link_container(const std::string& container, const std::string& program,
                                 const std::vector<std::string>& component_packages,
                                 const std::vector<LocalPackage>& packages,
                                 const std::vector<BuiltPackage>& built, const BuildTools& tools,
                                 const BuildSettings& settings, const Cancellation& cancellation,
                                 const ProgressSink& progress) {
  LinkKit all{.name = program, .base = {}, .arguments = {}};
  HashBuilder hash;
  hash.add("container", container).add("link", tools.quick ? "quick" : "small");
  const BuiltPackage* first = nullptr;
  for (const std::string& name : component_packages) {
    const auto package = std::find_if(built.begin(), built.end(),
                                      [&](const BuiltPackage& one) { return one.name == name; });
    if (package == built.end())
      return Diagnostic{.code = "R2W0505",
                        .message = "components of package `" + name +
                                   "` cannot be in one container with those of other packages",
                        .why = {"it is not a package of the workspace"}};
    auto kit = kit_of(*package, container);
    if (!kit) return std::move(kit).errors();
    hash.add(name, package->hash);
    for (std::string& argument : kit->arguments)
      if (first == nullptr || !is_main(argument)) all.arguments.push_back(std::move(argument));
    if (first == nullptr) first = &*package;
  }
  const std::vector<BuiltPackage> with_channels = with_channel_packages(built, settings);
  const auto libraries = plugin_libraries(with_channels);
  if (!libraries) return libraries.errors();
  std::vector<const PluginLibrary*> plugins;
  if (loads_plugins(all.arguments))
    plugins = plugins_for(component_packages, packages, settings, *libraries);
  for (const PluginLibrary* one : plugins)
    hash.add(one->package->name, one->package->hash).add(one->kit.base, one->kit.name);
  return link_again({.package = *first,
                     .program = program,
                     .hash = hash.finish(),
                     .arguments = arguments_with_plugins(all, plugins, with_channels)},
                    tools, settings.cache, cancellation, progress);
}

}  // namespace ros2wasm
