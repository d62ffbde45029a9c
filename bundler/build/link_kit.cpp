// See link_kit.hpp. In a kit lies the file `arguments`, one a line, beside the copies. The folder
// of a base class's package has the file `named`, which CMake writes when it configures
// (pluginlib's package hook): the names of the kits, one a line.
#include "bundler/build/link_kit.hpp"

#include <algorithm>
#include <sstream>

#include "bundler/io/files.hpp"

namespace ros2wasm {
namespace fs = std::filesystem;
namespace {

constexpr std::string_view kPluginsOf = "--ros2wasm-plugins-of=";
constexpr std::string_view kPluginLibrary = "libpluginlib.a";
constexpr const char* kInstalled = "link_kits";  // in a prefix
constexpr const char* kPrograms = "programs";
constexpr const char* kPlugins = "plugins";
constexpr const char* kArguments = "arguments";
constexpr const char* kNamed = "named";
constexpr std::string_view kOfKit = "kit:";  // before the name of a copy

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

Outcome<LinkKit> read_kit(const fs::path& folder) {
  const auto text = read_file(folder / kArguments, kMostOfData);
  if (!text) return text.errors();
  LinkKit kit{.name = folder.filename().string(), .base = {}, .arguments = {}};
  std::istringstream lines(*text);
  for (std::string line; std::getline(lines, line);) {
    const bool is_copy = line.starts_with(kOfKit);
    kit.arguments.push_back(is_copy ? (folder / line.substr(kOfKit.size())).string() : line);
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

Outcome<std::vector<LinkKit>> kits_in(const fs::path& folder) {
  std::vector<LinkKit> result;
  for (const fs::path& one : folders_in(folder)) {
    auto kit = read_kit(one);
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

/// As rclcpp_components makes them for each package (its package hook).
bool is_container(const LinkLine& line) {
  const std::string name = fs::path(line.output).stem().string();
  return name == "component_container" || name == "component_container_mt" ||
         name == "component_container_isolated";
}

/// A kit may be left from a time when the sources said otherwise: only what is named counts.
Outcome<std::vector<std::string>> named_kits(const fs::path& folder) {
  const auto text = read_file(folder / kNamed, kMostOfData);
  if (!text) return text.errors();
  std::vector<std::string> result;
  std::istringstream lines(*text);
  for (std::string line; std::getline(lines, line);) result.push_back(line);
  return result;
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
  std::error_code error;
  for (const fs::path& kit : folders_in(kits / kPrograms)) {
    const std::string file = kit.filename().string() + ".wasm";
    if (!fs::exists(prefix / "lib" / package / file, error)) continue;
    const fs::path to = prefix / kInstalled / kPrograms / kit.filename();
    if (auto done = install_kit(kit, to); !done) return done;
  }
  for (const fs::path& base : folders_in(kits / kPlugins)) {
    if (!fs::exists(prefix / index_entry(base.filename().string(), package), error)) continue;
    const auto names = named_kits(base);
    if (!names) return names.errors();
    for (const std::string& name : *names) {
      const fs::path to = prefix / kInstalled / kPlugins / base.filename() / name;
      if (auto done = install_kit(base / name, to); !done) return done;
    }
  }
  return Done{};
}

Outcome<std::vector<LinkKit>> program_kits(const fs::path& prefix) {
  return kits_in(prefix / kInstalled / kPrograms);
}

Outcome<std::vector<LinkKit>> plugin_kits(const fs::path& prefix) {
  std::vector<LinkKit> result;
  for (const fs::path& base : folders_in(prefix / kInstalled / kPlugins)) {
    auto kits = kits_in(base);
    if (!kits) return std::move(kits).errors();
    for (LinkKit& kit : *kits) {
      kit.base = base.filename().string();
      result.push_back(std::move(kit));
    }
  }
  return result;
}

}  // namespace ros2wasm
