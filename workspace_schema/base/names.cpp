// See names.hpp. Pure.
#include "workspace_schema/base/names.hpp"

#include <algorithm>
#include <array>

#include "workspace_schema/base/text_encoding.hpp"

namespace ros2wasm {
namespace {

constexpr std::size_t kLongestNodeName = 255;
constexpr std::size_t kLongestTopicName =
    247;  // DDS's 255 without the prefix that ROS puts before it
constexpr std::size_t kLongestNamespace = 245;

constexpr std::string_view kNodeRule =
    "a node name has letters, digits and `_`, and does not begin with a digit";
constexpr std::string_view kNamespaceRule =
    "a namespace is parts of letters, digits and `_` with `/` before each, such as `/robot1`; no "
    "part begins with a digit";
constexpr std::string_view kTopicRule =
    "a topic name is parts of letters, digits and `_` with `/` between; no part begins with a "
    "digit; `~/` may begin it";
constexpr std::string_view kPackageRule =
    "a package name has letters, digits, `_` and `-`, and begins with a letter";
constexpr std::string_view kChannelPackageRule =
    "a package of a channel is named by small letters, digits, `_`, `-`, `.` and `+`";
constexpr std::string_view kExecutableRule =
    "an executable is the name of a file in lib/<package>: no `/`, no white space, not `.` or `..`";
constexpr std::string_view kWorkspaceRule =
    "a workspace name has letters, digits, `_`, `-` and `.`, and begins with a letter or digit; it "
    "names the site's folder";
constexpr std::string_view kParameterRule =
    "a parameter name has letters, digits, `_`, `-` and `/`, with single dots between its parts";

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}
bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}
bool is_word(char c) {
  return is_letter(c) || is_digit(c) || c == '_';
}

/// "`é` is not allowed", with the whole character.
NameFault bad_character(std::string_view text, std::size_t at, std::string_view rule) {
  const Utf8Character character = decode_utf8(text, at);
  const std::string shown = text[at] == ' ' ? "a space"
                            : text[at] == '\t'
                                ? "a tab"
                                : "`" + std::string(text.substr(at, character.length)) + "`";
  return {.why = shown + " is not allowed",
          .offset = at,
          .length = character.length,
          .rule = std::string(rule)};
}

NameFault empty_name(std::string_view rule) {
  return {.why = "it is empty", .rule = std::string(rule)};
}

NameFault too_long(std::string_view text, std::size_t most, std::string_view rule) {
  return {.why = "it has " + std::to_string(text.size()) + " bytes, " + std::to_string(most) +
                 " are allowed",
          .offset = most,
          .length = text.size() - most,
          .rule = std::string(rule)};
}

/// Words joined by `_`: every run of other characters becomes one `_`; a digit in front gets
/// `prefix`.
std::string as_word(std::string_view text, std::string_view prefix) {
  std::string out;
  for (const char c : text) {
    if (is_word(c)) {
      out += c;
    } else if (!out.empty() && out.back() != '_') {
      out += '_';
    }
  }
  while (out.size() > 1 && out.back() == '_' && !text.ends_with('_')) out.pop_back();
  if (!out.empty() && is_digit(out.front())) out.insert(0, prefix);
  return out;
}

/// Sets `better` when the candidate differs and passes the same rule.
std::optional<NameFault> with_better(NameFault fault, std::string_view text,
                                     const std::string& candidate,
                                     std::optional<NameFault> (*check)(std::string_view)) {
  if (!candidate.empty() && candidate != text && !check(candidate)) fault.better = candidate;
  return fault;
}

std::optional<NameFault> node_fault_bare(std::string_view text) {
  if (text.empty()) return empty_name(kNodeRule);
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (!is_word(text[i])) return bad_character(text, i, kNodeRule);
  }
  if (is_digit(text.front())) {
    return NameFault{
        .why = "it begins with a digit", .offset = 0, .length = 1, .rule = std::string(kNodeRule)};
  }
  if (text.size() > kLongestNodeName) return too_long(text, kLongestNodeName, kNodeRule);
  return std::nullopt;
}

/// Parts between slashes, from `start`; used for namespaces and topics.
std::optional<NameFault> parts_fault(std::string_view text, std::size_t start,
                                     std::string_view rule, bool substitutions) {
  bool at_part_start = true;
  for (std::size_t i = start; i < text.size(); ++i) {
    const char c = text[i];
    if (c == '/') {
      if (at_part_start && i > start) {
        return NameFault{.why = "it has two slashes in a row",
                         .offset = i - 1,
                         .length = 2,
                         .rule = std::string(rule)};
      }
      at_part_start = true;
      continue;
    }
    if (substitutions && c == '{') {
      const std::size_t close = text.find('}', i);
      const std::string_view inside =
          close == std::string_view::npos ? std::string_view() : text.substr(i + 1, close - i - 1);
      if (inside != "node" && inside != "ns" && inside != "namespace") {
        return NameFault{.why = "only the substitutions `{node}`, `{ns}` and `{namespace}` exist",
                         .offset = i,
                         .length = close == std::string_view::npos ? 1 : close - i + 1,
                         .rule = std::string(rule)};
      }
      i = close;
      at_part_start = false;
      continue;
    }
    if (!is_word(c)) return bad_character(text, i, rule);
    if (at_part_start && is_digit(c)) {
      return NameFault{
          .why = "a part begins with a digit", .offset = i, .length = 1, .rule = std::string(rule)};
    }
    at_part_start = false;
  }
  if (text.size() > 1 && text.back() == '/') {
    return NameFault{.why = "it ends with a slash",
                     .offset = text.size() - 1,
                     .length = 1,
                     .rule = std::string(rule)};
  }
  return std::nullopt;
}

/// Each part made a word, empty parts dropped, `lead` in front.
std::string as_parts(std::string_view text, std::string_view lead) {
  std::string out(lead);
  bool first = true;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find('/', begin), text.size());
    const std::string part = as_word(text.substr(begin, end - begin), "_");
    if (!part.empty() && part != "_") {
      if (!first) out += '/';
      out += part;
      first = false;
    }
    begin = end + 1;
  }
  return out;
}

std::optional<NameFault> namespace_fault_bare(std::string_view text) {
  if (text.empty()) return empty_name(kNamespaceRule);
  if (text == "/") return std::nullopt;
  if (auto fault = parts_fault(text, 0, kNamespaceRule, false)) return fault;
  if (text.size() > kLongestNamespace) return too_long(text, kLongestNamespace, kNamespaceRule);
  return std::nullopt;
}

std::optional<NameFault> topic_fault_bare(std::string_view text) {
  if (text.empty()) return empty_name(kTopicRule);
  if (text == "/")
    return NameFault{
        .why = "`/` alone names no topic", .length = 1, .rule = std::string(kTopicRule)};
  if (const std::size_t tilde = text.find('~', 1); tilde != std::string_view::npos) {
    return NameFault{.why = "`~` may only come first",
                     .offset = tilde,
                     .length = 1,
                     .rule = std::string(kTopicRule)};
  }
  if (text.front() == '~' && text.size() > 1 && text[1] != '/') {
    return NameFault{.why = "`~` must be followed by `/`",
                     .offset = 1,
                     .length = 1,
                     .rule = std::string(kTopicRule)};
  }
  if (auto fault = parts_fault(text, text.front() == '~' ? 1 : 0, kTopicRule, true)) return fault;
  if (text.size() > kLongestTopicName) return too_long(text, kLongestTopicName, kTopicRule);
  return std::nullopt;
}

std::optional<NameFault> package_fault_bare(std::string_view text) {
  if (text.empty()) return empty_name(kPackageRule);
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (!is_word(text[i]) && text[i] != '-') return bad_character(text, i, kPackageRule);
  }
  if (!is_letter(text.front())) {
    return NameFault{
        .why = "it does not begin with a letter", .length = 1, .rule = std::string(kPackageRule)};
  }
  return std::nullopt;
}

std::optional<NameFault> workspace_fault_bare(std::string_view text) {
  constexpr std::size_t kMost = 100;
  if (text.empty()) return empty_name(kWorkspaceRule);
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (!is_word(text[i]) && text[i] != '-' && text[i] != '.')
      return bad_character(text, i, kWorkspaceRule);
  }
  if (!is_letter(text.front()) && !is_digit(text.front())) {
    return NameFault{.why = "it does not begin with a letter or digit",
                     .length = 1,
                     .rule = std::string(kWorkspaceRule)};
  }
  if (text.size() > kMost) return too_long(text, kMost, kWorkspaceRule);
  return std::nullopt;
}

std::string as_workspace_name(std::string_view text) {
  std::string out;
  for (const char c : text) {
    const bool good = is_word(c) || c == '-' || c == '.';
    if (good && (!out.empty() || is_letter(c) || is_digit(c))) {
      out += c;
    } else if (!good && !out.empty() && out.back() != '_') {
      out += '_';
    }
  }
  while (!out.empty() && out.back() == '_') out.pop_back();
  return out;
}

}  // namespace

std::string absolute_name(std::string_view name) {
  return (name.starts_with('/') ? "" : "/") + std::string(name);
}

std::optional<NameFault> node_name_fault(std::string_view text) {
  auto fault = node_fault_bare(text);
  if (!fault) return std::nullopt;
  return with_better(*std::move(fault), text, as_word(text, "_"), node_fault_bare);
}

std::optional<NameFault> namespace_fault(std::string_view text) {
  auto fault = namespace_fault_bare(text);
  if (!fault) return std::nullopt;
  return with_better(*std::move(fault), text, as_parts(text, text.starts_with('/') ? "/" : ""),
                     namespace_fault_bare);
}

std::optional<NameFault> topic_name_fault(std::string_view text) {
  auto fault = topic_fault_bare(text);
  if (!fault) return std::nullopt;
  const std::string_view lead = text.starts_with('~') ? "~/" : text.starts_with('/') ? "/" : "";
  return with_better(*std::move(fault), text, as_parts(text, lead), topic_fault_bare);
}

std::optional<NameFault> package_name_fault(std::string_view text) {
  auto fault = package_fault_bare(text);
  if (!fault) return std::nullopt;
  std::string candidate = as_word(text, "");
  while (!candidate.empty() && !is_letter(candidate.front())) candidate.erase(0, 1);
  return with_better(*std::move(fault), text, candidate, package_fault_bare);
}

std::optional<NameFault> channel_package_name_fault(std::string_view text) {
  if (text.empty()) return empty_name(kChannelPackageRule);
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    const bool sign = c == '-' || c == '.' || c == '+';
    const bool good = (c >= 'a' && c <= 'z') || is_digit(c) || c == '_' || (sign && i > 0);
    if (!good) return bad_character(text, i, kChannelPackageRule);
  }
  return std::nullopt;
}

std::optional<NameFault> executable_name_fault(std::string_view text) {
  if (text.empty()) return empty_name(kExecutableRule);
  if (text == "." || text == "..") {
    return NameFault{
        .why = "it names a folder", .length = text.size(), .rule = std::string(kExecutableRule)};
  }
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto c = static_cast<unsigned char>(text[i]);
    if (c == '/' || c == '\\' || c <= 0x20 || c == 0x7F)
      return bad_character(text, i, kExecutableRule);
  }
  return std::nullopt;
}

std::optional<NameFault> workspace_name_fault(std::string_view text) {
  auto fault = workspace_fault_bare(text);
  if (!fault) return std::nullopt;
  return with_better(*std::move(fault), text, as_workspace_name(text), workspace_fault_bare);
}

std::optional<NameFault> parameter_name_fault(std::string_view text) {
  if (text.empty()) return empty_name(kParameterRule);
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (!is_word(c) && c != '.' && c != '-' && c != '/')
      return bad_character(text, i, kParameterRule);
    const bool edge = i == 0 || i + 1 == text.size();
    if (c == '.' && (edge || text[i - 1] == '.')) {
      return NameFault{.why = edge ? "it begins or ends with a dot" : "it has two dots in a row",
                       .offset = edge ? i : i - 1,
                       .length = edge ? 1U : 2U,
                       .rule = std::string(kParameterRule)};
    }
  }
  return std::nullopt;
}

}  // namespace ros2wasm
