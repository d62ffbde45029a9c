// See xacro_symbols.hpp.
#include "bundler/launch/xacro/xacro_symbols.hpp"

#include <string_view>

namespace ros2wasm {
namespace {

constexpr std::string_view kSpace = " \t\n\r";

bool is_space(char c) {
  return kSpace.find(c) != std::string_view::npos;
}

class ParameterReader {
 public:
  explicit ParameterReader(std::string_view text) : text_(text) {}

  std::vector<XacroParameter> all() {
    std::vector<XacroParameter> result;
    for (skip(); at_ < text_.size(); skip()) result.push_back(one());
    return result;
  }

 private:
  void skip() {
    while (at_ < text_.size() && is_space(text_[at_])) ++at_;
  }
  bool take(std::string_view wanted) {
    if (!text_.substr(at_).starts_with(wanted)) return false;
    at_ += wanted.size();
    return true;
  }

  XacroParameter one() {
    XacroParameter result;
    while (at_ < text_.size() && !is_space(text_[at_]) && text_[at_] != ':' && text_[at_] != '=')
      result.name += text_[at_++];
    const std::size_t behind = at_;
    skip();
    if (!take(":=") && !take("=")) {
      at_ = behind;
      if (result.name.empty() || (at_ < text_.size() && !is_space(text_[at_])))
        throw XacroFault{.message = "`" + std::string(text_.substr(at_, 40)) +
                                    "` is not a parameter of a macro"};
      return result;
    }
    skip();
    result.forward = take("^|") || take("^");
    if (std::string text = value(); !text.empty()) result.otherwise = std::move(text);
    return result;
  }

  /// An expression, a substitution, or text up to white space outside of quotes.
  std::string value() {
    const std::size_t begin = at_;
    for (const auto& [open, close] : {std::pair("${", '}'), std::pair("$(", ')')}) {
      if (!text_.substr(at_).starts_with(open)) continue;
      const std::size_t end = text_.find(close, at_);
      if (end == std::string_view::npos || (end + 1 < text_.size() && !is_space(text_[end + 1])))
        break;
      at_ = end + 1;
      return std::string(text_.substr(begin, at_ - begin));
    }
    while (at_ < text_.size() && !is_space(text_[at_])) {
      const char c = text_[at_];
      const std::size_t end =
          c == '\'' || c == '"' ? text_.find(c, at_ + 1) : std::string_view::npos;
      at_ = end == std::string_view::npos ? at_ + 1 : end + 1;
    }
    return std::string(text_.substr(begin, at_ - begin));
  }

  std::string_view text_;
  std::size_t at_ = 0;
};

}  // namespace

XacroSymbol* XacroSymbols::find(const std::string& name) {
  for (XacroSymbols* table = this; table != nullptr; table = table->parent) {
    const auto found = table->own.find(name);
    if (found != table->own.end()) return &found->second;
  }
  return nullptr;
}

std::shared_ptr<const XacroMacro> XacroMacros::find(const std::string& name) const {
  for (const XacroMacros* table = this; table != nullptr; table = table->parent) {
    const auto found = table->own.find(name);
    if (found != table->own.end()) return found->second;
  }
  return nullptr;
}

std::shared_ptr<XacroMacros> XacroMacros::space(const std::string& name) const {
  for (const XacroMacros* table = this; table != nullptr; table = table->parent) {
    const auto found = table->spaces.find(name);
    if (found != table->spaces.end()) return found->second;
  }
  return nullptr;
}

std::vector<XacroParameter> xacro_parameters(const std::string& written) {
  return ParameterReader(written).all();
}

}  // namespace ros2wasm
