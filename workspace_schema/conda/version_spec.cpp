// See version_spec.hpp.
#include "workspace_schema/conda/version_spec.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include "workspace_schema/base/text_pattern.hpp"
#include "workspace_schema/base/trimmed_text.hpp"

namespace ros2wasm {

struct VersionSpec::Node {
  enum class Kind {
    kAny,
    kAnd,
    kOr,
    kEqual,
    kNotEqual,
    kLess,
    kLessEqual,
    kGreater,
    kGreaterEqual,
    kStartsWith,
    kNotStartsWith,
    kCompatible,  ///< ~=: not older, and the same but for the last part
    kPattern,     ///< glob or regular expression over the text
  };
  Kind kind = Kind::kAny;
  std::vector<std::shared_ptr<const Node>> parts;
  Version version;
  std::optional<Version> stem;  ///< of kCompatible: without the last part
  TextPattern pattern;

  [[nodiscard]] bool matches(const Version& candidate) const;
};

namespace {

using Node = VersionSpec::Node;
using NodePointer = std::shared_ptr<Node>;
using Kind = Node::Kind;

constexpr std::size_t kLongest = 8192;
constexpr std::string_view kBlanks = " \t";

Diagnostic bad_spec(std::string_view text, const std::string& why) {
  return Diagnostic{
      .code = "R2W0303",
      .message = "`" + std::string(text.substr(0, 100)) + "` says nothing about versions: " + why};
}

struct Relation {
  std::string_view sign;
  Kind kind;
};

// Longer signs first.
constexpr auto kRelations = std::to_array<Relation>({
    {"==", Kind::kEqual},
    {"!=", Kind::kNotEqual},
    {"<=", Kind::kLessEqual},
    {">=", Kind::kGreaterEqual},
    {"~=", Kind::kCompatible},
    {"=", Kind::kStartsWith},
    {"<", Kind::kLess},
    {">", Kind::kGreater},
});

Outcome<NodePointer> with_version(Kind kind, std::string_view text) {
  auto version = Version::parse(text);
  if (!version) return bad_spec(text, version.errors().front().message);
  Node node{.kind = kind, .version = std::move(*version)};
  if (kind == Kind::kCompatible) {
    // `~=1` has nothing to keep: any version that is not older.
    const std::string& full = node.version.text();
    const std::size_t dot = full.rfind('.');
    if (dot != std::string::npos) {
      auto stem = Version::parse(full.substr(0, dot));
      if (!stem) return bad_spec(text, stem.errors().front().message);
      node.stem = std::move(*stem);
    }
  }
  return NodePointer(std::make_shared<Node>(std::move(node)));
}

Outcome<NodePointer> relation(std::string_view text) {
  const auto* found =
      std::find_if(kRelations.begin(), kRelations.end(),
                   [text](const Relation& row) { return text.starts_with(row.sign); });
  if (found == kRelations.end()) return bad_spec(text, "no such comparison");
  std::string_view rest = trimmed(text.substr(found->sign.size()), kBlanks);
  if (rest.empty())
    return bad_spec(text, "a version is missing behind `" + std::string(found->sign) + "`");
  if (std::string_view("=<>!~").find(rest.front()) != std::string_view::npos ||
      rest.find(' ') != std::string_view::npos) {
    return bad_spec(text, "no such comparison");
  }
  Kind kind = found->kind;
  if (rest.ends_with(".*")) {
    rest.remove_suffix(2);
    if (kind == Kind::kCompatible) return bad_spec(text, "`~=` and `.*` exclude each other");
    if (kind == Kind::kNotEqual) kind = Kind::kNotStartsWith;
  }
  return with_version(kind, rest);
}

Outcome<NodePointer> as_pattern(std::string_view text) {
  auto pattern = TextPattern::parse(text, LetterCase::kCounts);
  if (!pattern) return std::move(pattern).errors();
  return NodePointer(
      std::make_shared<Node>(Node{.kind = Kind::kPattern, .pattern = std::move(*pattern)}));
}

/// `1.8*` and `1.8.*`: fuzzy.
Outcome<NodePointer> ending_in_star(std::string_view text) {
  std::string stem(text);
  if (!stem.ends_with(".*")) stem = stem.substr(0, stem.size() - 1) + ".*";
  while (stem.ends_with('*')) stem.pop_back();
  while (stem.ends_with('.')) stem.pop_back();
  return with_version(Kind::kStartsWith, stem);
}

Outcome<NodePointer> leaf(std::string_view text) {
  if (text.empty()) return bad_spec(text, "it is empty");
  if (text.front() == '^' || text.back() == '$') {
    if (text.front() != '^' || text.back() != '$') {
      return bad_spec(text, "a regular expression begins with `^` and ends with `$`");
    }
    return as_pattern(text);
  }
  if (std::string_view("=<>!~").find(text.front()) != std::string_view::npos) return relation(text);
  if (text == "*") return NodePointer(std::make_shared<Node>());
  const std::size_t last_solid = text.find_last_not_of('*');
  const std::size_t first_star = text.find('*');
  if (last_solid != std::string_view::npos && first_star < last_solid) return as_pattern(text);
  if (text.back() == '*') return ending_in_star(text);
  if (text.find('@') != std::string_view::npos) return as_pattern(text);
  return with_version(Kind::kEqual, text);
}

/// Operators and operands; a regular expression is one operand, whatever it holds.
std::vector<std::string_view> tokens_of(std::string_view text) {
  constexpr std::string_view kSigns = "()|,";
  std::vector<std::string_view> tokens;
  while (!text.empty()) {
    const std::size_t solid = std::min(text.find_first_not_of(" \t"), text.size());
    const std::size_t dollar = text.find('$', solid);
    std::size_t length = std::min(text.find_first_of(kSigns), text.size());
    if (solid < text.size() && text[solid] == '^' && dollar != std::string_view::npos) {
      length = dollar + 1;
    } else if (solid < text.size() && kSigns.find(text[solid]) != std::string_view::npos) {
      length = solid + 1;
    }
    tokens.push_back(trimmed(text.substr(0, length), kBlanks));
    text.remove_prefix(length);
  }
  return tokens;
}

/// Operands and signs in two stacks, as conda reads them: `,` binds tighter than `|`. Of operands
/// that no sign joins, the first counts.
class ExpressionReader {
 public:
  explicit ExpressionReader(std::string_view text) : text_(text) {}

  Outcome<NodePointer> read() {
    signs_ = {'('};
    for (const std::string_view token : tokens_of(text_)) {
      if (token == "|") {
        if (!join_above("(")) return bad_spec(text_, "`|` has nothing to join");
        signs_.push_back('|');
      } else if (token == ",") {
        if (!join_above("|(")) return bad_spec(text_, "`,` has nothing to join");
        signs_.push_back(',');
      } else if (token == "(") {
        signs_.push_back('(');
      } else if (token == ")") {
        if (!close()) return bad_spec(text_, "the parentheses do not fit");
      } else if (auto operand = leaf(token)) {
        operands_.push_back(std::move(*operand));
      } else {
        return operand;
      }
    }
    if (!close() || !signs_.empty()) return bad_spec(text_, "the parentheses or signs do not fit");
    if (operands_.empty()) return bad_spec(text_, "it names no version");
    return operands_.front();
  }

 private:
  /// Joins operands by the signs on the stack down to one of `weaker`.
  bool join_above(std::string_view weaker) {
    while (!signs_.empty() && weaker.find(signs_.back()) == std::string_view::npos) {
      if (operands_.size() < 2) return false;
      NodePointer right = std::move(operands_.back());
      operands_.pop_back();
      operands_.back() = joined(signs_.back() == '|' ? Kind::kOr : Kind::kAnd,
                                std::move(operands_.back()), std::move(right));
      signs_.pop_back();
    }
    return true;
  }

  /// One flat node for a run of the same sign.
  static NodePointer joined(Kind kind, NodePointer left, NodePointer right) {
    if (left->kind != kind)
      left = std::make_shared<Node>(Node{.kind = kind, .parts = {std::move(left)}});
    left->parts.push_back(std::move(right));
    return left;
  }

  bool close() {
    if (!join_above("(") || signs_.empty()) return false;
    signs_.pop_back();
    return true;
  }

  std::string_view text_;
  std::vector<char> signs_;
  std::vector<NodePointer> operands_;
};

}  // namespace

bool VersionSpec::Node::matches(const Version& candidate) const {
  const auto part_matches = [&candidate](const std::shared_ptr<const Node>& part) {
    return part->matches(candidate);
  };
  switch (kind) {
    case Kind::kAny:
      return true;
    case Kind::kAnd:
      return std::all_of(parts.begin(), parts.end(), part_matches);
    case Kind::kOr:
      return std::any_of(parts.begin(), parts.end(), part_matches);
    case Kind::kEqual:
      return candidate == version;
    case Kind::kNotEqual:
      return candidate != version;
    case Kind::kLess:
      return candidate < version;
    case Kind::kLessEqual:
      return candidate <= version;
    case Kind::kGreater:
      return candidate > version;
    case Kind::kGreaterEqual:
      return candidate >= version;
    case Kind::kStartsWith:
      return candidate.starts_with(version);
    case Kind::kNotStartsWith:
      return !candidate.starts_with(version);
    case Kind::kCompatible:
      return candidate >= version && (!stem || candidate.starts_with(*stem));
    case Kind::kPattern:
      return pattern.matches(candidate.text());
  }
  return false;
}

Outcome<VersionSpec> VersionSpec::parse(std::string_view given) {
  const std::string_view text = trimmed(given, kBlanks);
  if (text.empty()) return bad_spec(given, "it is empty");
  if (text.size() > kLongest) return bad_spec(given, "it is too long");
  auto root = ExpressionReader(text).read();
  if (!root) return std::move(root).errors();
  VersionSpec spec;
  spec.text_ = std::string(text);
  if ((*root)->kind != Kind::kAny) spec.root_ = std::move(*root);
  return spec;
}

bool VersionSpec::matches(const Version& version) const {
  return !root_ || root_->matches(version);
}

}  // namespace ros2wasm
