// See plugin_link.hpp.
#include "bundler/build/plugin_link.hpp"

#include <algorithm>
#include <set>

#include "bundler/build/link_kit.hpp"
#include "bundler/build/second_link.hpp"
#include "bundler/build/source_hash.hpp"
#include "bundler/io/files.hpp"

namespace ros2wasm {
namespace fs = std::filesystem;
namespace {

constexpr const char* kWhole = "-Wl,--whole-archive";
constexpr const char* kNotWhole = "-Wl,--no-whole-archive";

/// Empty when a package of the channels has none, or none that can be read.
std::vector<PackageDependency> channel_needs(const std::string& name, const fs::path& prefix) {
  const fs::path file = prefix / "share" / name / "package.xml";
  const auto text = read_file(file, kMostOfText);
  if (!text) return {};
  auto xml = parse_package_xml(*text, file.string(), {});
  return xml ? std::move(xml->dependencies) : std::vector<PackageDependency>{};
}

/// The packages and all that they need, by name.
std::set<std::string> needs_of(std::vector<std::string> open,
                               const std::vector<LocalPackage>& packages,
                               const fs::path& environment) {
  std::set<std::string> result;
  while (!open.empty()) {
    const std::string one = std::move(open.back());
    open.pop_back();
    if (!result.insert(one).second) continue;
    const auto local = std::find_if(packages.begin(), packages.end(), [&](const LocalPackage& it) {
      return it.xml.name.value == one;
    });
    const auto needs =
        local == packages.end() ? channel_needs(one, environment) : local->xml.dependencies;
    for (const PackageDependency& needed : needs) open.push_back(needed.name.value);
  }
  return result;
}

/// The name of a library, and the package that it lies with, as itself or as a copy of a kit; a
/// library of none of them is one of its own folder.
using LibraryName = std::pair<std::string, std::string>;

LibraryName name_of(const fs::path& library, const std::vector<BuiltPackage>& built) {
  std::error_code error;
  const fs::path real = fs::weakly_canonical(library, error);
  for (const BuiltPackage& package : built) {
    const fs::path below = real.lexically_relative(fs::weakly_canonical(package.prefix, error));
    if (!below.empty() && *below.begin() != "..") return {package.name, real.filename().string()};
  }
  return {real.parent_path().string(), real.filename().string()};
}

std::string hash_of(const BuiltPackage& package, const LinkKit& program,
                    const std::vector<const PluginLibrary*>& plugins, const BuildTools& tools) {
  HashBuilder hash;
  hash.add("package", package.hash).add("program", program.name);
  hash.add("link", tools.quick ? "quick" : "small");
  for (const PluginLibrary* one : plugins)
    hash.add(one->package->name, one->package->hash).add(one->kit.base, one->kit.name);
  return hash.finish();
}

}  // namespace

std::vector<std::string> arguments_with_plugins(const LinkKit& program,
                                                const std::vector<const PluginLibrary*>& plugins,
                                                const std::vector<BuiltPackage>& built) {
  std::vector<std::string> whole;
  std::vector<std::string> rest = program.arguments;
  for (const PluginLibrary* one : plugins)
    for (const std::string& argument : one->kit.arguments)
      if (!argument.ends_with(".o")) rest.push_back(argument);
  std::set<LibraryName> taken;  // which are whole already
  for (std::size_t i = 1; i < rest.size(); ++i)
    if (rest[i - 1] == kWhole) taken.insert(name_of(rest[i], built));
  for (const PluginLibrary* one : plugins) {
    const auto& given = one->kit.arguments;
    const auto library = std::find_if(given.begin(), given.end(),
                                      [](const std::string& text) { return text.ends_with(".a"); });
    if (library == given.end() || !taken.insert(name_of(*library, built)).second) continue;
    whole.insert(whole.end(), {kWhole, *library, kNotWhole});
  }
  whole.insert(whole.end(), rest.begin(), rest.end());
  return whole;
}

std::vector<BuiltPackage> with_channel_packages(const std::vector<BuiltPackage>& built,
                                                const BuildSettings& settings) {
  std::vector<BuiltPackage> result = built;
  for (std::string& name : packages_with_kits(settings.environment_prefix)) {
    // A package of the workspace takes the place of the channel's.
    const bool is_local = std::any_of(built.begin(), built.end(),
                                      [&](const BuiltPackage& one) { return one.name == name; });
    if (is_local) continue;
    result.push_back({.name = std::move(name),
                      .version = {},
                      .prefix = settings.environment_prefix,
                      .hash = settings.environment_key});
  }
  return result;
}

Outcome<std::vector<PluginLibrary>> plugin_libraries(const std::vector<BuiltPackage>& built) {
  std::vector<PluginLibrary> result;
  for (const BuiltPackage& package : built) {
    auto kits = plugin_kits(package.prefix, package.name);
    if (!kits) return std::move(kits).errors();
    for (LinkKit& kit : *kits) result.push_back({.kit = std::move(kit), .package = &package});
  }
  return result;
}

std::vector<const PluginLibrary*> plugins_for(const std::vector<std::string>& names,
                                              const std::vector<LocalPackage>& packages,
                                              const BuildSettings& settings,
                                              const std::vector<PluginLibrary>& libraries) {
  const std::set<std::string> needs = needs_of(names, packages, settings.environment_prefix);
  std::vector<const PluginLibrary*> result;
  for (const PluginLibrary& one : libraries)
    if (needs.contains(one.kit.base)) result.push_back(&one);
  return result;
}

Outcome<std::map<fs::path, fs::path>> link_plugins(const std::vector<LocalPackage>& packages,
                                                   const std::vector<BuiltPackage>& built,
                                                   const BuildTools& tools,
                                                   const BuildSettings& settings,
                                                   const Cancellation& cancellation,
                                                   const ProgressSink& progress) {
  const std::vector<BuiltPackage> with_channels = with_channel_packages(built, settings);
  const auto all = plugin_libraries(with_channels);
  if (!all) return all.errors();
  std::map<fs::path, fs::path> result;
  if (all->empty()) return result;
  const auto is_channels = [&](const BuiltPackage& one) {
    return one.prefix == settings.environment_prefix;
  };
  Diagnostics errors;
  for (const BuiltPackage& package : with_channels) {
    const auto programs = program_kits(package.prefix, package.name);
    if (!programs) return programs.errors();
    if (programs->empty()) continue;
    const auto wanted = plugins_for({package.name}, packages, settings, *all);
    // A program of a channel was linked with the channel's plugins where it was made.
    const bool has_news = std::any_of(wanted.begin(), wanted.end(), [&](const PluginLibrary* one) {
      return !is_channels(package) || !is_channels(*one->package);
    });
    if (!has_news) continue;
    for (const LinkKit& program : *programs) {
      if (!loads_plugins(program.arguments)) continue;  // a container of components
      auto file = link_again({.package = package,
                              .program = program.name,
                              .hash = hash_of(package, program, wanted, tools),
                              .arguments = arguments_with_plugins(program, wanted, with_channels)},
                             tools, settings.cache, cancellation, progress);
      if (!file) {
        for (Diagnostic& one : std::move(file).errors()) errors.push_back(std::move(one));
        continue;
      }
      result[package.prefix / "lib" / package.name / (program.name + ".wasm")] = std::move(*file);
    }
  }
  if (!errors.empty()) return errors;
  return result;
}

}  // namespace ros2wasm
