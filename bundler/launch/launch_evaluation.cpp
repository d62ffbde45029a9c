// See launch_evaluation.hpp: the files, the table of actions, and how attributes are read.
#include "bundler/launch/launch_evaluation.hpp"

#include <algorithm>
#include <charconv>
#include <span>
#include <utility>

#include "bundler/launch/launch_evaluator.hpp"
#include "bundler/launch/launch_frontends.hpp"
#include "bundler/launch/launch_values.hpp"
#include "workspace_schema/base/suggestion.hpp"

namespace ros2wasm {

struct LaunchActionRow {
  std::string_view tag;
  std::vector<std::string_view> attributes;  ///< those that must be there begin with `!`
  std::vector<std::string_view> parts;       ///< `*`: actions
  void (LaunchEvaluator::*run)(const LaunchEntity& entity);
  bool of_python = false;  ///< what only launch files in Python can say

  static std::span<const LaunchActionRow> table();
};

namespace {

constexpr std::size_t kMostActions = 200'000;
constexpr std::size_t kMostText = 256U << 20U;  // bytes, all together
constexpr std::size_t kMostFiles = 1000;
constexpr int kDeepest = 64;
constexpr std::size_t kMostProcesses = 10'000;

using Names = std::vector<std::string_view>;

Names with(Names names, const Names& more) {
  names.insert(names.end(), more.begin(), more.end());
  return names;
}

std::string plain_tag(std::string_view tag) {
  std::string result(tag);
  std::replace(result.begin(), result.end(), '-', '_');
  return result;
}

/// A part of an action, which is not an action itself.
struct PartRow {
  std::string_view tag;
  Names attributes;
};

const std::vector<PartRow>& part_rows() {
  static const std::vector<PartRow> rows{
      {"arg", {"!name", "!value"}},
      {"choice", {"!value"}},
      {"composable_node", {"!pkg", "!plugin", "name", "namespace", "if", "unless"}},
      {"env", {"!name", "!value"}},
      {"extra_arg", {"!name", "!value", "type"}},
      {"keep", {"!name", "!value"}},
      {"let", {"!name", "!value"}},
      {"param", {"name", "value", "type", "value_sep", "from", "allow_substs"}},
      {"remap", {"!from", "!to"}},
  };
  return rows;
}

/// Tags and attributes are written with `-` and with `_`.
void make_plain(LaunchEntity& entity) {
  entity.tag = plain_tag(entity.tag);
  for (LaunchAttribute& one : entity.attributes) one.name = plain_tag(one.name);
  for (LaunchEntity& child : entity.children) make_plain(child);
}

}  // namespace

std::span<const LaunchActionRow> LaunchActionRow::table() {
  using E = LaunchEvaluator;
  static const Names process{"cwd",
                             "name",
                             "on_exit",
                             "launch_prefix",
                             "output",
                             "respawn",
                             "respawn_max_retries",
                             "respawn_delay",
                             "sigkill_timeout",
                             "sigterm_timeout",
                             "shell",
                             "emulate_tty"};
  static const Names node =
      with(process, {"!exec", "pkg", "node_name", "exec_name", "namespace", "args", "ros_args"});
  static const std::vector<LaunchActionRow> rows{
      {"append_env", {"!name", "!value", "prepend", "separator"}, {}, &E::append_environment},
      {"arg", {"!name", "default", "description"}, {"choice"}, &E::declare_argument},
      {"executable", with(process, {"!cmd"}), {"env"}, &E::executable},
      {"for", {"!len", "!name"}, {"*"}, &E::count},
      {"for_each", {"!values"}, {"*"}, &E::for_each},
      {"group", {"scoped", "forwarding"}, {"keep", "*"}, &E::group},
      {"include", {"!file"}, {"arg", "let"}, &E::include},
      {"let", {"!name", "!value"}, {}, &E::let},
      {"lifecycle_node", with(node, {"autostart"}), {"param", "remap", "env"}, &E::lifecycle_node},
      {"lifecycle_transition",
       {"lifecycle_node_names", "lifecycle_node_names_sep", "transition_ids", "transition_ids_sep"},
       {},
       &E::change_state},
      {"load_composable_node", {"target"}, {"composable_node"}, &E::load_components},
      {"log", {"!message", "level"}, {}, &E::log},
      {"log_debug", {"!message"}, {}, &E::log},
      {"log_error", {"!message"}, {}, &E::log},
      {"log_info", {"!message"}, {}, &E::log},
      {"log_warning", {"!message"}, {}, &E::log},
      {"node", node, {"param", "remap", "env"}, &E::node},
      {"node_container", node, {"param", "remap", "env", "composable_node"}, &E::container},
      {"push_ros_namespace", {"!namespace"}, {}, &E::push_namespace},
      {"reset", {}, {"keep"}, &E::reset},
      {"reset_env", {}, {}, &E::reset_environment},
      {"ros_timer", {"!period", "cancel_on_shutdown"}, {"*"}, &E::timer},
      {"set_env", {"!name", "!value"}, {}, &E::set_environment},
      {"set_parameter", {"!name", "!value"}, {}, &E::set_parameter},
      {"set_parameters_from_file", {"!filename"}, {}, &E::set_parameter_file},
      {"set_remap", {"!from", "!to"}, {}, &E::set_remap},
      {"set_ros_log_dir", {"!new_log_dir"}, {}, &E::ignore},
      {"set_use_sim_time", {"!value"}, {}, &E::set_sim_time},
      {"shutdown", {"reason"}, {}, &E::shutdown},
      {"timer", {"!period", "cancel_on_shutdown"}, {"*"}, &E::timer},
      {"unset_env", {"!name"}, {}, &E::unset_environment},
      {"end_process", {}, {}, &E::end_process, true},
      {"forget_event", {"!handler"}, {}, &E::forget_event, true},
      {"left_out", {"!what", "why"}, {}, &E::pass_over, true},
      {"on_event",
       {"!event", "!handler", "process", "call", "transition", "start_state", "goal_state", "once",
        "any"},
       {"*"},
       &E::on_event,
       true},
      {"pop_configurations", {}, {}, &E::pop_variables, true},
      {"pop_environment", {}, {}, &E::pop_environment, true},
      {"push_configurations", {}, {}, &E::push_variables, true},
      {"push_environment", {}, {}, &E::push_environment, true},
      {"python", {"!call"}, {}, &E::python, true},
      {"unlet", {"!name"}, {}, &E::unset_variable, true},
      {"when_printed", {"!stream", "!tests"}, {"*"}, &E::when_printed, true},
  };
  return rows;
}

LaunchEvaluator::LaunchEvaluator(const LaunchWorld& world,
                                 const std::map<std::string, std::string>& given)
    : world_(world), given_(given) {
  scope_.configurations = given;
  scope_.environment = world.variables;
  world_.note_later = [this](const std::string& path, const SourceSpan& at) {
    static_cast<void>(comes_later(path, at));
  };
  if (!world.python) return;
  // A file that Python wrote is read there.
  world_.read = [this, &world](const std::string& path) -> Outcome<std::string> {
    auto text = world.read(path);
    if (text || !path.starts_with("/tmp/")) return text;
    return read_python_file(path, world_);
  };
}

void LaunchEvaluator::file(const std::string& path, const std::optional<SourceSpan>& from) {
  const std::string shown = world_.shown_path(path);
  const auto refuse = [&](DiagnosticCode code, std::string message, std::vector<std::string> why) {
    Diagnostic error{
        .code = code, .message = std::move(message), .span = from, .why = std::move(why)};
    errors_.push_back(std::move(error));
  };
  if (std::find(open_files_.begin(), open_files_.end(), path) != open_files_.end()) {
    refuse("R2W0413", "`" + shown + "` includes itself", {"by way of " + name_list(open_files_)});
    return;
  }
  if (open_files_.size() >= kDeepest || files_.size() >= kMostFiles) {
    refuse("R2W0413", "too many launch files include each other", {});
    return;
  }
  const bool is_python = launch_language(path, "") == LaunchLanguage::kPython;
  const auto text = world_.read(path);
  if (!text && comes_later(path, from)) return;
  if (!text) {
    refuse("R2W0413", "the launch file `" + shown + "` cannot be read", text.errors().front().why);
    return;
  }
  files_.insert(path);
  if (is_python) {
    python_file(path, from.value_or(SourceSpan{.file = shown, .line_text = {}}));
    return;
  }
  const LaunchLanguage language = launch_language(path, *text);
  auto root = language == LaunchLanguage::kXml ? read_xml_launch(*text, shown)
                                               : read_yaml_launch(*text, shown);
  if (!root) {
    errors_.insert(errors_.end(), root.errors().begin(), root.errors().end());
    return;
  }
  make_plain(*root);
  for (const LaunchAttribute& one : root->attributes) {
    if (one.name != "deprecated" && one.name != "version")
      fail("R2W0410", "`launch` has no attribute `" + one.name + "`", one.span);
  }
  entities_of(std::move(*root), path, language);
}

/// Warns of a file that only a built workspace has.
bool LaunchEvaluator::comes_later(const std::string& path, const std::optional<SourceSpan>& from) {
  if (!world_.is_later || !world_.is_later(path)) return false;
  description_.warnings.push_back(
      {.code = "R2W0419",
       .severity = Severity::kWarning,
       .message = "`" + world_.shown_path(path) + "` is not seen before the workspace is built",
       .span = from,
       .why = {"the sources have no such file in that place; what it "
               "says is skipped here"}});
  return true;
}

void LaunchEvaluator::entities_of(LaunchEntity root, const std::string& path,
                                  LaunchLanguage language) {
  const LaunchFilePlace before = std::exchange(place_, {.path = path});
  const LaunchLanguage language_before = std::exchange(language_, language);
  open_files_.push_back(path);
  actions(root.children);
  open_files_.pop_back();
  language_ = language_before;
  place_ = before;
}

void LaunchEvaluator::finish() {
  resolve_components();
  resolve_transitions();
  resolve_ends();
  for (const auto& [name, value] : given_) {
    std::vector<std::string> declared;
    for (const LaunchArgument& one : description_.arguments) declared.push_back(one.name);
    if (std::find(declared.begin(), declared.end(), name) != declared.end()) continue;
    Diagnostic warning{
        .code = "R2W0412",
        .severity = Severity::kWarning,
        .message = "no launch file declares the argument `" + name + "`",
        .why = {declared.empty() ? "none is declared" : "declared are: " + name_list(declared)}};
    if (const auto similar = nearest(name, declared))
      warning.fix.push_back(*similar + ":=" + value);
    description_.warnings.push_back(std::move(warning));
  }
  description_.files.assign(files_.begin(), files_.end());
}

void LaunchEvaluator::actions(const Entities& entities) {
  if (++depth_ > kDeepest) {
    if (!entities.empty())
      fail("R2W0410", "actions stand too deep in each other", entities[0].span);
  } else {
    for (const LaunchEntity& entity : entities) action(entity);
  }
  --depth_;
}

void LaunchEvaluator::action(const LaunchEntity& entity) {
  const auto rows = LaunchActionRow::table();
  const auto known = [&](const LaunchActionRow& one) {
    return !one.of_python || language_ == LaunchLanguage::kPython;
  };
  const auto row = std::find_if(rows.begin(), rows.end(), [&](const LaunchActionRow& one) {
    return one.tag == entity.tag && known(one);
  });
  if (row == rows.end()) {
    std::vector<std::string> tags;
    for (const LaunchActionRow& one : rows)
      if (known(one)) tags.emplace_back(one.tag);
    const auto similar = nearest(entity.tag, tags);
    fail("R2W0410", "launch has no action `" + entity.tag + "`", entity.span,
         {similar ? "did you mean `" + *similar + "`?"
                  : "its actions are: " + name_list(tags, tags.size())});
    return;
  }
  if (++actions_ > kMostActions) {
    if (actions_ == kMostActions + 1)
      fail("R2W0410", "more than " + std::to_string(kMostActions) + " actions", entity.span);
    return;
  }
  if (!check(entity, *row) || !applies(entity)) return;
  if (description_.processes.size() > kMostProcesses) {
    fail("R2W0410", "more than " + std::to_string(kMostProcesses) + " processes", entity.span);
    return;
  }
  (this->*row->run)(entity);
}

bool LaunchEvaluator::check(const LaunchEntity& entity, const LaunchActionRow& row) {
  Names attributes = with({"if", "unless"}, row.attributes);
  if (language_ == LaunchLanguage::kPython)
    attributes.insert(attributes.end(), {"process", "type"});
  bool good = check_attributes(entity, attributes);
  const bool any = std::find(row.parts.begin(), row.parts.end(), "*") != row.parts.end();
  for (const LaunchEntity& part : entity.children) {
    const bool fits = std::find(row.parts.begin(), row.parts.end(), part.tag) != row.parts.end();
    if (!fits && !any) {
      fail("R2W0410", "`" + part.tag + "` cannot stand in `" + entity.tag + "`", part.span);
      good = false;
    } else if (fits) {
      good = check_part(part) && good;
    }
  }
  return good;
}

/// A part, and the parts of it.
bool LaunchEvaluator::check_part(const LaunchEntity& part) {
  const auto& rows = part_rows();
  const auto row = std::find_if(rows.begin(), rows.end(),
                                [&](const PartRow& one) { return one.tag == part.tag; });
  bool good = row == rows.end() || check_attributes(part, row->attributes);
  for (const LaunchEntity& inner : part.children) good = check_part(inner) && good;
  return good;
}

bool LaunchEvaluator::check_attributes(const LaunchEntity& entity, const Names& attributes) {
  bool good = true;
  std::vector<std::string> known;
  for (const std::string_view name : attributes) {
    const bool must = name.starts_with('!');
    known.emplace_back(name.substr(must ? 1 : 0));
    if (!must || entity.attribute(known.back()) != nullptr) continue;
    fail("R2W0410", "`" + entity.tag + "` needs the attribute `" + known.back() + "`", entity.span);
    good = false;
  }
  for (const LaunchAttribute& one : entity.attributes) {
    if (std::find(known.begin(), known.end(), one.name) != known.end()) continue;
    const auto similar = nearest(one.name, known);
    fail("R2W0410", "`" + entity.tag + "` has no attribute `" + one.name + "`", one.span,
         {similar ? "did you mean `" + *similar + "`?"
                  : "its attributes are: " + name_list(known, known.size())});
    good = false;
  }
  return good;
}

bool LaunchEvaluator::applies(const LaunchEntity& entity) {
  const LaunchAttribute* wanted = entity.attribute("if");
  const LaunchAttribute* unwanted = entity.attribute("unless");
  if (wanted != nullptr && unwanted != nullptr) {
    fail("R2W0410", "`" + entity.tag + "` has both `if` and `unless`", entity.span);
    return false;
  }
  if (wanted == nullptr && unwanted == nullptr) return true;
  const LaunchAttribute& condition = wanted != nullptr ? *wanted : *unwanted;
  std::optional<bool> holds;
  if (const bool* plain = std::get_if<bool>(&condition.value)) {
    holds = *plain;
  } else {
    const auto written = text(entity, condition.name);
    if (!written) return false;
    holds = condition_of(*written);
    if (!holds) {
      fail("R2W0411", "the condition `" + *written + "` is neither true nor false", condition.span,
           {"true, false, 1 and 0 are understood"});
      return false;
    }
  }
  return *holds == (wanted != nullptr);
}

std::optional<std::string> LaunchEvaluator::text(const LaunchEntity& entity,
                                                 std::string_view name) {
  const LaunchAttribute* attribute = entity.attribute(name);
  if (attribute == nullptr) return std::nullopt;
  if (const auto* written = std::get_if<std::string>(&attribute->value))
    return evaluated(*written, attribute->span);
  if (auto plain = launch_value_text(attribute->value)) return plain;
  fail("R2W0410", "`" + std::string(name) + "` is one text, not a list", attribute->span);
  return std::nullopt;
}

std::optional<std::string> LaunchEvaluator::needed_text(const LaunchEntity& entity,
                                                        std::string_view name) {
  if (entity.attribute(name) == nullptr) {
    fail("R2W0410", "`" + entity.tag + "` needs the attribute `" + std::string(name) + "`",
         entity.span);
    return std::nullopt;
  }
  return text(entity, name);
}

std::optional<std::string> LaunchEvaluator::evaluated(const std::string& written,
                                                      const SourceSpan& span) {
  const auto parsed = parse_launch_text(written, span);
  if (!parsed) {
    errors_.insert(errors_.end(), parsed.errors().begin(), parsed.errors().end());
    return std::nullopt;
  }
  auto result = evaluate_text(*parsed, span, scope_, place_, world_);
  if (!result) {
    errors_.insert(errors_.end(), result.errors().begin(), result.errors().end());
    return std::nullopt;
  }
  text_ += result->size();
  if (text_ > kMostText) {
    fail("R2W0410", "the launch file's texts come to more than 256 MiB", span);
    return std::nullopt;
  }
  return std::move(*result);
}

bool LaunchEvaluator::flag(const LaunchEntity& entity, std::string_view name, bool otherwise) {
  const LaunchAttribute* attribute = entity.attribute(name);
  if (attribute == nullptr) return otherwise;
  const auto written = text(entity, name);
  if (!written) return otherwise;
  if (const auto result = launch_boolean(*written)) return *result;
  fail("R2W0410", "`" + std::string(name) + "` is true or false, found `" + *written + "`",
       attribute->span);
  return otherwise;
}

std::vector<std::string> LaunchEvaluator::list(const LaunchEntity& entity,
                                               const std::string& name) {
  const LaunchAttribute* attribute = entity.attribute(name);
  if (attribute == nullptr) return {};
  std::vector<std::string> result;
  if (const auto* items = std::get_if<std::vector<LaunchScalar>>(&attribute->value)) {
    for (const LaunchScalar& item : *items) {
      const auto* written = std::get_if<std::string>(&item);
      auto one = written != nullptr
                     ? evaluated(*written, attribute->span)
                     : launch_value_text(std::visit(
                           [](const auto& held) { return LaunchAttributeValue(held); }, item));
      if (one) result.push_back(std::move(*one));
    }
    return result;
  }
  const std::string whole = text(entity, name).value_or("");
  const std::string separator = text(entity, name + "_sep").value_or(",");
  std::size_t begin = 0;
  while (begin <= whole.size() && !whole.empty()) {
    const std::size_t end =
        separator.empty() ? whole.size() : std::min(whole.find(separator, begin), whole.size());
    result.push_back(whole.substr(begin, end - begin));
    begin = end + std::max<std::size_t>(1, separator.size());
  }
  return result;
}

std::int64_t LaunchEvaluator::number(const LaunchEntity& entity, std::string_view name) {
  const LaunchAttribute* attribute = entity.attribute(name);
  const auto* held = attribute == nullptr ? nullptr : std::get_if<std::int64_t>(&attribute->value);
  return held == nullptr ? -1 : *held;
}

double LaunchEvaluator::seconds(const LaunchEntity& entity, std::string_view name,
                                double otherwise) {
  const LaunchAttribute* attribute = entity.attribute(name);
  if (attribute == nullptr) return otherwise;
  const auto written = text(entity, name);
  if (!written) return otherwise;
  double result = 0;
  const auto [end, error] =
      std::from_chars(written->data(), written->data() + written->size(), result);
  if (error == std::errc() && end == written->data() + written->size() && result >= 0 &&
      result < 1e9)
    return result;
  fail("R2W0410", "`" + std::string(name) + "` is a number of seconds, found `" + *written + "`",
       attribute->span);
  return otherwise;
}

void LaunchEvaluator::fail(DiagnosticCode code, std::string message, const SourceSpan& span,
                           std::vector<std::string> why) {
  errors_.push_back(
      {.code = code, .message = std::move(message), .span = span, .why = std::move(why)});
}

Outcome<LaunchDescription> evaluate_launch(const std::string& path,
                                           const std::map<std::string, std::string>& given,
                                           const LaunchWorld& world,
                                           const std::optional<SourceSpan>& from) {
  LaunchEvaluator evaluator(world, given);
  evaluator.file(path, from);
  evaluator.events();
  evaluator.finish();
  if (!evaluator.errors().empty()) return std::move(evaluator.errors());
  return std::move(evaluator.description());
}

}  // namespace ros2wasm
