// See wheel_requirement.hpp.
#include "workspace_schema/conda/wheel_requirement.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include "workspace_schema/conda/version_spec.hpp"
#include "workspace_schema/conda/wheel_name.hpp"

namespace ros2wasm {
namespace {

constexpr int kDeepestMarker = 32;
constexpr std::string_view kNameLetters =
    "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789._-";
constexpr std::string_view kBlanks = " \t";

struct MarkerVariable {
  std::string_view name;
  std::string_view value;
};

/// The values of Pyodide. `extra` is empty: no request has extras.
constexpr auto kVariables = std::to_array<MarkerVariable>({
    {"extra", ""},
    {"implementation_name", "cpython"},
    {"implementation_version", kSitePython},
    {"os_name", "posix"},
    {"platform_machine", "wasm32"},
    {"platform_python_implementation", "CPython"},
    {"platform_system", "Emscripten"},
    {"python_full_version", kSitePython},
    {"python_version", "3.12"},
    {"sys_platform", "emscripten"},
});

std::string_view trimmed(std::string_view text) {
  const std::size_t start = text.find_first_not_of(kBlanks);
  if (start == std::string_view::npos) return {};
  return text.substr(start, text.find_last_not_of(kBlanks) - start + 1);
}

/// An expression over the variables, read from left to right.
class Marker {
 public:
  explicit Marker(std::string_view text) : text_(text) {}

  bool applies() {
    const bool result = any();
    skip();
    return failed_ || at_ != text_.size() || result;
  }

 private:
  struct Value {
    std::string_view text;
    bool is_version = false;
  };

  void skip() { at_ = std::min(text_.find_first_not_of(kBlanks, at_), text_.size()); }

  bool take(std::string_view token) {
    skip();
    if (!text_.substr(at_).starts_with(token)) return false;
    at_ += token.size();
    return true;
  }

  bool any() {
    bool result = all();
    while (!failed_ && take("or ")) result = all() || result;
    return result;
  }

  bool all() {
    bool result = one();
    while (!failed_ && take("and ")) result = one() && result;
    return result;
  }

  bool one() {
    if (depth_ >= kDeepestMarker) return fail();
    if (take("(")) {
      ++depth_;
      const bool result = any();
      --depth_;
      return take(")") ? result : fail();
    }
    const Value left = value();
    constexpr std::array<std::string_view, 10> kOperators = {
        "===", "==", "!=", "<=", ">=", "~=", "<", ">", "not in ", "in "};
    const auto sign = std::find_if(kOperators.begin(), kOperators.end(),
                                   [&](std::string_view token) { return take(token); });
    if (failed_ || sign == kOperators.end()) return fail();
    const Value right = value();
    return !failed_ && holds(left, *sign, right);
  }

  Value value() {
    skip();
    if (at_ < text_.size() && (text_[at_] == '"' || text_[at_] == '\'')) {
      const std::size_t end = text_.find(text_[at_], at_ + 1);
      if (end == std::string_view::npos) return fail(), Value{};
      const std::string_view found = text_.substr(at_ + 1, end - at_ - 1);
      at_ = end + 1;
      return {found};
    }
    const std::size_t end = std::min(text_.find_first_not_of(kNameLetters, at_), text_.size());
    const std::string_view name = text_.substr(at_, end - at_);
    at_ = end;
    const auto row = std::find_if(kVariables.begin(), kVariables.end(),
                                  [&](const MarkerVariable& one) { return one.name == name; });
    if (row == kVariables.end()) return fail(), Value{};
    return {row->value, name.ends_with("version")};
  }

  static bool holds(const Value& left, std::string_view sign, const Value& right) {
    if (sign == "in ") return right.text.find(left.text) != std::string_view::npos;
    if (sign == "not in ") return right.text.find(left.text) == std::string_view::npos;
    if (left.is_version)
      return fits_versions(left.text, std::string(sign) + std::string(right.text));
    if (right.is_version) return true;  // nobody writes it so
    if (sign == "!=") return left.text != right.text;
    if (sign == "==" || sign == "===") return left.text == right.text;
    return true;
  }

  bool fail() {
    failed_ = true;
    return true;
  }

  std::string_view text_;
  std::size_t at_ = 0;
  int depth_ = 0;
  bool failed_ = false;
};

}  // namespace

std::optional<WheelRequirement> wheel_requirement(std::string_view text) {
  const std::size_t semicolon = text.find(';');
  const std::string_view marker =
      semicolon == std::string_view::npos ? "" : trimmed(text.substr(semicolon + 1));
  std::string_view rest = trimmed(text.substr(0, semicolon));
  const std::size_t end = std::min(rest.find_first_not_of(kNameLetters), rest.size());
  if (end == 0) return std::nullopt;
  WheelRequirement result{.project = normal_project_name(rest.substr(0, end)),
                          .versions = {},
                          .applies = marker.empty() || Marker(marker).applies()};
  rest = trimmed(rest.substr(end));
  if (rest.starts_with('[')) {  // extras of the other project
    const std::size_t close = rest.find(']');
    if (close == std::string_view::npos) return std::nullopt;
    rest = trimmed(rest.substr(close + 1));
  }
  if (rest.starts_with('@')) return result;  // an address says nothing of versions
  if (rest.starts_with('(') && rest.ends_with(')')) rest = rest.substr(1, rest.size() - 2);
  for (const char c : rest) {
    if (kBlanks.find(c) == std::string_view::npos) result.versions += c;
  }
  return result;
}

bool fits_versions(std::string_view version, std::string_view versions) {
  if (versions.empty()) return true;
  const auto spec = VersionSpec::parse(versions);
  const auto given = Version::parse(version);
  return !spec || !given || spec->matches(*given);
}

}  // namespace ros2wasm
