// See manifest_checks.hpp. Which keys stand tells what is looked at: a topic's rate, a field of its
// messages, lines of a node, a parameter, a state, an exit code.
#include "workspace_schema/schema/manifest_checks.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "workspace_schema/base/duration.hpp"
#include "workspace_schema/base/yaml_scalar.hpp"
#include "workspace_schema/schema/check_pattern.hpp"

namespace ros2wasm {
namespace {

const std::vector<KeyRow>& check_keys() {
  static const std::vector<KeyRow> kKeys{
      {"title", {"name", "description"}},
      {"topic", {}},
      {"field", {"path", "message"}},
      {"node", {}},
      {"log", {"line", "output", "prints"}},
      {"parameter", {"param"}},
      {"state", {}},
      {"exit_code", {"exit", "code", "exitcode"}},
      {"above", {"min", "more_than", "greater_than"}},
      {"below", {"max", "less_than"}},
      {"equals", {"equal", "is", "value"}},
      {"matches", {"match", "regex", "pattern"}},
      {"within", {"timeout", "limit", "duration"}},
  };
  return kKeys;
}

/// `x`, `pose.position.x`, `ranges[3]`.
std::optional<NameFault> field_fault(std::string_view text) {
  constexpr std::string_view kRule =
      "a field is names with `.` between them; an index in brackets picks from a list: "
      "`pose.position.x`, `ranges[3]`";
  const auto fault = [&](std::string why, std::size_t at, std::size_t length) {
    return NameFault{
        .why = std::move(why), .offset = at, .length = length, .rule = std::string(kRule)};
  };
  if (text.empty()) return fault("it is empty", 0, 0);
  const auto is_letter = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
  };
  const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
  std::size_t at = 0;
  for (;;) {
    if (at == text.size()) return fault("a name is missing at its end", at - 1, 1);
    if (!is_letter(text[at])) return fault("a name does not begin here", at, 1);
    while (at < text.size() && (is_letter(text[at]) || is_digit(text[at]))) ++at;
    while (at < text.size() && text[at] == '[') {
      const std::size_t open = at++;
      while (at < text.size() && is_digit(text[at])) ++at;
      const std::size_t digits = at - open - 1;
      if (digits == 0 || digits > 9 || at == text.size() || text[at] != ']')
        return fault("an index is a number in brackets", open, at - open);
      ++at;
    }
    if (at == text.size()) return std::nullopt;
    if (text[at] != '.') return fault("this is not allowed", at, 1);
    ++at;
  }
}

std::optional<double> plain_number(const YamlNode& node) {
  const YamlValue value = scalar_value(node);
  if (const auto* integer = std::get_if<std::int64_t>(&value)) return static_cast<double>(*integer);
  if (const auto* number = std::get_if<double>(&value); number != nullptr && std::isfinite(*number))
    return *number;
  return std::nullopt;
}

class CheckReader {
 public:
  CheckReader(Binder& binder, const YamlNode& node, CheckPlace place)
      : binder_(binder), node_(node), place_(place) {}

  std::optional<CheckEntry> read() {
    CheckEntry entry;
    entry.span = binder_.span(node_);
    if (const YamlNode* value = given("title")) {
      if (const auto text = text_line(*value, "title")) entry.title = text->value;
    }
    if (place_ == CheckPlace::kTask) {
      refuse_within();
    } else if (const YamlNode* value = given("within")) {
      read_within(*value, entry.within_ms);
    }
    if (given("topic") != nullptr) {
      read_topic(entry);
    } else if (given("log") != nullptr) {
      read_log(entry);
    } else if (given("parameter") != nullptr) {
      read_parameter(entry);
    } else if (given("state") != nullptr) {
      read_state(entry);
    } else if (given("exit_code") != nullptr) {
      read_exit_code(entry);
    } else {
      Diagnostic& wrong =
          binder_.error("R2W0117", "this check says nothing of what must be seen", node_.range);
      wrong.why.emplace_back(
          "a check has one of the keys `topic`, `log`, `parameter`, `state` and `exit_code`");
      good_ = false;
    }
    if (!good_) return std::nullopt;
    return entry;
  }

 private:
  [[nodiscard]] const YamlNode* given(std::string_view key) const { return value_of(node_, key); }

  template <typename T>
  std::optional<T> kept(std::optional<T> found) {
    good_ = good_ && found.has_value();
    return found;
  }

  std::optional<Spanned<std::string>> text_line(const YamlNode& value, const std::string& what) {
    return kept(binder_.line(value, what));
  }

  /// Every key that stands must be one of these.
  void only(std::string_view kind, std::initializer_list<std::string_view> keys) {
    for (const YamlEntry& entry : node_.entries) {
      const bool known = std::any_of(check_keys().begin(), check_keys().end(),
                                     [&](const KeyRow& row) { return row.name == entry.key; });
      const bool always = entry.key == "title" || entry.key == "within";
      if (!known || always || std::find(keys.begin(), keys.end(), entry.key) != keys.end())
        continue;
      std::vector<std::string> names;
      for (const std::string_view key : keys) names.emplace_back(key);
      std::string all;
      for (const std::string& name : names) all += (all.empty() ? "`" : ", `") + name + "`";
      Diagnostic& wrong = binder_.error(
          "R2W0117", "`" + entry.key + "` does not belong to a check of " + std::string(kind),
          entry.key_range, "not with `" + names.front() + "`");
      wrong.why.push_back(
          "such a check has the keys " + all +
          (place_ == CheckPlace::kTask ? " and `title`" : ", `title` and `within`"));
      good_ = false;
    }
  }

  void refuse_within() {
    for (const YamlEntry& entry : node_.entries) {
      if (entry.key != "within") continue;
      Diagnostic& wrong = binder_.error("R2W0117", "`within` does not belong to a check of a task",
                                        entry.key_range);
      wrong.why.emplace_back("a student takes the time that the task needs: nothing fails there");
      good_ = false;
    }
  }

  void read_within(const YamlNode& node, std::int64_t& target) {
    const auto text = kept(binder_.written(node, "within"));
    if (!text) return;
    std::string compact = text->value;
    const std::size_t space = compact.find(' ');
    if (space != std::string::npos) compact.erase(space, 1);
    const auto duration = parse_duration(compact);
    if (duration) {
      target = duration->count();
      return;
    }
    const Diagnostic& fault = duration.errors().front();
    Diagnostic& wrong =
        binder_.error("R2W0103", "`within` cannot be `" + text->value + "`", node.range);
    wrong.why = fault.why;
    for (const std::string& fix : fault.fix)
      wrong.fix.push_back("write `within: " + fix.substr(fix.find('`') + 1));
    good_ = false;
  }

  std::string read_topic_name() {
    const auto name = kept(binder_.name(*given("topic"), "topic", topic_name_fault));
    if (!name) return {};
    if (name->value.find_first_of("~{") != std::string::npos) {
      binder_
          .error("R2W0104", "`" + name->value + "` is a topic of a node that is not named here",
                 given("topic")->range)
          .why.emplace_back("the topic of a check is named in full, such as `/robot1/odom`");
      good_ = false;
      return {};
    }
    return absolute_name(name->value);
  }

  void read_topic(CheckEntry& entry) {
    const std::string topic = read_topic_name();
    if (given("field") == nullptr) {
      only("a topic's rate", {"topic", "above", "below"});
      RateCheck rate{
          .topic = topic, .above_hz = read_rate("above"), .below_hz = read_rate("below")};
      refuse_empty_range(rate.above_hz, rate.below_hz);
      entry.what = std::move(rate);
      return;
    }
    only("a field of messages", {"topic", "field", "above", "below", "equals", "matches"});
    MessageCheck message{.topic = topic, .field = {}, .value = {}};
    if (const auto field = kept(binder_.name(*given("field"), "field", field_fault)))
      message.field = field->value;
    message.value = read_comparison("field");
    entry.what = std::move(message);
  }

  /// `10 Hz`.
  std::optional<double> read_rate(const std::string& key) {
    const YamlNode* node = given(key);
    if (node == nullptr) return std::nullopt;
    const auto text = kept(binder_.written(*node, key));
    if (!text) return std::nullopt;
    std::string_view number = text->value;
    const bool has_unit = number.ends_with("Hz");
    if (has_unit) number.remove_suffix(2);
    while (number.ends_with(' ')) number.remove_suffix(1);
    const YamlNode digits{.kind = YamlKind::kScalar, .text = std::string(number)};
    const auto value = plain_number(digits);
    if (has_unit && value && *value >= 0) return value;
    Diagnostic& wrong =
        binder_.error("R2W0103", "`" + key + "` of a topic is a rate in Hz", node->range,
                      has_unit ? "expected a number before `Hz`" : "the unit is missing");
    if (!has_unit && value && *value >= 0)
      wrong.fix.push_back("write `" + key + ": " + text->value + " Hz`");
    if (!has_unit) wrong.why.emplace_back("values of messages are compared with `field` beside it");
    good_ = false;
    return std::nullopt;
  }

  void refuse_empty_range(const std::optional<double>& above, const std::optional<double>& below) {
    if (!above || !below || *above < *below) return;
    binder_.error("R2W0117", "nothing is above and below these at once", given("above")->range);
    good_ = false;
  }

  Comparison read_comparison(const std::string& of) {
    Comparison value;
    for (const auto& [key, target] :
         {std::pair("above", &value.above), std::pair("below", &value.below)}) {
      const YamlNode* node = given(key);
      if (node == nullptr) continue;
      *target = plain_number(*node);
      if (*target) continue;
      binder_.wrong_type(*node, key, "a number");
      good_ = false;
    }
    refuse_empty_range(value.above, value.below);
    if (const YamlNode* node = given("equals")) read_equals(*node, value);
    if (const YamlNode* node = given("matches")) value.matches = read_pattern(*node, "matches");
    const bool any = given("above") != nullptr || given("below") != nullptr ||
                     given("equals") != nullptr || given("matches") != nullptr;
    if (!any) {
      Diagnostic& wrong = binder_.error("R2W0117", "this check does not say what the value must be",
                                        given(of)->range);
      wrong.why.emplace_back(
          "it needs `equals`, `matches`, `above` or `below`, or several of them");
      good_ = false;
    }
    return value;
  }

  void read_equals(const YamlNode& node, Comparison& value) {
    const YamlValue found = scalar_value(node);
    if (const auto* flag = std::get_if<bool>(&found)) {
      value.equals = *flag;
    } else if (const auto* integer = std::get_if<std::int64_t>(&found)) {
      value.equals = *integer;
    } else if (const auto* number = std::get_if<double>(&found);
               number != nullptr && std::isfinite(*number)) {
      value.equals = *number;
    } else if (const auto* text = std::get_if<std::string>(&found)) {
      value.equals = *text;
    } else {
      binder_.wrong_type(node, "equals", "a number, a text, `true` or `false`");
      good_ = false;
    }
  }

  std::string read_pattern(const YamlNode& node, const std::string& key) {
    const auto text = text_line(node, key);
    if (!text) return {};
    const auto fault = check_pattern_fault(text->value);
    if (!fault) return text->value;
    Diagnostic& wrong = binder_.error(
        "R2W0116", "`" + text->value + "` cannot be used as a regular expression", node.range);
    if (node.verbatim && fault->offset < node.text.size())
      wrong.span = binder_.span({.offset = node.text_offset + fault->offset,
                                 .length = std::max<std::size_t>(1, fault->length)});
    wrong.label = fault->why;
    good_ = false;
    return {};
  }

  /// A node as the site names it: its id, its executable, or its full ROS name.
  std::optional<Spanned<std::string>> read_node() {
    const YamlNode* node = given("node");
    if (node == nullptr) return std::nullopt;
    return text_line(*node, "node");
  }

  std::optional<Spanned<std::string>> required_node(std::string_view kind) {
    if (given("node") == nullptr) {
      binder_.missing(node_, "a check of " + std::string(kind), "node");
      good_ = false;
    }
    return read_node();
  }

  void read_log(CheckEntry& entry) {
    only("lines", {"log", "node"});
    LogCheck log{.node = read_node(), .pattern = read_pattern(*given("log"), "log")};
    entry.what = std::move(log);
  }

  void read_parameter(CheckEntry& entry) {
    only("a parameter", {"parameter", "node", "above", "below", "equals", "matches"});
    ParameterCheck parameter;
    if (given("node") == nullptr) {
      required_node("a parameter");
    } else if (const auto name = kept(binder_.name(*given("node"), "node", namespace_fault))) {
      parameter.node = absolute_name(name->value);
    }
    if (const auto name =
            kept(binder_.name(*given("parameter"), "parameter", parameter_name_fault)))
      parameter.name = name->value;
    parameter.value = read_comparison("parameter");
    entry.what = std::move(parameter);
  }

  void read_state(CheckEntry& entry) {
    static const std::array<std::string, 3> kWords{"running", "exited", "crashed"};
    only("a node's state", {"state", "node"});
    const auto node = required_node("a node's state");
    const auto word = kept(binder_.word(*given("state"), "state", kWords));
    if (!node || !word) return;
    entry.what = StateCheck{.node = *node,
                            .state = word->value == "running"  ? CheckedState::kRunning
                                     : word->value == "exited" ? CheckedState::kExited
                                                               : CheckedState::kCrashed};
  }

  void read_exit_code(CheckEntry& entry) {
    only("an exit code", {"exit_code", "node"});
    const auto node = required_node("an exit code");
    const YamlValue value = scalar_value(*given("exit_code"));
    const auto* code = std::get_if<std::int64_t>(&value);
    if (code == nullptr || *code < 0 || *code > 255) {
      binder_.wrong_type(*given("exit_code"), "exit_code", "a whole number from 0 to 255");
      good_ = false;
      return;
    }
    if (node) entry.what = ExitCheck{.node = *node, .code = *code};
  }

  Binder& binder_;
  const YamlNode& node_;
  CheckPlace place_;
  bool good_ = true;
};

}  // namespace

std::optional<CheckEntry> read_check(Binder& binder, const YamlNode& node, CheckPlace place) {
  if (!binder.mapping(node, "a check", check_keys())) {
    binder.wrong_type(node, "an item of `checks`", "a check")
        .why.emplace_back("a check is a mapping, such as `{topic: /odom, above: 10 Hz}`");
    return std::nullopt;
  }
  return CheckReader(binder, node, place).read();
}

}  // namespace ros2wasm
