// A small YAML reader: block structure by indentation, flow collections, plain and quoted scalars.
#include "ros2wasm/yaml.hpp"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <stdexcept>
#include <utility>

namespace ros2wasm {
namespace {

using Kind = YamlNode::Kind;

class Parser {
 public:
  explicit Parser(std::string_view text) : text_(text) {}

  YamlNode parse() {
    skip_blank_lines();
    if (at_end()) {
      return {};
    }
    YamlNode node = parse_block(column());
    skip_blank_lines();
    if (!at_end()) {
      fail("unexpected text after the value");
    }
    return node;
  }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    size_t line = 1;
    for (size_t i = 0; i < at_ && i < text_.size(); ++i) {
      line += text_[i] == '\n' ? 1 : 0;
    }
    throw std::runtime_error("line " + std::to_string(line) + ": " + what);
  }

  [[nodiscard]] bool at_end() const { return at_ >= text_.size(); }
  [[nodiscard]] char peek(size_t ahead = 0) const {
    return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\0';
  }
  [[nodiscard]] bool is_space_at(size_t ahead) const {
    const char c = peek(ahead);
    return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\0';
  }

  [[nodiscard]] size_t column() const {
    const size_t newline = at_ == 0 ? std::string_view::npos : text_.rfind('\n', at_ - 1);
    return newline == std::string_view::npos ? at_ : at_ - newline - 1;
  }

  void skip_spaces() {
    while (peek() == ' ' || peek() == '\t') {
      ++at_;
    }
  }

  void skip_comment() {
    if (peek() == '#') {
      while (!at_end() && peek() != '\n') {
        ++at_;
      }
    }
  }

  // To the first character of the next line that says something.
  void skip_blank_lines() {
    while (!at_end()) {
      skip_spaces();
      skip_comment();
      if (peek() == '\r') {
        ++at_;
      }
      if (peek() == '\n') {
        ++at_;
        continue;
      }
      if (column() == 0 && text_.substr(at_, 3) == "---" && is_space_at(3)) {
        at_ += 3;
        continue;
      }
      return;
    }
  }

  // Skips the rest of a line after a value: spaces and a comment.
  void finish_line() {
    skip_spaces();
    skip_comment();
    if (peek() == '\r') {
      ++at_;
    }
    if (!at_end() && peek() != '\n') {
      fail("unexpected text after the value");
    }
  }

  /// Counts how deep values are nested while it exists.
  class Depth {
   public:
    explicit Depth(Parser& parser) : parser_(parser) {
      constexpr int kMost = 100;
      if (++parser_.depth_ > kMost) {
        parser_.fail("values are nested too deep");
      }
    }
    Depth(const Depth&) = delete;
    Depth& operator=(const Depth&) = delete;
    ~Depth() { --parser_.depth_; }

   private:
    Parser& parser_;
  };

  YamlNode parse_block(size_t indent) {
    const Depth depth(*this);
    if (peek() == '-' && is_space_at(1)) {
      return parse_block_sequence(indent);
    }
    if (is_key_ahead()) {
      return parse_block_map(indent);
    }
    YamlNode node = parse_value();
    finish_line();
    return node;
  }

  // Whether a key and a colon follow on this line.
  bool is_key_ahead() {
    const size_t start = at_;
    bool found = false;
    if (peek() == '"' || peek() == '\'') {
      parse_quoted();
      skip_spaces();
      found = peek() == ':' && is_space_at(1);
    } else if (peek() != '[' && peek() != '{') {
      while (!at_end() && peek() != '\n' && !(peek() == '#' && at_ > start && is_space_before())) {
        if (peek() == ':' && is_space_at(1)) {
          found = true;
          break;
        }
        ++at_;
      }
    }
    at_ = start;
    return found;
  }

  [[nodiscard]] bool is_space_before() const {
    return at_ > 0 && (text_[at_ - 1] == ' ' || text_[at_ - 1] == '\t');
  }

  YamlNode parse_block_sequence(size_t indent) {
    YamlNode node;
    node.kind = Kind::sequence;
    while (!at_end() && column() == indent && peek() == '-' && is_space_at(1)) {
      ++at_;
      skip_spaces();
      node.items.push_back(parse_after_marker(indent));
      skip_blank_lines();
    }
    return node;
  }

  YamlNode parse_block_map(size_t indent) {
    YamlNode node;
    node.kind = Kind::map;
    while (!at_end() && column() == indent && is_key_ahead()) {
      std::string key = peek() == '"' || peek() == '\'' ? parse_quoted() : parse_plain_key();
      skip_spaces();
      ++at_;  // the colon
      skip_spaces();
      node.entries.emplace_back(std::move(key), parse_after_marker(indent, true));
      skip_blank_lines();
      if (!at_end() && column() > indent) {
        fail("wrong indentation");
      }
    }
    return node;
  }

  std::string parse_plain_key() {
    const size_t start = at_;
    while (!(peek() == ':' && is_space_at(1))) {
      ++at_;
    }
    return trim(text_.substr(start, at_ - start));
  }

  // A value on this line, or a deeper block on the next ones, or nothing. A sequence under a key
  // may stand at the key's own column.
  YamlNode parse_after_marker(size_t indent, bool under_key = false) {
    const size_t start = at_;
    skip_comment();
    if (!at_end() && peek() != '\n' && peek() != '\r') {
      at_ = start;
      return under_key ? parse_line_value() : parse_block(column());
    }
    skip_blank_lines();
    const bool deeper = !at_end() && column() > indent;
    const bool list_here =
        !at_end() && under_key && column() == indent && peek() == '-' && is_space_at(1);
    return deeper || list_here ? parse_block(column()) : YamlNode();
  }

  YamlNode parse_line_value() {
    YamlNode node = parse_value();
    finish_line();
    return node;
  }

  YamlNode parse_value(bool in_flow = false) {
    const Depth depth(*this);
    bool is_text = false;
    if (text_.substr(at_, 6) == "!!str ") {
      at_ += 6;
      skip_spaces();
      is_text = true;
    }
    YamlNode node;
    switch (peek()) {
      case '[':
        return parse_flow_sequence();
      case '{':
        return parse_flow_map();
      case '"':
      case '\'':
        node.text = parse_quoted();
        node.is_text = true;
        return node;
      case '&':
      case '*':
      case '!':
      case '|':
      case '>':
        fail(std::string("'") + peek() + "' is not supported in parameter values");
      default:
        node.text = parse_plain(in_flow);
        node.is_text = is_text;
        return node;
    }
  }

  void skip_flow_space() {
    while (!at_end() && (is_space_at(0) || peek() == '#')) {
      if (peek() == '#') {
        skip_comment();
      } else {
        ++at_;
      }
    }
  }

  YamlNode parse_flow_sequence() {
    YamlNode node;
    node.kind = Kind::sequence;
    ++at_;
    skip_flow_space();
    while (peek() != ']') {
      if (at_end()) {
        fail("a list is not closed by ']'");
      }
      node.items.push_back(parse_value(true));
      next_in_flow(']');
    }
    ++at_;
    return node;
  }

  YamlNode parse_flow_map() {
    YamlNode node;
    node.kind = Kind::map;
    ++at_;
    skip_flow_space();
    while (peek() != '}') {
      if (at_end()) {
        fail("a map is not closed by '}'");
      }
      std::string key = peek() == '"' || peek() == '\'' ? parse_quoted() : parse_plain(true);
      skip_flow_space();
      if (peek() != ':') {
        fail("expected ':' after a key");
      }
      ++at_;
      skip_flow_space();
      node.entries.emplace_back(std::move(key), parse_value(true));
      next_in_flow('}');
    }
    ++at_;
    return node;
  }

  void next_in_flow(char closing) {
    skip_flow_space();
    if (peek() == ',') {
      ++at_;
      skip_flow_space();
    } else if (peek() != closing) {
      fail(std::string("expected ',' or '") + closing + "'");
    }
  }

  static std::string trim(std::string_view text) {
    while (!text.empty() && (text.back() == ' ' || text.back() == '\t' || text.back() == '\r')) {
      text.remove_suffix(1);
    }
    return std::string(text);
  }

  std::string parse_plain(bool in_flow) {
    const size_t start = at_;
    while (!at_end() && peek() != '\n') {
      const char c = peek();
      if (c == '#' && is_space_before()) {
        break;
      }
      if (c == ':' && is_space_at(1)) {
        if (!in_flow) {
          fail("a plain value must not hold ': '");
        }
        break;
      }
      if (in_flow && (c == ',' || c == ']' || c == '}' || c == '[' || c == '{')) {
        break;
      }
      ++at_;
    }
    return trim(text_.substr(start, at_ - start));
  }

  std::string parse_quoted() {
    const char quote = peek();
    ++at_;
    std::string value;
    while (true) {
      if (at_end()) {
        fail("a quoted text is not closed");
      }
      const char c = peek();
      if (c == quote) {
        if (quote == '\'' && peek(1) == '\'') {
          value += '\'';
          at_ += 2;
          continue;
        }
        ++at_;
        return value;
      }
      if (quote == '"' && c == '\\') {
        ++at_;
        if (peek() == '\n') {  // the text goes on in the next line
          ++at_;
          skip_spaces();
        } else {
          value += unescape();
        }
        continue;
      }
      value += c;
      ++at_;
    }
  }

  /// The text that the escape after the backslash means; steps over the escape.
  std::string unescape() {
    static constexpr std::pair<char, char> kOne[] = {
        {'n', '\n'},  {'t', '\t'}, {'r', '\r'}, {'0', '\0'},   {'a', '\a'},
        {'b', '\b'},  {'f', '\f'}, {'v', '\v'}, {'e', '\x1b'}, {'"', '"'},
        {'\\', '\\'}, {'/', '/'},  {' ', ' '}};
    const char c = peek();
    for (const auto& [key, meant] : kOne) {
      if (c == key) {
        ++at_;
        return std::string(1, meant);
      }
    }
    const size_t digits = c == 'x' ? 2 : c == 'u' ? 4 : c == 'U' ? 8 : 0;
    const std::string code(text_.substr(std::min(at_ + 1, text_.size()), digits));
    if (digits == 0 || code.size() != digits ||
        code.find_first_not_of("0123456789abcdefABCDEF") != std::string::npos) {
      fail(std::string("unknown escape '\\") + c + "'");
    }
    at_ += 1 + digits;
    return utf8(std::stoul(code, nullptr, 16));
  }

  std::string utf8(unsigned long code) const {
    if (code > 0x10FFFF || (code >= 0xD800 && code < 0xE000)) {
      fail("an escape stands for no character");
    }
    if (code < 0x80) {
      return std::string(1, static_cast<char>(code));
    }
    std::string result;
    int more = code < 0x800 ? 1 : code < 0x10000 ? 2 : 3;
    result += static_cast<char>((0xF00 >> (more + 1) & 0xFF) | code >> 6 * more);
    while (more-- > 0) {
      result += static_cast<char>(0x80 | (code >> 6 * more & 0x3F));
    }
    return result;
  }

  std::string_view text_;
  size_t at_ = 0;
  int depth_ = 0;
};

// Whether `text` is one of the words, which stand between spaces.
bool is_any_of(const std::string& text, const char* words) {
  const std::string_view all(words);
  const size_t at = text.empty() ? std::string_view::npos : all.find(" " + text + " ");
  return at != std::string_view::npos && text.find(' ') == std::string::npos;
}

bool to_integer(const std::string& text, int64_t& value) {
  char* end = nullptr;
  errno = 0;
  value = std::strtoll(text.c_str(), &end, 0);
  return errno == 0 && end != text.c_str() && *end == '\0';
}

bool to_double(const std::string& text, double& value) {
  if (is_any_of(text, " .nan .NaN .NAN ")) {
    value = std::numeric_limits<double>::quiet_NaN();
    return true;
  }
  if (is_any_of(text, " .inf .Inf .INF +.inf +.Inf +.INF ")) {
    value = std::numeric_limits<double>::infinity();
    return true;
  }
  if (is_any_of(text, " -.inf -.Inf -.INF ")) {
    value = -std::numeric_limits<double>::infinity();
    return true;
  }
  // strtod also knows words; a number starts like one.
  const size_t start = text[0] == '+' || text[0] == '-' ? 1 : 0;
  if (start >= text.size() || (text[start] != '.' && (text[start] < '0' || text[start] > '9'))) {
    return false;
  }
  char* end = nullptr;
  value = std::strtod(text.c_str(), &end);
  return end != text.c_str() && *end == '\0';
}

ParameterScalar to_scalar(const YamlNode& node) {
  if (node.kind != Kind::scalar) {
    throw std::runtime_error("a list must hold plain values only");
  }
  const std::string& text = node.text;
  if (node.is_text) {
    return text;
  }
  if (text.empty() || is_any_of(text, " ~ null Null NULL ")) {
    return std::monostate();
  }
  if (is_any_of(text, " Y y yes Yes YES true True TRUE on On ON ")) {
    return true;
  }
  if (is_any_of(text, " N n no No NO false False FALSE off Off OFF ")) {
    return false;
  }
  int64_t integer = 0;
  if (to_integer(text, integer)) {
    return integer;
  }
  double number = 0;
  if (to_double(text, number)) {
    return number;
  }
  return text;
}

template <typename T>
bool collect(const std::vector<ParameterScalar>& scalars, ParameterData& out) {
  std::vector<T> values;
  for (const ParameterScalar& scalar : scalars) {
    if (const T* value = std::get_if<T>(&scalar)) {
      values.push_back(*value);
    } else if constexpr (std::is_same_v<T, double>) {
      const int64_t* integer = std::get_if<int64_t>(&scalar);
      if (integer == nullptr) {
        return false;
      }
      values.push_back(static_cast<double>(*integer));
    } else {
      return false;
    }
  }
  out = std::move(values);
  return true;
}

}  // namespace

YamlNode parse_yaml(std::string_view text) {
  return Parser(text).parse();
}

ParameterData to_parameter(const YamlNode& node) {
  if (node.kind == Kind::map) {
    throw std::runtime_error("a map is not a parameter value");
  }
  ParameterData data;
  if (node.kind == Kind::scalar) {
    std::visit([&data](auto&& value) { data = std::forward<decltype(value)>(value); },
               to_scalar(node));
    return data;
  }
  std::vector<ParameterScalar> scalars;
  for (const YamlNode& item : node.items) {
    scalars.push_back(to_scalar(item));
  }
  if (scalars.empty()) {
    throw std::runtime_error("an empty list has no type");
  }
  if (collect<bool>(scalars, data) || collect<int64_t>(scalars, data) ||
      collect<double>(scalars, data) || collect<std::string>(scalars, data)) {
    return data;
  }
  throw std::runtime_error("a list must hold values of one type");
}

}  // namespace ros2wasm
