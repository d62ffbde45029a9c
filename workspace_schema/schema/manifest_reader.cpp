// See manifest_reader.hpp. The table of the manifest's keys and what each becomes; nodes,
// parameters and the YAML itself are read by the files beside this one.
#include "workspace_schema/schema/manifest_reader.hpp"

#include <algorithm>
#include <array>

#include "workspace_schema/base/suggestion.hpp"
#include "workspace_schema/base/yaml_scalar.hpp"
#include "workspace_schema/conda/match_spec.hpp"
#include "workspace_schema/schema/manifest_binding.hpp"
#include "workspace_schema/schema/manifest_budget.hpp"
#include "workspace_schema/schema/manifest_checks.hpp"
#include "workspace_schema/schema/manifest_citation.hpp"
#include "workspace_schema/schema/manifest_launch.hpp"
#include "workspace_schema/schema/manifest_python.hpp"
#include "workspace_schema/schema/manifest_sources.hpp"
#include "workspace_schema/schema/manifest_tasks.hpp"
#include "workspace_schema/schema/page_layout.hpp"
#include "workspace_schema/schema/page_origin.hpp"

namespace ros2wasm {
namespace {

constexpr int kNewestSchema = 1;

const std::vector<std::string>& distros() {
  static const std::vector<std::string> kNames{"humble", "jazzy", "kilted", "lyrical", "rolling"};
  return kNames;
}

/// Options of `ui` and `site`: the words that each takes.
struct OptionRow {
  std::string_view name;
  std::vector<std::string> words;
};

const std::vector<OptionRow>& ui_options() {
  static const std::vector<OptionRow> kRows{
      {"theme", {"auto", "light", "dark"}},
      {"autostart", {"true", "false"}},
  };
  return kRows;
}

const std::vector<OptionRow>& site_options() {
  static const std::vector<OptionRow> kRows{
      {"exceptions", {"legacy", "standard"}},
      {"sources", {"true", "false"}},
  };
  return kRows;
}

const std::vector<KeyRow>& manifest_keys() {
  static const std::vector<KeyRow> kKeys{
      {"schema", {"schema_version", "format"}},
      {"name", {"workspace", "project"}},
      {"title", {}},
      {"version", {}},
      {"authors", {"author", "maintainers", "maintainer"}},
      {"license", {"licence", "licenses"}},
      {"citation", {"cite", "cff"}},
      {"distro", {"ros_distro", "ros", "distribution"}},
      {"channels", {"channel", "repositories"}},
      {"channel_priority", {"priority", "channel-priority"}},
      {"channel_alias", {}},
      {"mirrors", {"mirrored_channels"}},
      {"ignore_link_scripts", {"allow_link_scripts", "link_scripts", "run-post-link-scripts"}},
      {"dependencies", {"depends", "depend", "deps", "requirements"}},
      {"packages", {"package", "src"}},
      {"sources", {"source", "rosinstall", "vcs", "git"}},
      {"python", {"wheels", "pip"}},
      {"simulation", {"simulator", "gazebo", "fuel"}},
      {"launch", {"nodes", "node", "run"}},
      {"programs", {"executables", "program"}},
      {"checks", {"check", "tests", "expect"}},
      {"tasks", {"task", "exercises", "steps"}},
      {"ui", {"page"}},
      {"site", {"output"}},
  };
  return kKeys;
}

/// False when the manifest follows a schema of the future: nothing else of it can be judged then.
bool check_schema(Binder& binder, const YamlNode& root) {
  const YamlNode* node = value_of(root, "schema");
  if (node == nullptr) {
    if (Diagnostic* missing = binder.missing(root, "the manifest", "schema")) {
      missing->code = "R2W0107";
      missing->why.push_back(
          "the number tells later versions of ros2wasm how to read this file, for ever");
      missing->fix.push_back("write `schema: 1` as the first line");
    }
    return true;
  }
  const YamlValue value = scalar_value(*node);
  const auto* number = std::get_if<std::int64_t>(&value);
  if (number != nullptr && *number == kNewestSchema) return true;
  if (number != nullptr && *number > kNewestSchema) {
    Diagnostic& newer = binder.error(
        "R2W0107",
        "this manifest follows schema " + node->text + ", which is newer than this ros2wasm",
        node->range, "this ros2wasm reads schema 1");
    newer.why.push_back("ros2wasm " ROS2WASM_VERSION
                        " was made before that schema; a newer ros2wasm reads it");
    return false;
  }
  Diagnostic& wrong = binder.error("R2W0107", "`schema` must be a number that ros2wasm knows",
                                   node->range, "this ros2wasm reads schema 1");
  wrong.fix.push_back("write `schema: 1`");
  return true;
}

class Reader {
 public:
  Reader(Binder& binder, const YamlNode& root, const std::string& file, ManifestUse use)
      : binder_(binder), root_(root), use_(use) {
    manifest_.file = file;
  }

  Manifest read() {
    required_name();
    if (const YamlNode* node = given("title")) keep(binder_.line(*node, "title"), manifest_.title);
    if (const YamlNode* node = given("version"))
      keep(binder_.written(*node, "version"), manifest_.version);
    if (const YamlNode* node = given("license"))
      keep(binder_.line(*node, "license"), manifest_.license);
    if (const YamlNode* node = given("authors")) {
      binder_.list(*node, "authors", [this](const YamlNode& item) {
        if (auto author = read_author(binder_, item))
          manifest_.authors.push_back(*std::move(author));
      });
    }
    if (const YamlNode* node = given("citation"))
      manifest_.citation = read_citation(binder_, *node, root_);
    if (const YamlNode* node = given("distro")) read_distro(*node);
    read_lists();
    if (const YamlNode* node = given("sources")) read_sources(binder_, *node, manifest_);
    if (const YamlNode* node = given("python")) read_python(binder_, *node, manifest_);
    if (const YamlNode* node = given("simulation")) read_simulation(*node);
    read_what_runs();
    if (const YamlNode* node = given("programs"))
      manifest_.programs = read_programs(binder_, *node);
    if (const YamlNode* node = given("checks")) {
      binder_.list(*node, "checks", [this](const YamlNode& item) {
        if (auto check = read_check(binder_, item)) manifest_.checks.push_back(*std::move(check));
      });
    }
    if (const YamlNode* node = given("tasks")) manifest_.tasks = read_tasks(binder_, *node);
    if (const YamlNode* node = given("ui")) {
      read_options(*node, "ui", ui_options(), {"layout", "notebook", "text", "bags"}, manifest_.ui);
      if (const YamlNode* layout = value_of(*node, "layout"))
        manifest_.ui_layout = read_page_layout(binder_, *layout);
      if (const YamlNode* text = value_of(*node, "text"))
        manifest_.ui_text = binder_.path(*text, "text");
      if (const YamlNode* bags = value_of(*node, "bags")) {
        manifest_.ui_bags = binder_.texts(*bags, "bags", [this](const YamlNode& item) {
          return binder_.path(item, "an item of `bags`");
        });
      }
      if (const YamlNode* notebook = value_of(*node, "notebook"))
        manifest_.ui_notebook = binder_.path(*notebook, "notebook");
    }
    if (const YamlNode* node = given("site")) {
      read_options(*node, "site", site_options(), {"embed", "budget"}, manifest_.site);
      if (const YamlNode* embed = value_of(*node, "embed")) {
        manifest_.site_embed = binder_.texts(*embed, "embed", [this](const YamlNode& item) {
          return binder_.name(item, "an item of `embed`", page_origin_fault);
        });
      }
      if (const YamlNode* budget = value_of(*node, "budget"))
        manifest_.site_budget = read_site_budget(binder_, *budget);
    }
    return std::move(manifest_);
  }

 private:
  [[nodiscard]] const YamlNode* given(std::string_view key) const { return value_of(root_, key); }

  static void keep(std::optional<Spanned<std::string>> found, std::string& target) {
    if (found) target = std::move(found->value);
  }

  void required_name() {
    const YamlNode* node = given("name");
    if (node == nullptr) {
      if (Diagnostic* missing = binder_.missing(root_, "the manifest", "name")) {
        missing->why.push_back(
            "the name is that of the site's folder, unless another is asked for");
        missing->fix.push_back("write `name: my_workspace`");
      }
      return;
    }
    if (auto name = binder_.name(*node, "name", workspace_name_fault))
      manifest_.name = *std::move(name);
  }

  void read_distro(const YamlNode& node) {
    static const std::array<std::string, 7> kEnded{"ardent",   "bouncy", "crystal", "dashing",
                                                   "eloquent", "foxy",   "galactic"};
    static const std::array<std::string, 4> kRos1{"indigo", "kinetic", "melodic", "noetic"};
    const auto known = [](const std::string& meant) {
      return std::find(distros().begin(), distros().end(), meant) != distros().end();
    };
    auto text = binder_.text(node, "distro", known, "one of " + name_list(distros(), 12));
    if (!text) return;
    if (std::find(distros().begin(), distros().end(), text->value) != distros().end()) {
      manifest_.distro = std::move(text->value);
      return;
    }
    Diagnostic& wrong = binder_.error(
        "R2W0108", "`" + text->value + "` is not a ROS 2 distribution known here", node.range);
    wrong.why.push_back("known are: " + name_list(distros(), 12));
    if (std::find(kRos1.begin(), kRos1.end(), text->value) != kRos1.end()) {
      wrong.label = "this is a ROS 1 distribution";
    } else if (std::find(kEnded.begin(), kEnded.end(), text->value) != kEnded.end() ||
               text->value == "iron") {
      wrong.label = "this distribution has reached its end of life";
    } else if (const auto near = nearest(text->value, distros())) {
      wrong.fix.push_back("write `distro: " + *near + "`");
    }
  }

  std::optional<Spanned<std::string>> read_dependency(const YamlNode& item) {
    auto text = binder_.line(item, "an item of `dependencies`");
    if (!text) return std::nullopt;
    const Outcome<MatchSpec> spec = MatchSpec::parse(text->value);
    if (spec) return text;
    Diagnostics errors = spec.errors();
    for (Diagnostic& error : errors) error.span = text->span;
    binder_.add(std::move(errors));
    return std::nullopt;
  }

  void read_lists() {
    const auto line_of = [this](const std::string& what) {
      return [this, what](const YamlNode& item) {
        return binder_.line(item, "an item of `" + what + "`");
      };
    };
    if (const YamlNode* node = given("channels")) {
      manifest_.channels = binder_.texts(*node, "channels", line_of("channels"));
    }
    if (const YamlNode* node = given("channel_priority")) {
      const std::vector<std::string> words(kChannelPriorityWords.begin(),
                                           kChannelPriorityWords.end());
      if (const auto word = binder_.word(*node, "channel_priority", words))
        manifest_.channel_priority = channel_priority_of(word->value);
    }
    if (const YamlNode* node = given("channel_alias"))
      manifest_.channel_alias = binder_.line(*node, "channel_alias");
    if (const YamlNode* node = given("mirrors")) read_mirrors(*node);
    if (const YamlNode* node = given("ignore_link_scripts")) {
      manifest_.ignore_link_scripts =
          binder_.texts(*node, "ignore_link_scripts", [this](const YamlNode& item) {
            return binder_.name(item, "an item of `ignore_link_scripts`",
                                channel_package_name_fault);
          });
    }
    if (const YamlNode* node = given("dependencies")) {
      manifest_.dependencies = binder_.texts(
          *node, "dependencies", [this](const YamlNode& item) { return read_dependency(item); });
    }
    if (const YamlNode* node = given("packages")) {
      manifest_.packages = binder_.texts(*node, "packages", [this](const YamlNode& item) {
        return binder_.path(item, "an item of `packages`");
      });
    }
  }

  /// Each key is a channel as `channels` names it.
  void read_mirrors(const YamlNode& node) {
    if (node.kind != YamlKind::kMap) {
      binder_.wrong_type(node, "mirrors", "a mapping from channels to lists of addresses");
      return;
    }
    for (const YamlEntry& entry : node.entries) {
      manifest_.mirrors.push_back(
          {.channel = {.value = entry.key, .span = binder_.span(entry.key_range)},
           .urls = binder_.texts(entry.value, "mirrors", [this](const YamlNode& item) {
             return binder_.line(item, "an item of `mirrors`");
           })});
    }
  }

  void read_simulation(const YamlNode& node) {
    static const std::vector<KeyRow> kKeys{{"fuel", {"models", "gazebo_fuel", "fetch"}}};
    if (!binder_.mapping(node, "`simulation`", kKeys)) {
      binder_.wrong_type(node, "simulation", "a mapping");
      return;
    }
    if (const YamlNode* fuel = value_of(node, "fuel"))
      manifest_.fetches_fuel = binder_.boolean(*fuel, "fuel").value_or(false);
  }

  void read_what_runs() {
    const YamlNode* node = given("launch");
    if (node == nullptr) {
      if (use_ == ManifestUse::kPackages) return;
      if (value_of(root_, "nodes") != nullptr)
        return;  // an unknown key that meant this one was reported
      if (Diagnostic* missing = binder_.missing(root_, "the manifest", "launch")) {
        missing->why.push_back(
            "`launch` says what runs: a launch file, or a list of nodes with `package` and "
            "`executable`");
      }
      return;
    }
    read_launch(binder_, *node, manifest_);
  }

  /// `others` are keys that the caller reads.
  void read_options(const YamlNode& node, const std::string& what,
                    const std::vector<OptionRow>& rows, const std::vector<std::string_view>& others,
                    std::map<std::string, std::string>& target) {
    std::vector<KeyRow> keys;
    for (const OptionRow& row : rows) keys.push_back({.name = row.name, .also_called = {}});
    for (const std::string_view other : others) keys.push_back({.name = other, .also_called = {}});
    if (!binder_.mapping(node, "`" + what + "`", keys)) {
      binder_.wrong_type(node, what, "a mapping");
      return;
    }
    for (const OptionRow& row : rows) {
      const YamlNode* value = value_of(node, row.name);
      if (value == nullptr) continue;
      if (row.words.front() == "true") {
        if (const auto found = binder_.boolean(*value, std::string(row.name))) {
          target.emplace(row.name, *found ? "true" : "false");
        }
      } else if (const auto word = binder_.word(*value, std::string(row.name), row.words)) {
        target.emplace(row.name, word->value);
      }
    }
  }

  Binder& binder_;
  const YamlNode& root_;
  ManifestUse use_;
  Manifest manifest_{};
};

}  // namespace

Outcome<Manifest> read_manifest(std::string_view text, const std::string& file, ManifestUse use) {
  const SourceText source(text, file);
  Outcome<YamlDocument> document = parse_yaml(source);
  if (!document) return document.errors();
  Binder binder(source);
  binder.add(std::move(document->problems));
  const YamlNode& root = document->root;
  if (root.kind == YamlKind::kNull) {
    Diagnostic& empty = binder.error("R2W0103", "the manifest `" + file + "` is empty", root.range);
    empty.why.push_back("a manifest has at least `schema`, `name` and `launch`");
    return binder.take_errors();
  }
  if (root.kind == YamlKind::kMap && value_of(root, "schema") != nullptr &&
      !check_schema(binder, root)) {
    return binder.take_errors();
  }
  if (!binder.mapping(root, "the manifest", manifest_keys())) {
    binder.wrong_type(root, "manifest", "a mapping")
        .why.push_back("a manifest begins with `schema: 1`");
    return binder.take_errors();
  }
  if (value_of(root, "schema") == nullptr) check_schema(binder, root);
  Manifest manifest = Reader(binder, root, file, use).read();
  if (binder.failed()) {
    Diagnostics errors = binder.errors_in_order();
    for (Diagnostic& doubt : binder.take_warnings()) errors.push_back(std::move(doubt));
    return errors;
  }
  manifest.warnings = binder.take_warnings();
  return manifest;
}

}  // namespace ros2wasm
