// See manifest_binding.hpp.
#include "workspace_schema/schema/manifest_binding.hpp"

#include <algorithm>

#include "workspace_schema/base/hash_text.hpp"
#include "workspace_schema/base/suggestion.hpp"
#include "workspace_schema/base/yaml_scalar.hpp"

namespace ros2wasm {
namespace {

/// Beyond this many, a file is not a manifest with mistakes but something else.
constexpr std::size_t kMostDiagnostics = 100;

bool is_text(const YamlNode& node) {
  return std::holds_alternative<std::string>(scalar_value(node));
}

bool is_scalar_value(const YamlNode& node) {
  return node.kind == YamlKind::kScalar &&
         !std::holds_alternative<std::monostate>(scalar_value(node)) &&
         !std::holds_alternative<YamlUnknownTag>(scalar_value(node));
}

/// A key in backticks; a phrase that has its own ("an item of `x`") as it is.
std::string called(const std::string& what) {
  return what.find('`') == std::string::npos ? "`" + what + "`" : what;
}

/// `key: value`, or the value alone for the item of a list.
std::string pair_or_value(const std::string& what, const std::string& value) {
  return what.find('`') == std::string::npos ? what + ": " + value : value;
}

std::string quoted_form(const std::string& text) {
  const std::string plain = as_yaml_text(text);
  return plain == text ? "\"" + text + "\"" : plain;
}

}  // namespace

const YamlNode* value_of(const YamlNode& map, std::string_view key) {
  const auto found = std::find_if(map.entries.begin(), map.entries.end(),
                                  [key](const YamlEntry& entry) { return entry.key == key; });
  return found == map.entries.end() ? nullptr : &found->value;
}

Diagnostic& Binder::error(DiagnosticCode code, std::string message, TextRange at,
                          std::string label) {
  if (errors_.size() >= kMostDiagnostics) errors_.pop_back();
  errors_.push_back(Diagnostic{
      .code = code, .message = std::move(message), .span = span(at), .label = std::move(label)});
  return errors_.back();
}

Diagnostic& Binder::warning(DiagnosticCode code, std::string message, TextRange at,
                            std::string label) {
  if (warnings_.size() >= kMostDiagnostics) warnings_.pop_back();
  warnings_.push_back(Diagnostic{.code = code,
                                 .severity = Severity::kWarning,
                                 .message = std::move(message),
                                 .span = span(at),
                                 .label = std::move(label)});
  return warnings_.back();
}

void Binder::add(Diagnostics found) {
  for (Diagnostic& diagnostic : found) errors_.push_back(std::move(diagnostic));
}

Diagnostic& Binder::wrong_type(const YamlNode& node, const std::string& what,
                               std::string_view wanted) {
  const bool nothing = node.kind == YamlKind::kNull && !node.written;
  if (nothing)
    return error("R2W0103", called(what) + " has no value", node.range,
                 "expected " + std::string(wanted));
  if (node.kind == YamlKind::kScalar &&
      std::holds_alternative<YamlUnknownTag>(scalar_value(node))) {
    Diagnostic& wrong =
        error("R2W0103", "the value of " + called(what) + " has a tag that does not fit",
              node.range, "tagged `" + node.tag + "`");
    wrong.why.push_back(
        "only YAML's own tags are read, such as `!!str`, and the value must fit its tag");
    return wrong;
  }
  return error("R2W0103", called(what) + " must be " + std::string(wanted), node.range,
               "this is " + std::string(described(node)));
}

std::optional<Spanned<std::string>> Binder::text(
    const YamlNode& node, const std::string& what,
    const std::function<bool(const std::string&)>& accepts, std::string_view wanted,
    const std::string& rule) {
  if (is_text(node)) return Spanned<std::string>{.value = node.text, .span = span(node)};
  Diagnostic& wrong = wrong_type(node, what, wanted);
  if (!rule.empty()) wrong.why.push_back(rule);
  const bool only_item =
      node.kind == YamlKind::kSequence && node.items.size() == 1 && is_text(node.items.front());
  if (!is_scalar_value(node) && !only_item) return std::nullopt;
  const std::string& meant = only_item ? node.items.front().text : node.text;
  if (accepts && !accepts(meant)) return std::nullopt;
  wrong.fix.push_back("write `" +
                      (only_item ? pair_or_value(what, as_yaml_text(meant)) : quoted_form(meant)) +
                      "`");
  return std::nullopt;
}

std::optional<Spanned<std::string>> Binder::line(const YamlNode& node, const std::string& what) {
  auto found = text(node, what);
  if (!found) return std::nullopt;
  if (found->value.find_first_not_of(" \t\r\n") == std::string::npos) {
    error("R2W0103", called(what) + " is empty", node.range, "expected a text");
    return std::nullopt;
  }
  // A folded block ends with a newline that nobody means.
  while (found->value.ends_with('\n')) found->value.pop_back();
  if (found->value.find('\n') != std::string::npos) {
    error("R2W0103", called(what) + " must be one line", node.range, "this has several lines");
    return std::nullopt;
  }
  return found;
}

std::optional<Spanned<std::string>> Binder::written(const YamlNode& node, const std::string& what) {
  const YamlValue value = scalar_value(node);
  const bool number = std::holds_alternative<std::int64_t>(value) ||
                      std::holds_alternative<double>(value) ||
                      std::holds_alternative<YamlIntegerTooLarge>(value);
  if (number) return Spanned<std::string>{.value = node.text, .span = span(node)};
  return line(node, what);
}

std::optional<bool> Binder::boolean(const YamlNode& node, const std::string& what) {
  const YamlValue value = scalar_value(node);
  if (const bool* found = std::get_if<bool>(&value)) return *found;
  Diagnostic& wrong = wrong_type(node, what, "`true` or `false`");
  std::string low = node.text;
  std::transform(low.begin(), low.end(), low.begin(), [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  });
  for (const std::string_view yes : {"true", "yes", "on", "y", "1"}) {
    if (low == yes) wrong.fix.push_back("write `true`");
  }
  for (const std::string_view no : {"false", "no", "off", "n", "0"}) {
    if (low == no) wrong.fix.push_back("write `false`");
  }
  return std::nullopt;
}

std::optional<Spanned<std::string>> Binder::word(const YamlNode& node, const std::string& what,
                                                 std::span<const std::string> words) {
  const auto known = [words](const std::string& meant) {
    return std::find(words.begin(), words.end(), meant) != words.end();
  };
  auto found = text(node, what, known, "one of " + name_list(words, 12));
  if (!found) return std::nullopt;
  if (std::find(words.begin(), words.end(), found->value) != words.end()) return found;
  Diagnostic& wrong = error("R2W0103", called(what) + " cannot be `" + found->value + "`",
                            node.range, "not one of its values");
  wrong.why.push_back("its values are: " + name_list(words, 12));
  if (const auto near = nearest(found->value, words)) {
    wrong.fix.push_back("write `" + pair_or_value(what, as_yaml_text(*near)) + "`");
  }
  return std::nullopt;
}

void Binder::name_error(const YamlNode& node, std::string message, std::size_t inner_offset,
                        const NameFault& fault) {
  TextRange at = node.range;
  if (node.verbatim && fault.length > 0) {
    at = {node.text_offset + inner_offset + fault.offset, fault.length};
  }
  Diagnostic& wrong = error("R2W0104", std::move(message), at, fault.why);
  wrong.why.push_back(fault.rule);
  if (fault.better) wrong.fix.push_back("write `" + *fault.better + "`");
}

Diagnostic* Binder::missing(const YamlNode& map, const std::string& what, const std::string& key) {
  if (meant_.contains({map.range.offset, key})) return nullptr;
  return &error("R2W0106", what + " has no `" + key + "`", map.range, "`" + key + "` is missing");
}

std::optional<Spanned<std::string>> Binder::name(const YamlNode& node, const std::string& what,
                                                 NameCheck check) {
  const auto good = [check](const std::string& meant) { return !check(meant); };
  const bool scalar = node.kind == YamlKind::kScalar;
  const auto broken = scalar ? check(node.text) : std::nullopt;
  auto found = text(node, what, good, "a text", broken ? broken->rule : "");
  if (!found) return std::nullopt;
  const auto fault = check(found->value);
  if (!fault) return found;
  if (found->value.empty()) {
    error("R2W0103", called(what) + " is empty", node.range, "expected a name")
        .why.push_back(fault->rule);
  } else {
    name_error(node, called(what) + " cannot be `" + found->value + "`", 0, *fault);
  }
  return std::nullopt;
}

std::optional<Spanned<std::string>> Binder::path(const YamlNode& node, const std::string& what) {
  auto found = line(node, what);
  if (!found) return std::nullopt;
  const std::string& text_value = found->value;
  Diagnostic* wrong = nullptr;
  if (const std::size_t backslash = text_value.find('\\'); backslash != std::string::npos) {
    wrong = &error("R2W0114", "paths are written with `/`", node.range, "this has a backslash");
    std::string forward = text_value;
    std::replace(forward.begin(), forward.end(), '\\', '/');
    if (!forward.starts_with('/') && forward.find(':') == std::string::npos) {
      wrong->fix.push_back("write `" + forward + "`");
    }
  } else if (text_value.starts_with('/') || text_value.starts_with('~') ||
             (text_value.size() > 1 && text_value[1] == ':')) {
    wrong = &error("R2W0114", called(what) + " must be a path relative to the manifest", node.range,
                   "this path exists on one machine only");
  }
  if (wrong == nullptr) return found;
  wrong->why.push_back(
      "paths are relative to the folder of the manifest, so that the workspace packs everywhere");
  return std::nullopt;
}

std::string Binder::sha256(const YamlNode& node) {
  // One without letters is a number to YAML.
  const auto hash = written(node, "sha256");
  if (!hash) return {};
  if (is_sha256_text(hash->value)) return hash->value;
  error("R2W0103", "`sha256` must be 64 hexadecimal digits", node.range,
        "as `sha256sum` writes them, in lower case");
  return {};
}

Diagnostics Binder::errors_in_order() {
  const auto place = [](const Diagnostic& one) {
    return one.span ? std::pair(one.span->line, one.span->column) : std::pair(0U, 0U);
  };
  std::stable_sort(
      errors_.begin(), errors_.end(),
      [&place](const Diagnostic& a, const Diagnostic& b) { return place(a) < place(b); });
  return take_errors();
}

void Binder::list(const YamlNode& node, const std::string& what,
                  const std::function<void(const YamlNode&)>& each) {
  if (node.kind != YamlKind::kSequence) {
    Diagnostic& wrong = wrong_type(node, what, "a list");
    if (is_text(node)) {
      wrong.fix.push_back("write `" + what + ": [" + as_yaml_text(node.text) + "]`");
    } else if (node.kind == YamlKind::kMap && !node.entries.empty()) {
      wrong.why.push_back("each item of a list begins with `- `");
    }
    return;
  }
  for (const YamlNode& item : node.items) each(item);
}

std::vector<Spanned<std::string>> Binder::texts(
    const YamlNode& node, const std::string& what,
    const std::function<std::optional<Spanned<std::string>>(const YamlNode&)>& item) {
  std::vector<Spanned<std::string>> found;
  list(node, what, [&](const YamlNode& entry) {
    if (auto value = item(entry)) found.push_back(*std::move(value));
  });
  return found;
}

bool Binder::mapping(const YamlNode& node, const std::string& where, std::span<const KeyRow> keys) {
  if (node.kind != YamlKind::kMap) return false;
  for (const YamlEntry& entry : node.entries) {
    const bool known = std::any_of(keys.begin(), keys.end(),
                                   [&](const KeyRow& row) { return row.name == entry.key; });
    if (!known) unknown_key(node, entry, where, keys);
  }
  return true;
}

void Binder::unknown_key(const YamlNode& map, const YamlEntry& entry, const std::string& where,
                         std::span<const KeyRow> keys) {
  std::vector<std::string> names;
  std::optional<std::string> meant;
  for (const KeyRow& row : keys) {
    names.emplace_back(row.name);
    const auto& others = row.also_called;
    if (std::find(others.begin(), others.end(), entry.key) != others.end())
      meant = std::string(row.name);
  }
  if (!meant) meant = nearest(entry.key, names);
  Diagnostic& wrong = error("R2W0102", "there is no key `" + entry.key + "` in " + where,
                            entry.key_range, "unknown key");
  wrong.why.push_back("its keys are: " + name_list(names, 24));
  if (!meant) return;
  if (value_of(map, *meant) == nullptr) {
    meant_.emplace(map.range.offset, *meant);
    wrong.fix.push_back("write `" + *meant + "`");
  } else {
    wrong.why.push_back("`" + *meant + "` is here already");
  }
}

}  // namespace ros2wasm
