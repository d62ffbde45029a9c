// See xacro_evaluator.hpp: texts, properties and their values.
#include "bundler/launch/xacro/xacro_evaluator.hpp"

#include <algorithm>
#include <string_view>

namespace ros2wasm {
namespace {

constexpr std::int64_t kMostSteps = 5'000'000;
constexpr int kDeepestValue = 50;
constexpr std::size_t kLongestQuote = 200;

[[noreturn]] void fail(std::string message) {
  throw XacroFault{.message = std::move(message)};
}

/// One piece of a text, from its begin.
struct Piece {
  enum class Kind { kText, kExpression, kSubstitution };
  Kind kind = Kind::kText;
  std::string_view text;  ///< without what marks it
  std::size_t size = 0;
};

bool opens(std::string_view text, std::size_t at) {
  return at < text.size() && (text[at] == '{' || text[at] == '(');
}

Piece plain(std::string_view text) {
  return {.text = text, .size = text.size()};
}

Piece next_piece(std::string_view rest) {
  if (rest.front() != '$') return plain(rest.substr(0, rest.find('$')));
  const std::size_t dollars = std::min(rest.find_first_not_of('$'), rest.size());
  if (dollars > 1 && opens(rest, dollars))
    return {.text = rest.substr(1, dollars), .size = dollars + 1};
  if (dollars == 1 && opens(rest, 1)) {
    const std::size_t end = rest.find(rest[1] == '{' ? '}' : ')');
    if (end == std::string_view::npos)
      fail("`" + std::string(rest.substr(0, 40)) + "` is not closed");
    return {.kind = rest[1] == '{' ? Piece::Kind::kExpression : Piece::Kind::kSubstitution,
            .text = rest.substr(2, end - 2),
            .size = end + 1};
  }
  if (dollars > 1 && dollars < rest.size())
    fail("`" + std::string(rest.substr(0, 40)) +
         "`: `$$` can only stand for `$` before `{` and `(`");
  return plain(rest.substr(0, std::min(rest.find_first_of("{($", 1), rest.size())));
}

/// Texts in single quotes, numbers and booleans.
PythonValue literal(PythonValue value) {
  const auto* text = std::get_if<std::string>(&value.held);
  if (text == nullptr) return value;
  if (text->size() >= 2 && text->front() == '\'' && text->back() == '\'')
    return {text->substr(1, text->size() - 2)};
  if (text->find('_') != std::string::npos) return value;
  for (PythonValue (*read)(const PythonValue&) : {python_to_integer, python_to_float}) {
    try {
      const bool all_digits =
          read == python_to_float && text->find_first_not_of("0123456789 ") == std::string::npos;
      if (!all_digits) return read(value);
    } catch (const PythonFault&) {
      continue;
    }
  }
  if (*text == "true" || *text == "True") return {true};
  if (*text == "false" || *text == "False") return {false};
  return value;
}

using Definition = std::pair<const XacroSymbols*, std::string>;

class Resolving {
 public:
  Resolving(std::vector<Definition>& all, const Definition& one) : all_(all) {
    all_.push_back(one);
  }
  ~Resolving() { all_.pop_back(); }
  Resolving(const Resolving&) = delete;
  Resolving& operator=(const Resolving&) = delete;

 private:
  std::vector<Definition>& all_;
};

}  // namespace

XacroEvaluator::XacroEvaluator(const XacroRequest& request, const LaunchWorld& world)
    : arguments(request.arguments), request_(request), world_(world) {
  limits_.steps_left = kMostSteps;
  add_functions();
}

void XacroEvaluator::spend(std::size_t steps) {
  limits_.steps_left -= static_cast<std::int64_t>(steps);
  if (limits_.steps_left < 0) fail("the expansion is too much work");
}

PythonValue XacroEvaluator::value(const std::string& written, XacroSymbols& symbols) {
  spend(1 + written.size() / 16);
  std::string joined;
  std::size_t count = 0;
  for (std::string_view rest = written; !rest.empty();) {
    const Piece piece = next_piece(rest);
    rest.remove_prefix(piece.size);
    const std::string inner(piece.text);
    PythonValue one{PythonNone{}};
    switch (piece.kind) {
      case Piece::Kind::kText:
        one = {inner};
        break;
      case Piece::Kind::kExpression:
        one = expression(inner, symbols);
        break;
      case Piece::Kind::kSubstitution:
        one = {substituted(text(inner, symbols))};
        break;
    }
    if (++count == 1 && rest.empty()) return one;
    joined += python_text(one);
  }
  spend(joined.size() / 16);
  return {std::move(joined)};
}

std::string XacroEvaluator::text(const std::string& written, XacroSymbols& symbols) {
  if (written.find('$') == std::string::npos) return written;
  return python_text(value(written, symbols));
}

PythonValue XacroEvaluator::expression(const std::string& written, XacroSymbols& symbols) {
  try {
    const auto name = [&](const std::string& one) { return find(one, symbols); };
    return python_evaluated(text(written, symbols), {.name = name, .limits = &limits_});
  } catch (const PythonFault& fault) {
    throw XacroFault{.message = fault.message,
                     .why = {"the expression is: " + written.substr(0, kLongestQuote)}};
  }
}

bool XacroEvaluator::condition(const PythonValue& value, const std::string& written) {
  const auto* text = std::get_if<std::string>(&value.held);
  if (text == nullptr) return truth(value);
  if (*text == "true" || *text == "True") return true;
  if (*text == "false" || *text == "False") return false;
  try {
    return truth(python_to_integer(value));
  } catch (const PythonFault&) {
    fail("`" + written.substr(0, kLongestQuote) + "` is not a condition: it comes to `" +
         text->substr(0, kLongestQuote) + "`, which is neither true nor false");
  }
}

void XacroEvaluator::set(XacroSymbols& table, const std::string& name, PythonValue value,
                         bool lazily) {
  XacroSymbol symbol{.value = literal(std::move(value))};
  symbol.unevaluated = lazily && std::holds_alternative<std::string>(symbol.value.held);
  if (python_nests_deeper(symbol.value, kDeepestValue))
    fail("the value of `" + name + "` is too deep");
  table.own[name] = std::move(symbol);
}

std::optional<PythonValue> XacroEvaluator::find(const std::string& name, XacroSymbols& symbols) {
  for (XacroSymbols* table = &symbols; table != nullptr; table = table->parent) {
    const auto found = table->own.find(name);
    if (found != table->own.end()) return resolved(name, found->second, *table);
  }
  return global(name);
}

PythonValue XacroEvaluator::resolved(const std::string& name, XacroSymbol& symbol,
                                     XacroSymbols& table) {
  if (symbol.space) {
    const std::weak_ptr<XacroSymbols> space = symbol.space;
    const auto attribute = [this, space](const std::string& one) -> std::optional<PythonValue> {
      const auto open = space.lock();
      return open ? find(one, *open) : std::nullopt;
    };
    return {std::make_shared<const PythonNamespace>(PythonNamespace{name, attribute})};
  }
  if (!symbol.unevaluated) return symbol.value;
  const Definition here(&table, name);
  const auto again = std::find(resolving_.begin(), resolving_.end(), here);
  if (again != resolving_.end()) {
    std::string circle;
    for (auto one = again; one != resolving_.end(); ++one) circle += one->second + " -> ";
    throw XacroFault{.message = "the property `" + name + "` is defined by itself",
                     .why = {"by way of: " + circle + name,
                             "lazy_eval=\"false\" evaluates a property in place"}};
  }
  const Resolving open(resolving_, here);
  symbol.value = literal(value(std::get<std::string>(symbol.value.held), table));
  symbol.unevaluated = false;
  return symbol.value;
}

std::string XacroEvaluator::absolute(const std::string& path) const {
  if (path.starts_with('/')) return path;
  const std::string& from = files.back();
  return from.substr(0, from.rfind('/') + 1) + path;
}

std::string XacroEvaluator::read(const std::string& path) {
  auto text = world_.read(path);
  if (!text)
    throw XacroFault{.message = "`" + xacro_shown(path, world_) + "` cannot be read",
                     .why = text.errors().front().why,
                     .no_file = true};
  spend(1 + text->size() / 16);
  return std::move(*text);
}

std::string xacro_shown(const std::string& path, const LaunchWorld& world) {
  return world.shown ? world.shown(path) : path;
}

}  // namespace ros2wasm
