// See manifest_parameters.hpp.
#include "workspace_schema/schema/manifest_parameters.hpp"

#include <algorithm>

#include "workspace_schema/base/yaml_scalar.hpp"

namespace ros2wasm {
namespace {

class ParameterReader {
 public:
  ParameterReader(Binder& binder, NodeEntry& entry) : binder_(binder), entry_(entry) {}

  void read(const YamlNode& node) {
    if (node.kind == YamlKind::kMap) {
      read_map(node, "");
    } else if (node.kind == YamlKind::kSequence) {
      for (const YamlNode& item : node.items) read_item(item);
    } else {
      Diagnostic& wrong =
          binder_.wrong_type(node, "parameters", "a mapping, or a list of mappings and files");
      if (std::holds_alternative<std::string>(scalar_value(node))) {
        wrong.fix.push_back("write `parameters: [" + as_yaml_text(node.text) + "]`");
      }
    }
  }

 private:
  void read_item(const YamlNode& item) {
    if (item.kind == YamlKind::kMap) {
      read_map(item, "");
    } else if (auto file = binder_.path(item, "an item of `parameters`")) {
      entry_.parameter_files.push_back(*std::move(file));
    }
  }

  void read_map(const YamlNode& map, const std::string& prefix) {
    for (const YamlEntry& entry : map.entries) {
      if (entry.key == "ros__parameters" || entry.key.starts_with("/")) {
        whole_file(entry);
        continue;
      }
      const std::string name = prefix.empty() ? entry.key : prefix + "." + entry.key;
      if (const auto fault = parameter_name_fault(entry.key)) {
        Diagnostic& wrong =
            binder_.error("R2W0104", "a parameter cannot be called `" + entry.key + "`",
                          entry.key_range, fault->why);
        wrong.why.push_back(fault->rule);
        continue;
      }
      if (entry.value.kind == YamlKind::kMap) {
        if (entry.value.entries.empty()) empty_map(entry);
        read_map(entry.value, name);
      } else if (auto value = read_value(entry.value, name)) {
        add(name, *std::move(value), entry.key_range);
      }
    }
  }

  /// The contents of a parameter file, pasted where its inner mapping belongs.
  void whole_file(const YamlEntry& entry) {
    Diagnostic& wrong =
        binder_.error("R2W0109", "`" + entry.key + "` belongs in a parameter file, not here",
                      entry.key_range, "only the parameters themselves stand here");
    wrong.why.push_back(
        "in the manifest the node is known already: write the keys that stand under "
        "`ros__parameters` in the file, or "
        "name the file in a list");
  }

  void empty_map(const YamlEntry& entry) {
    binder_.error("R2W0109", "the parameter `" + entry.key + "` has no value", entry.value.range,
                  "an empty mapping is not a parameter");
  }

  void add(const std::string& name, ParameterValue value, TextRange at) {
    const auto& all = entry_.parameters;
    const auto same = [&](const ParameterEntry& other) {
      return other.name == name && other.files_before == entry_.parameter_files.size();
    };
    if (std::any_of(all.begin(), all.end(), same)) {
      binder_
          .error("R2W0105", "the parameter `" + name + "` is set twice", at, "set before already")
          .why.push_back("nested mappings and dotted names mean the same: `a: {b: 1}` is `a.b: 1`");
      return;
    }
    entry_.parameters.push_back(
        {.name = name, .value = std::move(value), .files_before = entry_.parameter_files.size()});
  }

  std::optional<ParameterValue> read_value(const YamlNode& node, const std::string& name) {
    if (node.kind == YamlKind::kSequence) return read_list(node, name);
    const YamlValue value = read_scalar(node, name);
    if (const auto* found = std::get_if<bool>(&value)) return *found;
    if (const auto* found = std::get_if<std::int64_t>(&value)) return *found;
    if (const auto* found = std::get_if<double>(&value)) return *found;
    if (const auto* found = std::get_if<std::string>(&value)) return *found;
    return std::nullopt;
  }

  /// A bool, integer, double or string; anything else is reported and comes back as monostate.
  YamlValue read_scalar(const YamlNode& node, const std::string& name) {
    YamlValue value = scalar_value(node);
    if (node.kind == YamlKind::kNull || std::holds_alternative<std::monostate>(value)) {
      Diagnostic& wrong = binder_.error("R2W0109", "the parameter `" + name + "` has no value",
                                        node.range, "expected a value");
      wrong.why.push_back(
          "a ROS 2 parameter is a boolean, an integer, a double, a string, or a list of one of "
          "them");
      return std::monostate{};
    }
    if (std::holds_alternative<YamlIntegerTooLarge>(value)) {
      Diagnostic& wrong = binder_.error(
          "R2W0109", "the parameter `" + name + "` does not fit into 64 bits", node.range);
      wrong.fix.push_back("write `" + node.text + ".0` for a double, or `\"" + node.text +
                          "\"` for a string");
      return std::monostate{};
    }
    if (std::holds_alternative<YamlUnknownTag>(value)) {
      binder_.wrong_type(node, name, "a parameter value");
      return std::monostate{};
    }
    if (is_old_boolean(node)) {
      Diagnostic& doubt = binder_.warning(
          "R2W0113", "the parameter `" + name + "` is the string \"" + node.text + "\"", node.range,
          "not a boolean here");
      doubt.why.push_back("YAML 1.2 knows `true` and `false` only; older YAML reads `" + node.text +
                          "` as a boolean");
      doubt.fix.push_back("write `true` or `false`, or `\"" + node.text + "\"` to keep the string");
    }
    return value;
  }

  std::optional<ParameterValue> read_list(const YamlNode& list, const std::string& name) {
    if (list.items.empty()) {
      binder_
          .error("R2W0109", "the list of the parameter `" + name + "` is empty", list.range,
                 "no values")
          .why.push_back(
              "the type of a list is that of its values, so a list without values has none; leave "
              "the "
              "parameter out to keep the node's own default");
      return std::nullopt;
    }
    std::vector<YamlValue> values;
    for (const YamlNode& item : list.items) {
      if (item.kind == YamlKind::kSequence || item.kind == YamlKind::kMap) {
        binder_
            .error("R2W0109",
                   "the list of the parameter `" + name + "` holds " + std::string(described(item)),
                   item.range, "only single values are allowed")
            .why.push_back("ROS 2 has no parameters that are lists of lists or lists of mappings");
        return std::nullopt;
      }
      values.push_back(read_scalar(item, name));
      if (std::holds_alternative<std::monostate>(values.back())) return std::nullopt;
    }
    return typed_list(list, name, values);
  }

  static bool is_number(const YamlValue& value) {
    return std::holds_alternative<std::int64_t>(value) || std::holds_alternative<double>(value);
  }

  template <typename T>
  static std::vector<T> all_of(const std::vector<YamlValue>& values) {
    std::vector<T> out;
    for (const YamlValue& value : values) out.push_back(std::get<T>(value));
    return out;
  }

  std::optional<ParameterValue> typed_list(const YamlNode& list, const std::string& name,
                                           const std::vector<YamlValue>& values) {
    for (std::size_t i = 1; i < values.size(); ++i) {
      const bool same =
          values[i].index() == values[0].index() || (is_number(values[i]) && is_number(values[0]));
      if (same) continue;
      binder_
          .error("R2W0109", "the list of the parameter `" + name + "` mixes types",
                 list.items[i].range,
                 "this is " + std::string(described(list.items[i])) + ", the first is " +
                     std::string(described(list.items[0])))
          .why.push_back("all values of a ROS 2 parameter list have one type");
      return std::nullopt;
    }
    if (std::holds_alternative<bool>(values[0])) return all_of<bool>(values);
    if (std::holds_alternative<std::string>(values[0])) return all_of<std::string>(values);
    const bool whole = std::all_of(values.begin(), values.end(), [](const YamlValue& v) {
      return std::holds_alternative<std::int64_t>(v);
    });
    if (whole) return all_of<std::int64_t>(values);
    std::vector<double> numbers;  // integers among doubles are doubles, as in launch files
    for (const YamlValue& value : values) {
      const auto* integer = std::get_if<std::int64_t>(&value);
      numbers.push_back(integer != nullptr ? static_cast<double>(*integer)
                                           : std::get<double>(value));
    }
    return numbers;
  }

  Binder& binder_;
  NodeEntry& entry_;
};

}  // namespace

void read_parameters(Binder& binder, const YamlNode& node, NodeEntry& entry) {
  ParameterReader(binder, entry).read(node);
}

}  // namespace ros2wasm
