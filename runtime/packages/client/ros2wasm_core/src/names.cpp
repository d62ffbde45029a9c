// Name rules of ROS 2: validation in the order, and with the words, that users know.
#include "ros2wasm/names.hpp"

namespace ros2wasm {
namespace {

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

bool is_word(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || is_digit(c) || c == '_';
}

// Where "/" is followed by a digit, or npos.
size_t find_numeric_token(std::string_view name) {
  for (size_t i = 0; i + 1 < name.size(); ++i) {
    if (name[i] == '/' && is_digit(name[i + 1])) {
      return i + 1;
    }
  }
  return std::string_view::npos;
}

}  // namespace

std::optional<NameProblem> check_node_name(std::string_view name) {
  if (name.empty()) {
    return NameProblem{"node name must not be empty", 0};
  }
  for (size_t i = 0; i < name.size(); ++i) {
    if (!is_word(name[i])) {
      return NameProblem{"node name must not contain characters other than alphanumerics or '_'",
                         i};
    }
  }
  if (is_digit(name[0])) {
    return NameProblem{"node name must not start with a number", 0};
  }
  if (name.size() > 255) {
    return NameProblem{"node name length should not exceed '255'", 255};
  }
  return std::nullopt;
}

std::optional<NameProblem> check_namespace(std::string_view ns) {
  if (ns.empty()) {
    return NameProblem{"namespace must not be empty", 0};
  }
  if (ns == "/") {
    return std::nullopt;
  }
  if (ns[0] != '/') {
    return NameProblem{"namespace must be absolute, it must lead with a '/'", 0};
  }
  if (ns.back() == '/') {
    return NameProblem{"namespace must not end with a '/', unless only a '/'", ns.size() - 1};
  }
  for (size_t i = 0; i < ns.size(); ++i) {
    if (!is_word(ns[i]) && ns[i] != '/') {
      return NameProblem{
          "namespace must not contain characters other than alphanumerics, '_', or '/'", i};
    }
  }
  const size_t repeated = ns.find("//");
  if (repeated != std::string_view::npos) {
    return NameProblem{"namespace must not contain repeated '/'", repeated + 1};
  }
  const size_t numeric = find_numeric_token(ns);
  if (numeric != std::string_view::npos) {
    return NameProblem{"namespace must not have a token that starts with a number", numeric};
  }
  if (ns.size() > 245) {
    return NameProblem{"namespace should not exceed '245'", 245};
  }
  return std::nullopt;
}

std::optional<NameProblem> check_topic_name(std::string_view name) {
  if (name.empty()) {
    return NameProblem{"topic name must not be empty string", 0};
  }
  if (name.back() == '/') {
    return NameProblem{"topic name must not end with a forward slash", name.size() - 1};
  }
  if (is_digit(name[0])) {
    return NameProblem{"topic name token must not start with a number", 0};
  }
  bool in_braces = false;
  size_t opening = 0;
  for (size_t i = 0; i < name.size(); ++i) {
    const char c = name[i];
    if (is_word(c)) {
      if (is_digit(c) && in_braces && i > 0 && i == opening + 1) {
        return NameProblem{"substitution name must not start with a number", i};
      }
    } else if (c == '/') {
      if (in_braces) {
        return NameProblem{
            "substitution name must not contain characters other than alphanumerics or '_'", i};
      }
    } else if (c == '~') {
      if (i != 0) {
        return NameProblem{"topic name must not have tilde '~' unless it is the first character",
                           i};
      }
    } else if (c == '{') {
      if (in_braces) {
        return NameProblem{
            "substitution name must not contain characters other than alphanumerics or '_'", i};
      }
      in_braces = true;
      opening = i;
    } else if (c == '}') {
      if (!in_braces) {
        return NameProblem{"topic name must not have unmatched (unbalanced) curly braces '{}'", i};
      }
      in_braces = false;
    } else {
      return NameProblem{
          in_braces
              ? "substitution name must not contain characters other than alphanumerics or '_'"
              : "topic name must not contain characters other than alphanumerics, '_', '~', '{', "
                "or '}'",
          i};
    }
  }
  if (in_braces) {
    return NameProblem{"topic name must not have unmatched (unbalanced) curly braces '{}'",
                       opening};
  }
  if (name.size() > 1 && name[0] == '~' && name[1] != '/') {
    return NameProblem{
        "topic name must not have a tilde '~' that is not followed by a forward slash '/'", 1};
  }
  const size_t numeric = find_numeric_token(name);
  if (numeric != std::string_view::npos) {
    return NameProblem{"topic name token must not start with a number", numeric};
  }
  return std::nullopt;
}

std::optional<NameProblem> check_full_topic_name(std::string_view name) {
  if (name.empty()) {
    return NameProblem{"topic name must not be empty string", 0};
  }
  if (name[0] != '/') {
    return NameProblem{"topic name must be absolute, it must lead with a '/'", 0};
  }
  if (name.back() == '/') {
    return NameProblem{"topic name must not end with a '/'", name.size() - 1};
  }
  for (size_t i = 0; i < name.size(); ++i) {
    if (!is_word(name[i]) && name[i] != '/') {
      return NameProblem{
          "topic name must not contain characters other than alphanumerics, '_', or '/'", i};
    }
  }
  const size_t repeated = name.find("//");
  if (repeated != std::string_view::npos) {
    return NameProblem{"topic name must not contain repeated '/'", repeated + 1};
  }
  const size_t numeric = find_numeric_token(name);
  if (numeric != std::string_view::npos) {
    return NameProblem{"topic name must not have a token that starts with a number", numeric};
  }
  if (name.size() > 247) {
    return NameProblem{"topic length should not exceed '247'", 247};
  }
  return std::nullopt;
}

std::string join_name(std::string_view ns, std::string_view name) {
  std::string full(ns);
  if (full.empty() || full.back() != '/') {
    full += '/';
  }
  return full += name;
}

std::string expand_topic_name(std::string_view name, std::string_view node, std::string_view ns) {
  std::string text(name);
  if (text[0] == '~') {
    text = join_name(ns, node) + text.substr(1);
  }
  size_t open = 0;
  while ((open = text.find('{', open)) != std::string::npos) {
    const size_t close = text.find('}', open);
    if (close == std::string::npos) {
      return {};
    }
    const std::string_view key = std::string_view(text).substr(open + 1, close - open - 1);
    std::string_view value;
    if (key == "node") {
      value = node;
    } else if (key == "ns" || key == "namespace") {
      value = ns;
    } else {
      return {};
    }
    text.replace(open, close - open + 1, value);
    open += value.size();
  }
  return text[0] == '/' ? text : join_name(ns, text);
}

}  // namespace ros2wasm
