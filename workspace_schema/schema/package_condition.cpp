// Conditions of package.xml format 3 (REP 149): `$ROS_VERSION == 2 and ($ROS_DISTRO > "foxy" or
// ...)`. Values are compared as texts. `and` binds closer than `or`. Pure.
#include "workspace_schema/schema/package_xml.hpp"

namespace ros2wasm {
namespace {

constexpr int kDeepest = 64;

class ConditionParser {
 public:
  ConditionParser(std::string_view text, const ConditionVariables& variables)
      : text_(text), variables_(variables) {}

  std::optional<bool> parse() {
    const auto result = either();
    skip_space();
    return at_ == text_.size() ? result : std::nullopt;
  }

 private:
  void skip_space() {
    while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\t' || text_[at_] == '\n'))
      ++at_;
  }

  static bool is_literal(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
           c == '-' || c == '.';
  }

  bool take(std::string_view token) {
    skip_space();
    if (!text_.substr(at_).starts_with(token)) return false;
    at_ += token.size();
    return true;
  }

  bool take_word(std::string_view word) {
    skip_space();
    const std::size_t end = at_ + word.size();
    if (!text_.substr(at_).starts_with(word) || (end < text_.size() && is_literal(text_[end])))
      return false;
    at_ = end;
    return true;
  }

  std::optional<bool> either() {
    auto left = both();
    while (left && take_word("or")) {
      const auto right = both();
      left = right ? std::optional(*left || *right) : std::nullopt;
    }
    return left;
  }

  std::optional<bool> both() {
    auto left = single();
    while (left && take_word("and")) {
      const auto right = single();
      left = right ? std::optional(*left && *right) : std::nullopt;
    }
    return left;
  }

  std::optional<bool> single() {
    if (take("(")) {
      if (++depth_ > kDeepest) return std::nullopt;
      const auto inside = either();
      --depth_;
      return take(")") ? inside : std::nullopt;
    }
    const auto left = value();
    if (!left) return std::nullopt;
    for (const std::string_view sign : {"==", "!=", "<=", ">=", "<", ">"}) {
      if (!take(sign)) continue;
      const auto right = value();
      if (!right) return std::nullopt;
      if (sign == "==") return *left == *right;
      if (sign == "!=") return *left != *right;
      if (sign == "<=") return *left <= *right;
      if (sign == ">=") return *left >= *right;
      if (sign == "<") return *left < *right;
      return *left > *right;
    }
    return std::nullopt;
  }

  std::optional<std::string> value() {
    skip_space();
    if (at_ == text_.size()) return std::nullopt;
    const char first = text_[at_];
    if (first == '"' || first == '\'') {
      const std::size_t close = text_.find(first, at_ + 1);
      if (close == std::string_view::npos) return std::nullopt;
      std::string inside(text_.substr(at_ + 1, close - at_ - 1));
      at_ = close + 1;
      return inside;
    }
    const bool variable = first == '$';
    if (variable) ++at_;
    const std::size_t begin = at_;
    while (at_ < text_.size() && is_literal(text_[at_])) ++at_;
    if (at_ == begin) return std::nullopt;
    std::string word(text_.substr(begin, at_ - begin));
    if (!variable) return word;
    const auto found = variables_.find(word);
    return found == variables_.end() ? std::string() : found->second;
  }

  std::string_view text_;
  const ConditionVariables& variables_;
  std::size_t at_ = 0;
  int depth_ = 0;
};

}  // namespace

std::optional<bool> evaluate_condition(std::string_view condition,
                                       const ConditionVariables& variables) {
  return ConditionParser(condition, variables).parse();
}

}  // namespace ros2wasm
