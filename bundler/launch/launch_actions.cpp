// See launch_evaluator.hpp: the actions that start nothing themselves.
#include <algorithm>
#include <charconv>
#include <utility>

#include "bundler/launch/launch_evaluator.hpp"
#include "bundler/launch/node_arguments.hpp"
#include "workspace_schema/base/source_text.hpp"
#include "workspace_schema/base/suggestion.hpp"
#include "workspace_schema/base/yaml_reader.hpp"
#include "workspace_schema/base/yaml_scalar.hpp"

namespace ros2wasm {
namespace {

constexpr std::int64_t kMostTurns = 10'000;
constexpr const char* kNoReason = "reason not given";  // as launch says

/// As str() of what YAML reads.
std::string python_text(const YamlNode& node) {
  const YamlValue value = scalar_value(node);
  if (const bool* flag = std::get_if<bool>(&value)) return *flag ? "True" : "False";
  if (const auto* whole = std::get_if<std::int64_t>(&value)) return std::to_string(*whole);
  if (const auto* real = std::get_if<double>(&value)) return parameter_text(*real);
  return node.text;
}

}  // namespace

void LaunchEvaluator::declare_argument(const LaunchEntity& entity) {
  const auto name = text(entity, "name");
  if (!name) return;
  LaunchArgument argument{.name = *name,
                          .default_value = {},
                          .description = {},
                          .choices = {},
                          .value = {},
                          .span = entity.span};
  argument.description = text(entity, "description").value_or("");
  for (const LaunchEntity& part : entity.children)
    if (auto choice = needed_text(part, "value")) argument.choices.push_back(std::move(*choice));
  const auto set = scope_.configurations.find(*name);
  // The default is not evaluated when the value is given: it may need what is not there.
  if (const LaunchAttribute* by_default = entity.attribute("default")) {
    const bool needed = set == scope_.configurations.end();
    const std::size_t errors_before = errors_.size();
    argument.default_value = text(entity, by_default->name);
    if (!argument.default_value && !needed) errors_.resize(errors_before);
    if (!argument.default_value && needed) return;
  }
  const auto given = given_.find(*name);
  argument.given = given != given_.end();
  if (set != scope_.configurations.end()) {
    argument.value = set->second;
  } else if (argument.default_value) {
    argument.value = *argument.default_value;
  } else {
    fail("R2W0412", "the launch argument `" + *name + "` must be given", entity.span,
         {"it has no default value",
          argument.description.empty() ? "it has no description" : argument.description});
    return;
  }
  const auto& choices = argument.choices;
  if (!choices.empty() &&
      std::find(choices.begin(), choices.end(), argument.value) == choices.end()) {
    std::vector<std::string> why = {"its values are: " + name_list(choices, choices.size())};
    const auto place = world_.given_at.find(*name);
    const bool is_given =
        place != world_.given_at.end() && given != given_.end() && given->second == argument.value;
    if (is_given)
      why.push_back("it is declared in " + entity.span.file + ":" +
                    std::to_string(entity.span.line));
    fail("R2W0412",
         "`" + argument.value + "` is not a value of the launch argument `" + *name + "`",
         is_given ? place->second : entity.span, std::move(why));
    return;
  }
  scope_.configurations[*name] = argument.value;
  // A value that an include sets is fixed; only values from outside are arguments of the whole
  // launch.
  const bool is_other = given == given_.end() || given->second != argument.value;
  const bool from_include =
      set != scope_.configurations.end() && is_other && open_files_.size() > 1;
  auto& all = description_.arguments;
  const bool known = std::any_of(all.begin(), all.end(),
                                 [&](const LaunchArgument& one) { return one.name == *name; });
  if (!known && !from_include) all.push_back(std::move(argument));
}

void LaunchEvaluator::let(const LaunchEntity& entity) {
  const auto name = text(entity, "name");
  auto value = text(entity, "value");
  if (name && value) scope_.configurations[*name] = std::move(*value);
}

void LaunchEvaluator::include(const LaunchEntity& entity) {
  const auto named = text(entity, "file");
  if (!named) return;
  for (const LaunchEntity& part : entity.children) let(part);  // each sees those before it
  const bool absolute = named->starts_with('/');
  file(absolute ? *named : place_.directory() + "/" + *named, entity.span);
}

void LaunchEvaluator::group(const LaunchEntity& entity) {
  Entities inner;
  std::map<std::string, std::string> kept;
  for (const LaunchEntity& part : entity.children) {
    if (part.tag != "keep") {
      inner.push_back(part);
      continue;
    }
    const auto name = needed_text(part, "name");
    auto value = needed_text(part, "value");
    if (name && value) kept[*name] = std::move(*value);
  }
  const bool scoped = flag(entity, "scoped", true);
  const LaunchScope before = scope_;
  if (scoped && !flag(entity, "forwarding", true)) {
    scope_ = {};
    scope_.loop = before.loop;
  }
  for (auto& [name, value] : kept) scope_.configurations[name] = std::move(value);
  actions(inner);
  if (scoped) scope_ = before;
}

void LaunchEvaluator::set_environment(const LaunchEntity& entity) {
  const auto name = text(entity, "name");
  auto value = text(entity, "value");
  if (name && value) scope_.environment[*name] = std::move(*value);
}

void LaunchEvaluator::unset_environment(const LaunchEntity& entity) {
  if (const auto name = text(entity, "name")) scope_.environment.erase(*name);
}

void LaunchEvaluator::append_environment(const LaunchEntity& entity) {
  const auto name = text(entity, "name");
  const auto value = text(entity, "value");
  if (!name || !value) return;
  const std::string separator = text(entity, "separator").value_or(":");
  std::string& all = scope_.environment[*name];
  if (all.empty()) {
    const auto outer = world_.environment.find(*name);
    if (outer != world_.environment.end()) all = outer->second;
  }
  if (all.empty()) {
    all = *value;
  } else {
    all = flag(entity, "prepend", false) ? *value + separator + all : all + separator + *value;
  }
}

void LaunchEvaluator::reset_environment(const LaunchEntity&) {
  scope_.environment = world_.variables;
}

void LaunchEvaluator::reset(const LaunchEntity& entity) {
  std::map<std::string, std::string> kept;
  for (const LaunchEntity& part : entity.children) {
    const auto name = needed_text(part, "name");
    auto value = needed_text(part, "value");
    if (name && value) kept[*name] = std::move(*value);
  }
  scope_.configurations = std::move(kept);
}

void LaunchEvaluator::timer(const LaunchEntity& entity) {
  const double period = seconds(entity, "period", 0);
  const double before = std::exchange(after_s_, after_s_ + period);
  actions(entity.children);
  after_s_ = before;
}

void LaunchEvaluator::log(const LaunchEntity& entity) {
  auto message = text(entity, "message");
  if (!message) return;
  std::string level = entity.tag == "log" ? text(entity, "level").value_or("info")
                                          : entity.tag.substr(std::string_view("log_").size());
  for (char& c : level) c = static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
  description_.lines.push_back({.level = std::move(level),
                                .text = std::move(*message),
                                .on = trigger_,
                                .after_s = after_s_,
                                .span = entity.span});
}

void LaunchEvaluator::shutdown(const LaunchEntity& entity) {
  std::string reason = text(entity, "reason").value_or(kNoReason);
  if (trigger_ && trigger_->event == LaunchEvent::kShutdown) return;  // it is under way
  if (trigger_ && trigger_->event == LaunchEvent::kExit && after_s_ == 0 && reason == kNoReason) {
    description_.processes[trigger_->process].shutdown_on_exit = true;
    return;
  }
  description_.shutdowns.push_back(
      {.on = trigger_, .after_s = after_s_, .reason = std::move(reason), .span = entity.span});
}

void LaunchEvaluator::push_namespace(const LaunchEntity& entity) {
  const auto pushed = text(entity, "namespace");
  if (!pushed) return;
  if (const auto whole = namespace_for(*pushed)) scope_.ros_namespace = *whole;
}

void LaunchEvaluator::set_parameter(const LaunchEntity& entity) {
  const auto name = text(entity, "name");
  auto set = value(*entity.attribute("value"), text(entity, "type").value_or(""), "");
  if (!name || !set) return;
  scope_.parameters.push_back({.name = *name, .value = std::move(*set), .file = {}});
}

void LaunchEvaluator::set_parameter_file(const LaunchEntity& entity) {
  const LaunchAttribute& from = *entity.attribute("filename");
  if (auto key = parameter_file(entity, from, false))
    scope_.parameters.push_back(
        {.name = {}, .value = {}, .file = Spanned<std::string>{*key, from.span}});
}

void LaunchEvaluator::set_remap(const LaunchEntity& entity) {
  const auto from = text(entity, "from");
  const auto to = text(entity, "to");
  if (from && to) scope_.remappings.emplace_back(*from, *to);
}

void LaunchEvaluator::set_sim_time(const LaunchEntity& entity) {
  scope_.parameters.push_back(
      {.name = "use_sim_time", .value = flag(entity, "value", false), .file = {}});
}

void LaunchEvaluator::ignore(const LaunchEntity&) {}

/// `values`: mappings in YAML with `;` between them; the children see theirs by `$(for-var name)`.
void LaunchEvaluator::for_each(const LaunchEntity& entity) {
  const auto values = text(entity, "values");
  if (!values) return;
  const std::map<std::string, std::string> before = scope_.loop;
  std::size_t begin = 0;
  while (begin < values->size()) {
    const std::size_t end = std::min(values->find(';', begin), values->size());
    const std::string one = values->substr(begin, end - begin);
    begin = end + 1;
    const SourceText source(one, entity.span.file);
    const auto read = parse_yaml(source);
    if (!read || read->root.kind != YamlKind::kMap) {
      fail("R2W0410", "`" + one + "` is not a mapping of values", entity.span,
           {"as in `{name: 'a', x: 1}; {name: 'b', x: 2}`"});
      break;
    }
    for (const YamlEntry& entry : read->root.entries)
      scope_.loop[entry.key] = python_text(entry.value);
    actions(entity.children);
    scope_.loop = before;
  }
}

/// The children see how often they came before by `$(index name)`.
void LaunchEvaluator::count(const LaunchEntity& entity) {
  const auto length = text(entity, "len");
  const auto name = text(entity, "name");
  if (!length || !name) return;
  std::int64_t turns = 0;
  const auto [end, error] = std::from_chars(length->data(), length->data() + length->size(), turns);
  if (error != std::errc() || end != length->data() + length->size() || turns < 0 ||
      turns > kMostTurns) {
    fail("R2W0410",
         "`len` is a count up to " + std::to_string(kMostTurns) + ", found `" + *length + "`",
         entity.attribute("len")->span);
    return;
  }
  const std::map<std::string, std::string> before = scope_.loop;
  for (std::int64_t i = 0; i < turns && errors_.empty(); ++i) {
    scope_.loop[*name] = std::to_string(i);
    actions(entity.children);
    scope_.loop = before;
  }
}

std::optional<std::string> LaunchEvaluator::namespace_for(const std::string& own) const {
  std::string result = own;
  if (!own.starts_with('/')) {
    result = scope_.ros_namespace;
    if (!own.empty()) result += (result.ends_with('/') ? "" : "/") + own;
  }
  while (result.size() > 1 && result.ends_with('/')) result.pop_back();
  if (result.empty()) return std::nullopt;
  return result.starts_with('/') ? result : "/" + result;
}

}  // namespace ros2wasm
