// Reads a filter expression once, then looks into messages as they lie on the wire: only the fields
// that are compared are read.
#include "rclcpp/detail/content_filter.hpp"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <stdexcept>
#include <utility>

#include "ros2wasm_typesupport/cdr.hpp"
#include "type_description_interfaces/msg/field_type.hpp"

namespace rclcpp {
namespace detail {
namespace {

using ros2wasm_typesupport::CdrReader;
using ros2wasm_typesupport::FieldInfo;
using ros2wasm_typesupport::TypeInfo;
using Type = type_description_interfaces::msg::FieldType;
using Value = ContentFilter::Value;
using Operand = ContentFilter::Operand;
using Operator = ContentFilter::Operator;
using Node = ContentFilter::Node;
using Kind = ContentFilter::Value::Kind;
using Truth = ContentFilter::Truth;

constexpr uint8_t kArray = Type::FIELD_TYPE_INT8_ARRAY - Type::FIELD_TYPE_INT8;
constexpr uint8_t kBoundedSequence = Type::FIELD_TYPE_INT8_BOUNDED_SEQUENCE - Type::FIELD_TYPE_INT8;
constexpr size_t kMostParameters = 100;

// --- types and the wire
// ---------------------------------------------------------------------------

uint8_t element_type(const FieldInfo& field) {
  return static_cast<uint8_t>((field.type_id - 1) % kArray + 1);
}

bool has_elements(const FieldInfo& field) {
  return field.type_id > kArray;
}

bool is_text(uint8_t type) {
  return type == Type::FIELD_TYPE_STRING || type == Type::FIELD_TYPE_BOUNDED_STRING;
}

bool is_wide_text(uint8_t type) {
  return type == Type::FIELD_TYPE_WSTRING || type == Type::FIELD_TYPE_BOUNDED_WSTRING;
}

/// Bytes of a number; 0 for what is none.
size_t number_size(uint8_t type) {
  switch (type) {
    case Type::FIELD_TYPE_INT8:
    case Type::FIELD_TYPE_UINT8:
    case Type::FIELD_TYPE_CHAR:
    case Type::FIELD_TYPE_BOOLEAN:
    case Type::FIELD_TYPE_BYTE:
      return 1;
    case Type::FIELD_TYPE_INT16:
    case Type::FIELD_TYPE_UINT16:
      return 2;
    case Type::FIELD_TYPE_INT32:
    case Type::FIELD_TYPE_UINT32:
    case Type::FIELD_TYPE_FLOAT:
      return 4;
    case Type::FIELD_TYPE_INT64:
    case Type::FIELD_TYPE_UINT64:
    case Type::FIELD_TYPE_DOUBLE:
      return 8;
    default:
      return 0;
  }
}

Kind kind_of(uint8_t type) {
  if (is_text(type)) {
    return Kind::text;
  }
  if (type == Type::FIELD_TYPE_FLOAT || type == Type::FIELD_TYPE_DOUBLE) {
    return Kind::real;
  }
  return number_size(type) == 0 ? Kind::none : Kind::integer;
}

/// How many elements a field has: one when it is not an array and no sequence.
size_t count_elements(CdrReader& reader, const FieldInfo& field) {
  if (!has_elements(field)) {
    return 1;
  }
  if (field.type_id <= kBoundedSequence) {
    return field.capacity;
  }
  const size_t number = number_size(element_type(field));
  return reader.get_count(0, number == 0 ? 1 : number);
}

void skip(CdrReader& reader, const FieldInfo& field, size_t elements) {
  const uint8_t type = element_type(field);
  if (const size_t number = number_size(type)) {
    if (elements != 0) {
      reader.take(elements * number, number);
    }
    return;
  }
  for (size_t i = 0; i < elements && reader.ok(); ++i) {
    if (field.nested != nullptr) {
      for (size_t at = 0; at < field.nested->field_count; ++at) {
        const FieldInfo& inner = field.nested->fields[at];
        skip(reader, inner, count_elements(reader, inner));
      }
    } else {
      const size_t unit = is_wide_text(type) ? 4 : 1;
      reader.take(reader.get_count(0, unit) * unit, 1);
    }
  }
}

template <typename T>
T read(CdrReader& reader) {
  T value{};
  reader.get(value);
  return value;
}

Value integer(int64_t value) {
  Value result;
  result.kind = Kind::integer;
  result.negative = value < 0;
  result.magnitude = value < 0 ? 0 - static_cast<uint64_t>(value) : static_cast<uint64_t>(value);
  return result;
}

Value natural(uint64_t value) {
  Value result;
  result.kind = Kind::integer;
  result.magnitude = value;
  return result;
}

Value real(double value) {
  Value result;
  result.kind = Kind::real;
  result.real = value;
  return result;
}

Value text(std::string value) {
  Value result;
  result.kind = Kind::text;
  result.text = std::move(value);
  return result;
}

Value read_value(CdrReader& reader, uint8_t type) {
  switch (type) {
    case Type::FIELD_TYPE_INT8:
      return integer(read<int8_t>(reader));
    case Type::FIELD_TYPE_INT16:
      return integer(read<int16_t>(reader));
    case Type::FIELD_TYPE_UINT16:
      return natural(read<uint16_t>(reader));
    case Type::FIELD_TYPE_INT32:
      return integer(read<int32_t>(reader));
    case Type::FIELD_TYPE_UINT32:
      return natural(read<uint32_t>(reader));
    case Type::FIELD_TYPE_INT64:
      return integer(read<int64_t>(reader));
    case Type::FIELD_TYPE_UINT64:
      return natural(read<uint64_t>(reader));
    case Type::FIELD_TYPE_FLOAT:
      return real(read<float>(reader));
    case Type::FIELD_TYPE_DOUBLE:
      return real(read<double>(reader));
    case Type::FIELD_TYPE_BOOLEAN:
      return natural(read<bool>(reader) ? 1 : 0);
    case Type::FIELD_TYPE_STRING:
    case Type::FIELD_TYPE_BOUNDED_STRING: {
      const size_t count = reader.get_count(0, 1);
      const auto* bytes = reinterpret_cast<const char*>(reader.take(count, 1));
      return bytes == nullptr || count == 0 ? text({}) : text({bytes, count - 1});
    }
    default:
      return natural(read<uint8_t>(reader));
  }
}

// --- comparing
// ------------------------------------------------------------------------------------

double as_real(const Value& value) {
  if (value.kind == Kind::real) {
    return value.real;
  }
  const auto magnitude = static_cast<double>(value.magnitude);
  return value.negative ? -magnitude : magnitude;
}

bool less(const Value& a, const Value& b) {
  if (a.kind == Kind::text) {
    return a.text < b.text;
  }
  if (a.kind == Kind::real || b.kind == Kind::real) {
    return as_real(a) < as_real(b);
  }
  if (a.negative != b.negative) {
    return a.negative;
  }
  return a.negative ? a.magnitude > b.magnitude : a.magnitude < b.magnitude;
}

bool equal(const Value& a, const Value& b) {
  if (a.kind == Kind::text) {
    return a.text == b.text;
  }
  if (a.kind == Kind::real || b.kind == Kind::real) {
    return as_real(a) == as_real(b);
  }
  return a.negative == b.negative && a.magnitude == b.magnitude;
}

/// `%` and `*` stand for any text, `_` and `?` for one character.
bool like(const char* value, const char* pattern) {
  const char* after_any = nullptr;
  const char* retried = nullptr;
  while (*value != '\0') {
    if (*pattern == '%' || *pattern == '*') {
      after_any = ++pattern;
      retried = value;
    } else if (*pattern == '_' || *pattern == '?' || *pattern == *value) {
      ++pattern;
      ++value;
    } else if (after_any != nullptr) {
      pattern = after_any;
      value = ++retried;
    } else {
      return false;
    }
  }
  while (*pattern == '%' || *pattern == '*') {
    ++pattern;
  }
  return *pattern == '\0';
}

Truth compare(Operator op, const Value& a, const Value& b) {
  if (a.kind == Kind::none || b.kind == Kind::none) {
    return std::nullopt;
  }
  switch (op) {
    case Operator::equal:
      return equal(a, b);
    case Operator::unequal:
      return !equal(a, b);
    case Operator::less:
      return less(a, b);
    case Operator::at_most:
      return less(a, b) || equal(a, b);
    case Operator::greater:
      return less(b, a);
    case Operator::at_least:
      return less(b, a) || equal(a, b);
    case Operator::like:
      return like(a.text.c_str(), b.text.c_str());
    case Operator::both:
    case Operator::either:
    case Operator::negated:
      break;
  }
  return std::nullopt;
}

// --- reading the expression
// -----------------------------------------------------------------------

/// Cuts a text into words; knows where it stands for what it complains of.
class Words {
 public:
  explicit Words(const std::string& text) : text_(text) { next(); }

  [[nodiscard]] const std::string& word() const { return word_; }
  [[nodiscard]] bool at_end() const { return word_.empty(); }

  void next() {
    while (std::isspace(at(end_)) != 0) {
      ++end_;
    }
    begin_ = end_;
    const int first = at(end_);
    if (first == '\'' || first == '`') {
      do {
        ++end_;
      } while (at(end_) != '\'' && at(end_) != 0);
      if (at(end_) == 0) {
        fail("a text has no end");
      }
      ++end_;
    } else if (is_part(first) || first == '%') {
      do {
        ++end_;
      } while (is_part(at(end_)));
    } else if (first != 0) {
      ++end_;
      if ((first == '<' || first == '>' || first == '!') &&
          (at(end_) == '=' || (first == '<' && at(end_) == '>'))) {
        ++end_;
      }
    }
    word_ = text_.substr(begin_, end_ - begin_);
  }

  /// Takes the word when it is this one, in whatever case.
  bool take(const char* wanted) {
    size_t i = 0;
    while (i < word_.size() && wanted[i] == std::toupper(static_cast<unsigned char>(word_[i]))) {
      ++i;
    }
    if (word_.empty() || i < word_.size() || wanted[i] != '\0') {
      return false;
    }
    next();
    return true;
  }

  [[noreturn]] void fail(const std::string& what) const {
    throw std::invalid_argument("content filter \"" + text_ + "\": " + what + " at position " +
                                std::to_string(begin_));
  }

 private:
  [[nodiscard]] int at(size_t place) const {
    return place < text_.size() ? static_cast<unsigned char>(text_[place]) : 0;
  }
  static bool is_part(int character) {
    return std::isalnum(character) != 0 || character == '_' || character == '.' ||
           character == '[' || character == ']' || character == '+' || character == '-';
  }

  const std::string& text_;
  std::string word_;
  size_t begin_ = 0;
  size_t end_ = 0;
};

/// `'text'`, `-7`, `2.5`, `TRUE`; none for another word.
Value literal_of(const std::string& word) {
  const char first = word.empty() ? '\0' : word.front();
  if (first == '\'' || first == '`') {
    return word.size() > 1 && word.back() == '\'' ? text(word.substr(1, word.size() - 2)) : Value{};
  }
  if (word == "TRUE" || word == "true" || word == "FALSE" || word == "false") {
    return natural(std::toupper(static_cast<unsigned char>(first)) == 'T' ? 1 : 0);
  }
  if (std::isdigit(static_cast<unsigned char>(first)) == 0 && first != '-' && first != '+' &&
      first != '.') {
    return {};
  }
  char* end = nullptr;
  const int base = word.find_first_of("xX") == std::string::npos ? 10 : 16;
  const bool whole = base == 16 || word.find_first_of(".eE") == std::string::npos;
  Value result;
  if (!whole) {
    result = real(std::strtod(word.c_str(), &end));
  } else if (first == '-') {
    result = integer(std::strtoll(word.c_str(), &end, base));
  } else {
    result = natural(std::strtoull(word.c_str(), &end, base));
  }
  return *end == '\0' && end != word.c_str() ? result : Value{};
}

class Parser {
 public:
  Parser(const TypeInfo& type, const ContentFilterOptions& options)
      : type_(type),
        parameters_(options.expression_parameters),
        words_(options.filter_expression) {}

  std::vector<Node> parse() {
    any_of();
    if (!words_.at_end()) {
      words_.fail("AND or OR is missing");
    }
    return std::move(nodes_);
  }

 private:
  size_t add(Operator op, size_t left, size_t right) {
    Node node;
    node.op = op;
    node.left = left;
    node.right = right;
    nodes_.push_back(std::move(node));
    return nodes_.size() - 1;
  }

  size_t add(Operator op, Operand first, Operand second) {
    const bool texts = first.literal.kind == Kind::text;
    if (texts != (second.literal.kind == Kind::text) || (op == Operator::like && !texts)) {
      words_.fail("a text and a number cannot be compared, before");
    }
    Node node;
    node.op = op;
    node.first = std::move(first);
    node.second = std::move(second);
    nodes_.push_back(std::move(node));
    return nodes_.size() - 1;
  }

  size_t any_of() {
    size_t left = all_of();
    while (words_.take("OR")) {
      left = add(Operator::either, left, all_of());
    }
    return left;
  }

  size_t all_of() {
    size_t left = one();
    while (words_.take("AND")) {
      left = add(Operator::both, left, one());
    }
    return left;
  }

  size_t one() {
    if (words_.take("NOT")) {
      const size_t inner = one();
      return add(Operator::negated, inner, inner);
    }
    if (words_.take("(")) {
      const size_t inner = any_of();
      if (!words_.take(")")) {
        words_.fail("a closing parenthesis is missing");
      }
      return inner;
    }
    Operand first = operand();
    const bool outside = words_.take("NOT");
    if (words_.take("BETWEEN")) {
      const size_t low = add(Operator::at_least, first, operand());
      if (!words_.take("AND")) {
        words_.fail("the AND of BETWEEN is missing");
      }
      const size_t within = add(Operator::both, low, add(Operator::at_most, first, operand()));
      return outside ? add(Operator::negated, within, within) : within;
    }
    if (outside) {
      words_.fail("BETWEEN is missing");
    }
    const Operator op = comparison();
    return add(op, std::move(first), operand());
  }

  Operator comparison() {
    static constexpr std::pair<const char*, Operator> kOperators[] = {
        {"=", Operator::equal},     {"<>", Operator::unequal}, {"!=", Operator::unequal},
        {"<", Operator::less},      {"<=", Operator::at_most}, {">", Operator::greater},
        {">=", Operator::at_least}, {"LIKE", Operator::like},
    };
    for (const auto& [word, op] : kOperators) {
      if (words_.take(word)) {
        return op;
      }
    }
    words_.fail("a comparison (= <> < <= > >= LIKE BETWEEN) is missing");
  }

  Operand operand() {
    const std::string word = words_.word();
    Operand result;
    if (!word.empty() && word.front() == '%') {
      const Value number = literal_of(word.substr(1));
      if (number.kind != Kind::integer || number.negative ||
          number.magnitude >= parameters_.size()) {
        words_.fail("there is no parameter " + word);
      }
      const std::string& given = parameters_[static_cast<size_t>(number.magnitude)];
      result.literal = literal_of(given);
      if (result.literal.kind == Kind::none) {
        words_.fail("parameter " + word + " is neither a number nor a text in quotes: " + given);
      }
    } else {
      result.literal = literal_of(word);
      if (result.literal.kind == Kind::none) {
        result = field(word);
      }
    }
    words_.next();
    return result;
  }

  /// `pose.position.x`, `ranges[3]`.
  Operand field(const std::string& path) {
    Operand result;
    const TypeInfo* type = &type_;
    for (size_t begin = 0; begin <= path.size();) {
      const size_t end = std::min(path.find('.', begin), path.size());
      const size_t bracket = std::min(path.find('[', begin), end);
      const std::string name = path.substr(begin, bracket - begin);
      begin = end + 1;
      ContentFilter::Step step;
      while (type != nullptr && step.field < type->field_count &&
             name != type->fields[step.field].name) {
        ++step.field;
      }
      if (type == nullptr || step.field == type->field_count) {
        words_.fail(std::string(type_.type_name) + " has no field \"" + path + "\"");
      }
      const FieldInfo& found = type->fields[step.field];
      if (has_elements(found) != (bracket < end)) {
        words_.fail("\"" + name + "\" " +
                    (bracket < end ? "has no elements" : "needs the number of an element"));
      }
      if (bracket < end) {
        step.element = static_cast<uint32_t>(std::strtoul(path.c_str() + bracket + 1, nullptr, 10));
      }
      result.path.push_back(step);
      result.literal.kind = kind_of(element_type(found));
      type = found.nested;
    }
    if (result.literal.kind == Kind::none) {
      words_.fail("\"" + path + "\" is neither a number nor a text");
    }
    return result;
  }

  const TypeInfo& type_;
  const std::vector<std::string>& parameters_;
  Words words_;
  std::vector<Node> nodes_;
};

}  // namespace

ContentFilter::ContentFilter(const TypeInfo& type, ContentFilterOptions options)
    : type_(type), options_(std::move(options)) {
  if (options_.expression_parameters.size() > kMostParameters) {
    throw std::invalid_argument("content filter: more than 100 parameters");
  }
  nodes_ = Parser(type_, options_).parse();
}

bool ContentFilter::passes(const uint8_t* bytes, size_t size) const {
  return holds(nodes_.size() - 1, bytes, size).value_or(false);
}

Truth ContentFilter::holds(size_t node, const uint8_t* bytes, size_t size) const {
  const Node& one = nodes_[node];
  switch (one.op) {
    case Operator::both:
    case Operator::either: {
      // The value with which one side alone decides the result.
      const bool deciding = one.op == Operator::either;
      const Truth left = holds(one.left, bytes, size);
      if (left == deciding) {
        return left;
      }
      const Truth right = holds(one.right, bytes, size);
      return right == deciding || left.has_value() ? right : left;
    }
    case Operator::negated: {
      const Truth inner = holds(one.left, bytes, size);
      return inner.has_value() ? Truth(!*inner) : inner;
    }
    default:
      return compare(one.op, value_of(one.first, bytes, size), value_of(one.second, bytes, size));
  }
}

/// None when the message has no such element.
Value ContentFilter::value_of(const Operand& operand, const uint8_t* bytes, size_t size) const {
  if (operand.path.empty()) {
    return operand.literal;
  }
  CdrReader reader(bytes, size);
  const TypeInfo* type = &type_;
  const FieldInfo* field = nullptr;
  for (const Step& step : operand.path) {
    for (size_t before = 0; before < step.field; ++before) {
      skip(reader, type->fields[before], count_elements(reader, type->fields[before]));
    }
    field = &type->fields[step.field];
    if (step.element >= count_elements(reader, *field)) {
      return {};
    }
    skip(reader, *field, step.element);
    type = field->nested;
  }
  Value value = read_value(reader, element_type(*field));
  return reader.ok() ? value : Value{};
}

}  // namespace detail
}  // namespace rclcpp
