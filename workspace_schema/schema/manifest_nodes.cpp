// See manifest_nodes.hpp.
#include "workspace_schema/schema/manifest_nodes.hpp"

#include <array>
#include <map>

#include "workspace_schema/base/yaml_scalar.hpp"
#include "workspace_schema/schema/manifest_parameters.hpp"

namespace ros2wasm {
namespace {

const std::vector<KeyRow>& node_keys() {
  static const std::vector<KeyRow> kKeys{
      {"package", {"pkg"}},
      {"executable", {"exec", "node_executable", "exe"}},
      {"name", {"node_name", "exec_name"}},
      {"namespace", {"ns", "node_namespace"}},
      {"remappings", {"remap", "remaps"}},
      {"parameters", {"param", "params", "parameter"}},
      {"arguments", {"args", "ros_arguments"}},
      {"output", {}},
      {"respawn", {}},
  };
  return kKeys;
}

/// Where a topic name begins behind `rostopic://`, `rosservice://` and `node:`.
std::size_t behind_prefixes(std::string_view from) {
  std::size_t start = 0;
  for (const std::string_view scheme : {"rostopic://", "rosservice://"}) {
    if (from.starts_with(scheme)) return scheme.size();
  }
  const std::size_t colon = from.find(':');
  if (colon != std::string_view::npos && !node_name_fault(from.substr(0, colon))) start = colon + 1;
  for (const std::string_view scheme : {"rostopic://", "rosservice://"}) {
    if (from.substr(start).starts_with(scheme)) start += scheme.size();
  }
  return start;
}

class NodeReader {
 public:
  NodeReader(Binder& binder, NodeEntry& entry) : binder_(binder), entry_(entry) {}

  void read_remappings(const YamlNode& node) {
    if (node.kind == YamlKind::kMap) {
      for (const YamlEntry& pair : node.entries) {
        const YamlNode from{.kind = YamlKind::kScalar,
                            .range = pair.key_range,
                            .verbatim = pair.key_range.length == pair.key.size(),
                            .text_offset = pair.key_range.offset,
                            .text = pair.key};
        add_pair(from, pair.value);
      }
    } else if (node.kind == YamlKind::kSequence) {
      for (const YamlNode& item : node.items) read_remapping(item);
    } else {
      Diagnostic& wrong = binder_.wrong_type(node, "remappings", "a list");
      if (node.kind == YamlKind::kScalar && node.text.find(":=") != std::string::npos) {
        wrong.fix.push_back("write `remappings: [" + as_yaml_text(node.text) + "]`");
      }
    }
  }

  void read_output(const YamlNode& node) {
    static const std::array<std::string, 3> kWords{"screen", "log", "both"};
    const auto word = binder_.word(node, "output", kWords);
    if (!word) return;
    entry_.output = word->value == "screen" ? NodeOutput::kScreen
                    : word->value == "log"  ? NodeOutput::kLog
                                            : NodeOutput::kBoth;
  }

  void read_arguments(const YamlNode& node) {
    if (node.kind == YamlKind::kScalar && node.text.find(' ') != std::string::npos) {
      split_arguments(node);
      return;
    }
    binder_.list(node, "arguments", [this](const YamlNode& item) {
      const YamlValue value = scalar_value(item);
      if (std::holds_alternative<bool>(value)) {
        entry_.arguments.push_back(item.text);
      } else if (const auto* text = std::get_if<std::string>(&value)) {
        entry_.arguments.push_back(
            *text);  // may be empty, may have lines: a program takes any text
      } else if (auto word = binder_.written(item, "an item of `arguments`")) {
        entry_.arguments.push_back(word->value);
      }
    });
  }

 private:
  void split_arguments(const YamlNode& node) {
    Diagnostic& wrong = binder_.wrong_type(node, "arguments", "a list");
    if (node.text.find_first_of("\"'\\\n\t") != std::string::npos) return;
    std::string list;
    for (std::size_t begin = 0; begin < node.text.size();) {
      const std::size_t end = std::min(node.text.find(' ', begin), node.text.size());
      if (end > begin)
        list += (list.empty() ? "" : ", ") + as_yaml_text(node.text.substr(begin, end - begin));
      begin = end + 1;
    }
    wrong.fix.push_back("write `arguments: [" + list + "]`");
  }

  void read_remapping(const YamlNode& item) {
    if (item.kind == YamlKind::kMap) {
      read_pair_map(item);
      return;
    }
    if (!std::holds_alternative<std::string>(scalar_value(item))) {
      binder_.wrong_type(item, "an item of `remappings`",
                         "`from:=to`, or a mapping with `from` and `to`");
      return;
    }
    const std::size_t sign = item.text.find(":=");
    if (sign == std::string::npos) {
      binder_
          .error("R2W0110", "`" + item.text + "` is not a remapping", item.range,
                 "there is no `:=` in it")
          .why.push_back("a remapping says which name becomes which: `from:=to`");
      return;
    }
    YamlNode from = item;
    from.text = item.text.substr(0, sign);
    YamlNode to = item;
    to.text = item.text.substr(sign + 2);
    to.text_offset = item.text_offset + sign + 2;
    add_pair(from, to);
  }

  void read_pair_map(const YamlNode& item) {
    static const std::vector<KeyRow> kKeys{{"from", {}}, {"to", {}}};
    const YamlNode* from = value_of(item, "from");
    const YamlNode* to = value_of(item, "to");
    if (from == nullptr && to == nullptr && item.entries.size() == 1) {
      // `- chatter: news`: clear enough to say how it is written.
      const YamlEntry& only = item.entries.front();
      Diagnostic& wrong =
          binder_.error("R2W0110", "a remapping in a list has the keys `from` and `to`",
                        only.key_range, "this is neither");
      if (only.value.kind == YamlKind::kScalar && !topic_name_fault(only.key) &&
          !topic_name_fault(only.value.text)) {
        wrong.fix.push_back("write `- " + only.key + ":=" + only.value.text + "`");
      }
      return;
    }
    binder_.mapping(item, "a remapping", kKeys);
    for (const auto& [key, value] : {std::pair("from", from), std::pair("to", to)}) {
      if (value == nullptr) binder_.missing(item, "a remapping", key);
    }
    if (from == nullptr || to == nullptr) return;
    const auto from_text = binder_.text(*from, "from");
    const auto to_text = binder_.text(*to, "to");
    if (from_text && to_text) add_pair(*from, *to);
  }

  void add_pair(const YamlNode& from, const YamlNode& to) {
    for (const auto& [special, key] : {std::pair("__node", "name"), std::pair("__name", "name"),
                                       std::pair("__ns", "namespace")}) {
      if (from.text != special) continue;
      Diagnostic& wrong =
          binder_.error("R2W0110", "`" + from.text + "` is not remapped here", from.range);
      wrong.why.push_back("the manifest has a key for it");
      if (to.kind == YamlKind::kScalar)
        wrong.fix.push_back(std::string("write `") + key + ": " + as_yaml_text(to.text) +
                            "` beside `executable`");
      return;
    }
    const bool good_from = check_name(from, behind_prefixes(from.text));
    if (to.kind != YamlKind::kScalar) {
      binder_.wrong_type(to, from.text, "the name that it becomes");
      return;
    }
    if (check_name(to, 0) && good_from) entry_.remappings.emplace_back(from.text, to.text);
  }

  bool check_name(const YamlNode& node, std::size_t start) {
    const std::string_view topic = std::string_view(node.text).substr(start);
    const auto fault = topic_name_fault(topic);
    if (!fault) return true;
    if (topic.empty()) {
      binder_.error("R2W0110", "one side of a remapping is empty", node.range,
                    "expected `from:=to`");
    } else {
      binder_.name_error(node,
                         "`" + std::string(topic) + "` cannot be the name of a topic or service",
                         start, *fault);
    }
    return false;
  }

  Binder& binder_;
  NodeEntry& entry_;
};

std::string full_name(const NodeEntry& node) {
  std::string space = node.name_space ? node.name_space->value : "/";
  if (space != "/") space += '/';
  return node.name ? space + node.name->value : std::string();
}

}  // namespace

std::optional<NodeEntry> read_node(Binder& binder, const YamlNode& node) {
  if (!binder.mapping(node, "a node of `launch`", node_keys())) {
    Diagnostic& wrong = binder.wrong_type(node, "an item of `launch`", "a node");
    wrong.why.push_back("each node is a mapping with at least `package` and `executable`");
    return std::nullopt;
  }
  NodeEntry entry;
  entry.span = binder.span(node);
  const auto given = [&](std::string_view key) { return value_of(node, key); };
  bool complete = true;
  for (const auto& [key, check, target] :
       {std::tuple("package", &package_name_fault, &entry.package),
        std::tuple("executable", &executable_name_fault, &entry.executable)}) {
    if (const YamlNode* value = given(key)) {
      auto name = binder.name(*value, key, check);
      complete = complete && name.has_value();
      if (name) *target = *std::move(name);
    } else {
      complete = false;
      binder.missing(node, "a node", key);
    }
  }
  NodeReader reader(binder, entry);
  if (const YamlNode* value = given("name"))
    entry.name = binder.name(*value, "name", node_name_fault);
  if (const YamlNode* value = given("namespace")) {
    entry.name_space = binder.name(*value, "namespace", namespace_fault);
    // As launch_ros takes one without a slash.
    if (entry.name_space) entry.name_space->value = absolute_name(entry.name_space->value);
  }
  if (const YamlNode* value = given("remappings")) reader.read_remappings(*value);
  if (const YamlNode* value = given("parameters")) read_parameters(binder, *value, entry);
  if (const YamlNode* value = given("arguments")) reader.read_arguments(*value);
  if (const YamlNode* value = given("output")) reader.read_output(*value);
  if (const YamlNode* value = given("respawn")) {
    entry.respawn = binder.boolean(*value, "respawn").value_or(false);
  }
  return complete ? std::optional(std::move(entry)) : std::nullopt;
}

std::optional<ProgramEntry> read_program(Binder& binder, const YamlNode& node) {
  static const std::vector<KeyRow> kKeys{
      {"package", {"pkg"}},
      {"executable", {"exec", "node_executable", "exe"}},
  };
  if (!binder.mapping(node, "an item of `programs`", kKeys)) {
    binder.wrong_type(node, "an item of `programs`",
                      "a mapping with `package` and perhaps `executable`");
    return std::nullopt;
  }
  ProgramEntry entry;
  entry.span = binder.span(node);
  const YamlNode* package = value_of(node, "package");
  const YamlNode* executable = value_of(node, "executable");
  auto name =
      package == nullptr ? std::nullopt : binder.name(*package, "package", package_name_fault);
  if (package == nullptr) binder.missing(node, "a program", "package");
  if (executable != nullptr) {
    entry.executable = binder.name(*executable, "executable", executable_name_fault);
    if (!entry.executable) return std::nullopt;
  }
  if (!name) return std::nullopt;
  entry.package = *std::move(name);
  return entry;
}

void warn_of_equal_names(Binder& binder, const std::vector<NodeEntry>& nodes) {
  std::map<std::string, const NodeEntry*> seen;
  for (const NodeEntry& node : nodes) {
    const std::string name = full_name(node);
    if (name.empty()) continue;
    const auto [first, fresh] = seen.emplace(name, &node);
    if (fresh) continue;
    Diagnostic& doubt = binder.warning("R2W0112", "two nodes are called `" + name + "`", {});
    doubt.span = node.name->span;
    doubt.label = "the first is in line " + std::to_string(first->second->name->span.line);
    doubt.why.push_back("ROS 2 starts both, but tools then cannot tell them apart");
  }
}

}  // namespace ros2wasm
