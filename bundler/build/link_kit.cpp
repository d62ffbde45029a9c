// See link_kit.hpp. In a kit lies the file `arguments`, one a line, beside the copies. The folder
// of a base class's package has the file `named`, which CMake writes when it configures
// (pluginlib's package hook): the names of the kits, one a line. In a package of a channel a kit
// names what is installed too by its place in the prefix.
#include "bundler/build/link_kit.hpp"

#include <algorithm>
#include <functional>
#include <sstream>

#include "bundler/io/files.hpp"

namespace ros2wasm {
namespace fs = std::filesystem;
namespace {

constexpr std::string_view kPluginsOf = "--ros2wasm-plugins-of=";
constexpr std::string_view kPluginLibrary = "libpluginlib.a";
constexpr const char* kInstalled = kLinkKitFolder;
constexpr const char* kPrograms = "programs";
constexpr const char* kPlugins = "plugins";
constexpr const char* kArguments = "arguments";
constexpr const char* kNamed = "named";
constexpr std::string_view kOfKit = "kit:";        // before the name of a copy
constexpr std::string_view kOfPrefix = "prefix:";  // before the place of an installed file

fs::path index_entry(const std::string& base, const std::string& package) {
  return fs::path("share/ament_index/resource_index") / (base + "__pluginlib__plugin") / package;
}

Outcome<Done> copied(const fs::path& from, const fs::path& to) {
  const auto bytes = read_file(from, kMostOfData);
  if (!bytes) return bytes.errors();
  return write_file(to, *bytes);
}

Outcome<std::string> kept_argument(const std::string& argument, std::size_t index,
                                   const fs::path& kit) {
  std::error_code error;
  if (argument.starts_with('-') || !fs::is_regular_file(argument, error)) return argument;
  const fs::path file = fs::weakly_canonical(argument, error);
  const fs::path below = file.lexically_relative(fs::current_path(error));
  if (below.empty() || *below.begin() == "..") return file.string();
  const std::string name = std::to_string(index) + "/" + file.filename().string();
  if (auto done = copied(file, kit / name); !done) return std::move(done).errors();
  return std::string(kOfKit) + name;
}

Outcome<std::vector<std::string>> lines_of(const fs::path& file) {
  const auto text = read_file(file, kMostOfData);
  if (!text) return text.errors();
  std::vector<std::string> result;
  std::istringstream lines(*text);
  for (std::string line; std::getline(lines, line);) result.push_back(line);
  return result;
}

/// Whether a path below a folder stays in it.
bool is_inside(const fs::path& below) {
  const fs::path plain = below.lexically_normal();
  return !plain.empty() && !plain.is_absolute() && *plain.begin() != "..";
}

Outcome<LinkKit> read_kit(const fs::path& folder, const fs::path& prefix) {
  const auto lines = lines_of(folder / kArguments);
  if (!lines) return lines.errors();
  LinkKit kit{.name = folder.filename().string(), .base = {}, .arguments = {}};
  for (const std::string& line : *lines) {
    const bool is_copy = line.starts_with(kOfKit);
    if (!is_copy && !line.starts_with(kOfPrefix)) {
      kit.arguments.push_back(line);
      continue;
    }
    const fs::path& base = is_copy ? folder : prefix;
    const fs::path file = line.substr((is_copy ? kOfKit : kOfPrefix).size());
    if (!is_inside(file))
      return Diagnostic{.code = "R2W0505",
                        .message = "the program `" + kit.name + "` cannot be linked again",
                        .why = {"its package names the file `" + file.string() +
                                "`, which would not be a part of it"}};
    kit.arguments.push_back((base / file).string());
  }
  return kit;
}

std::vector<fs::path> folders_in(const fs::path& parent) {
  std::vector<fs::path> result;
  std::error_code error;
  for (fs::directory_iterator it(parent, error), end; !error && it != end; it.increment(error))
    result.push_back(it->path());
  std::sort(result.begin(), result.end());
  return result;
}

Outcome<std::vector<LinkKit>> kits_in(const fs::path& folder, const fs::path& prefix) {
  std::vector<LinkKit> result;
  for (const fs::path& one : folders_in(folder)) {
    auto kit = read_kit(one, prefix);
    if (!kit) return std::move(kit).errors();
    result.push_back(std::move(*kit));
  }
  return result;
}

Outcome<Done> install_kit(const fs::path& from, const fs::path& to) {
  const auto tree = list_tree(from);
  if (!tree) return tree.errors();
  for (const TreeEntry& entry : *tree) {
    if (entry.kind != FileKind::kFile) continue;
    if (auto done = copied(from / entry.path, to / entry.path); !done) return done;
  }
  return Done{};
}

bool have_same_bytes(const fs::path& one, const fs::path& other) {
  std::error_code error;
  if (fs::file_size(one, error) != fs::file_size(other, error) || error) return false;
  const auto first = read_file(one, kMostOfData);
  const auto second = read_file(other, kMostOfData);
  return first && second && *first == *second;
}

/// The place of a file below one of the prefixes; empty when it is in none of them.
fs::path place_below(const fs::path& file, const std::vector<fs::path>& prefixes) {
  for (const fs::path& prefix : prefixes) {
    const fs::path below = file.lexically_relative(prefix);
    if (!below.empty() && *below.begin() != "..") return below;
  }
  return {};
}

/// An argument of a kit as it stands in a package of a channel.
Outcome<std::string> movable_argument(const std::string& argument, const fs::path& kit,
                                      const fs::path& prefix,
                                      const std::vector<fs::path>& prefixes) {
  if (argument.starts_with(kOfKit)) {
    const fs::path copy = kit / argument.substr(kOfKit.size());
    const fs::path installed = fs::path("lib") / copy.filename();
    if (have_same_bytes(copy, prefix / installed))
      return std::string(kOfPrefix) + installed.string();
    return argument;
  }
  if (!fs::path(argument).is_absolute()) return argument;
  const fs::path below = place_below(argument, prefixes);
  if (below.empty())
    return Diagnostic{.code = "R2W0505",
                      .message = "the program `" + kit.filename().string() +
                                 "` cannot be linked elsewhere with more plugins",
                      .why = {"it is linked with " + argument + ", which is in no package"}};
  return std::string(kOfPrefix) + below.string();
}

Outcome<Done> install_movable_kit(const fs::path& from, const fs::path& to, const fs::path& prefix,
                                  const fs::path& environment) {
  const auto lines = lines_of(from / kArguments);
  if (!lines) return lines.errors();
  std::string text;
  for (const std::string& line : *lines) {
    const auto argument = movable_argument(line, from, prefix, {environment});
    if (!argument) return argument.errors();
    text += *argument + "\n";
    if (!argument->starts_with(kOfKit)) continue;
    const std::string copy = argument->substr(kOfKit.size());
    if (auto done = copied(from / copy, to / copy); !done) return done;
  }
  return write_file(to / kArguments, text);
}

/// In place: copies that are installed too are removed.
Outcome<Done> make_kit_movable(const fs::path& kit, const fs::path& prefix,
                               const std::vector<fs::path>& prefixes) {
  const auto lines = lines_of(kit / kArguments);
  if (!lines) return lines.errors();
  std::string text;
  for (const std::string& line : *lines) {
    const auto argument = movable_argument(line, kit, prefix, prefixes);
    if (!argument) return argument.errors();
    text += *argument + "\n";
    if (!line.starts_with(kOfKit) || argument->starts_with(kOfKit)) continue;
    const fs::path copy = kit / line.substr(kOfKit.size());
    if (auto done = remove_tree(copy.parent_path()); !done) return done;
  }
  return write_file(kit / kArguments, text);
}

using InstallKit = std::function<Outcome<Done>(const fs::path& from, const fs::path& to)>;

Outcome<Done> install_program_kits(const fs::path& kits, const fs::path& prefix,
                                   const std::string& package, const InstallKit& install) {
  std::error_code error;
  for (const fs::path& kit : folders_in(kits / kPrograms)) {
    const std::string file = kit.filename().string() + ".wasm";
    if (!fs::exists(prefix / "lib" / package / file, error)) continue;
    const fs::path to = prefix / kInstalled / package / kPrograms / kit.filename();
    if (auto done = install(kit, to); !done) return done;
  }
  return Done{};
}

/// As rclcpp_components makes them for each package (its package hook).
bool is_container(const LinkLine& line) {
  const std::string name = fs::path(line.output).stem().string();
  return name == "component_container" || name == "component_container_mt" ||
         name == "component_container_isolated";
}

/// A kit may be left from a time when the sources said otherwise: only what is named counts.
Outcome<std::vector<std::string>> named_kits(const fs::path& folder) {
  return lines_of(folder / kNamed);
}

Outcome<Done> install_plugin_kits(const fs::path& kits, const fs::path& prefix,
                                  const std::string& package, const InstallKit& install) {
  std::error_code error;
  for (const fs::path& base : folders_in(kits / kPlugins)) {
    if (!fs::exists(prefix / index_entry(base.filename().string(), package), error)) continue;
    const auto names = named_kits(base);
    if (!names) return names.errors();
    for (const std::string& name : *names) {
      const fs::path to = prefix / kInstalled / package / kPlugins / base.filename() / name;
      if (auto done = install(base / name, to); !done) return done;
    }
  }
  return Done{};
}

}  // namespace

std::optional<std::string> plugins_of(const LinkLine& line) {
  for (const std::string& argument : line.arguments)
    if (argument.starts_with(kPluginsOf)) return argument.substr(kPluginsOf.size());
  return std::nullopt;
}

bool loads_plugins(const std::vector<std::string>& arguments) {
  return std::any_of(arguments.begin(), arguments.end(), [](const std::string& one) {
    return fs::path(one).filename() == kPluginLibrary;
  });
}

Outcome<Done> keep_link_kit(const fs::path& kits, const LinkLine& line) {
  const auto base = plugins_of(line);
  const fs::path kit =
      (base ? kits / kPlugins / *base : kits / kPrograms) / fs::path(line.output).stem();
  if (auto cleared = remove_tree(kit); !cleared) return cleared;
  if (!base && !loads_plugins(line.arguments) && !is_container(line)) return Done{};
  std::string text;
  for (std::size_t i = 0; i < line.arguments.size(); ++i) {
    if (line.arguments[i].starts_with(kPluginsOf)) continue;
    const auto kept = kept_argument(line.arguments[i], i, kit);
    if (!kept) return kept.errors();
    text += *kept + "\n";
  }
  return write_file(kit / kArguments, text);
}

Outcome<Done> install_link_kits(const fs::path& kits, const fs::path& prefix,
                                const std::string& package) {
  if (auto done = install_program_kits(kits, prefix, package, install_kit); !done) return done;
  return install_plugin_kits(kits, prefix, package, install_kit);
}

Outcome<Done> install_movable_kits(const fs::path& kits, const fs::path& prefix,
                                   const std::string& package, const fs::path& environment) {
  const InstallKit install = [&](const fs::path& from, const fs::path& to) {
    return install_movable_kit(from, to, prefix, environment);
  };
  const InstallKit install_program = [&](const fs::path& from, const fs::path& to) {
    const auto arguments = lines_of(from / kArguments);
    if (!arguments) return Outcome<Done>(arguments.errors());
    return loads_plugins(*arguments) ? install(from, to) : Outcome<Done>(Done{});
  };
  if (auto done = install_program_kits(kits, prefix, package, install_program); !done) return done;
  return install_plugin_kits(kits, prefix, package, install);
}

Outcome<Done> make_kits_movable(const fs::path& prefix, const std::string& package,
                                const std::vector<fs::path>& prefixes) {
  const fs::path own = prefix / kInstalled / package;
  for (const fs::path& kit : folders_in(own / kPrograms)) {
    const auto arguments = lines_of(kit / kArguments);
    if (!arguments) return arguments.errors();
    auto done =
        loads_plugins(*arguments) ? make_kit_movable(kit, prefix, prefixes) : remove_tree(kit);
    if (!done) return done;
  }
  for (const fs::path& base : folders_in(own / kPlugins)) {
    for (const fs::path& kit : folders_in(base))
      if (auto done = make_kit_movable(kit, prefix, prefixes); !done) return done;
  }
  return Done{};
}

std::vector<std::string> packages_with_kits(const fs::path& prefix) {
  std::vector<std::string> result;
  for (const fs::path& one : folders_in(prefix / kInstalled))
    result.push_back(one.filename().string());
  return result;
}

Outcome<std::vector<LinkKit>> program_kits(const fs::path& prefix, const std::string& package) {
  return kits_in(prefix / kInstalled / package / kPrograms, prefix);
}

Outcome<std::vector<LinkKit>> plugin_kits(const fs::path& prefix, const std::string& package) {
  std::vector<LinkKit> result;
  for (const fs::path& base : folders_in(prefix / kInstalled / package / kPlugins)) {
    auto kits = kits_in(base, prefix);
    if (!kits) return std::move(kits).errors();
    for (LinkKit& kit : *kits) {
      kit.base = base.filename().string();
      result.push_back(std::move(kit));
    }
  }
  return result;
}

}  // namespace ros2wasm
